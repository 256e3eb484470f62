#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "smt/cdcl/propagator.h"
#include "smt/cdcl/tournament.h"

namespace solitaire {

/// Keeps the choices of a formula for a depth-first search: it knows which values of each are still open,
/// which choice to decide next, and how to go back (chronological backtracking; Grumberg, Schuster and Yadgar
/// 2004). It neither adds clauses against what it has left behind nor learns any.
///
/// How many inputs of each choice are open is counted as the propagator assigns them and takes them back, so
/// that a decision takes time by what has changed, and not by the number of choices.
class ChoiceSearch {
 public:
  explicit ChoiceSearch(Propagator& propagator) : propagator_(propagator) {}

  /// Adds a choice, which is given by the inputs that stand for it.
  void add(std::span<const Literal> inputs, Cnf& cnf);
  std::span<const int> inputs(std::size_t choice) const { return choices_[choice]; }

  /// Returns the choice to decide next, which is the one with the fewest values left, or nothing if all are
  /// decided.
  std::optional<std::size_t> next();
  /// Replaces the last decision by its negation. Returns false if there is none.
  bool turn_back();

 private:
  static constexpr std::uint32_t kNoChoice = UINT32_MAX;

  void catch_up();
  void count(int variable, int opened);

  Propagator& propagator_;
  std::vector<std::vector<int>> choices_;  // the inputs of each
  std::vector<std::uint32_t> choice_of_;   // by variable
  std::vector<int> counted_;               // the variables of the trail up to which inputs are counted
  std::vector<std::size_t> open_;          // by choice: how many of its inputs are open
  std::vector<std::uint32_t> changed_;     // choices whose count has changed, some of them several times
  Tournament fewest_open_;                 // of choices that have open inputs
};

}  // namespace solitaire
