#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "smt/sat/literal_table.h"

namespace solitaire {

/// Keeps what is known of ints in order encoding. Such an int is a chain of literals, one for each of its
/// values but the lowest, and the literals up to the int's value hold. So two bounds describe what is known
/// of it: the last literal that holds, and the first one that does not.
class OrderChains {
 public:
  struct Chain {
    std::span<const int> literals;
    std::uint32_t reached = 0;  // one more than the last place whose literal holds: the lowest value left
    std::uint32_t limit = 0;    // the first place whose literal does not hold: the highest value left

    bool is_decided() const { return reached == limit; }
  };
  struct Place {
    std::uint32_t chain, position;
  };

  /// Returns the number of a chain, which it gets when it is first asked for. The literals stay where they
  /// are.
  std::uint32_t number(const std::vector<int>* literals);
  /// Makes the tables, for variables below `variables`. No chain is added later.
  void build(std::size_t variables);

  const Chain& operator[](std::uint32_t number) const { return chains_[number]; }
  std::size_t size() const { return chains_.size(); }
  /// Returns where a literal stands in chains.
  std::span<const Place> places(int literal) const { return places_.of(literal); }

  /// Takes note that the literal at a place holds, or that it does not. Returns true if that changes a bound.
  bool raise(Place place);
  bool lower(Place place);

  /// Returns how often a bound was changed. undo_last() takes back the last change, and returns the chain as
  /// it was before it was taken back, with its number.
  std::size_t changes() const { return changed_.size(); }
  std::pair<std::uint32_t, Chain> undo_last();

 private:
  /// The bounds that a chain had before a change.
  struct Bounds {
    std::uint32_t chain, reached, limit;
  };

  std::unordered_map<const std::vector<int>*, std::uint32_t> numbers_;
  std::vector<Chain> chains_;
  LiteralTable<Place> places_;
  std::vector<Bounds> changed_;
};

}  // namespace solitaire
