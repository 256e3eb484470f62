#pragma once
#include <optional>
#include <span>
#include <vector>

#include "smt/cdcl/propagator.h"

namespace solitaire {

/// The choices of a formula as a depth-first search sees them: what is open of each, which one to decide
/// next, and the way back (chronological backtracking; Grumberg, Schuster and Yadgar 2004). It needs no
/// clause for what it has left behind, and learns none.
class ChoiceSearch {
 public:
  explicit ChoiceSearch(Propagator& propagator) : propagator_(propagator) {}

  /// A choice, by the inputs that stand for it.
  void add(std::span<const Literal> inputs, Cnf& cnf);
  std::span<const int> inputs(std::size_t choice) const { return choices_[choice]; }

  /// The choice to decide next, which is the one with the fewest values left; nothing if all are decided.
  std::optional<std::size_t> next() const;
  /// Turns the last decision round; false if there is none.
  bool turn_back();

 private:
  std::size_t count_open(std::size_t choice, std::size_t bound) const;

  Propagator& propagator_;
  std::vector<std::vector<int>> choices_;
};

}  // namespace solitaire
