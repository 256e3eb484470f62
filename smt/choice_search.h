#pragma once
#include <optional>
#include <span>
#include <vector>

#include "smt/propagator.h"

namespace solitaire {

/// The choices of a formula as a depth-first search sees them: what is open of each, which one to decide
/// next, and the way back (chronological backtracking; Grumberg, Schuster and Yadgar 2004). It needs no
/// clause for what it has left behind, and learns none.
class ChoiceSearch {
 public:
  explicit ChoiceSearch(Propagator& propagator) : propagator_(propagator) {}

  /// A choice, by the variables of the inputs that stand for it.
  void add(std::vector<int> inputs);
  std::span<const int> inputs(std::size_t choice) const { return choices_[choice]; }

  enum class Order : std::uint8_t {
    kFirstFail,  // the one with the fewest values left
    kAsAdded,    // the one that was added first
  };
  /// The choice to decide next; nothing if all are decided.
  std::optional<std::size_t> next(Order order) const;
  /// Turns the last decision round; false if only the first `kept` are left.
  bool turn_back(std::size_t kept = 0);

 private:
  bool is_open(std::size_t choice) const;
  std::optional<std::size_t> first_fail() const;

  Propagator& propagator_;
  std::vector<std::vector<int>> choices_;
};

}  // namespace solitaire
