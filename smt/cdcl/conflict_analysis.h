#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "smt/cdcl/propagator.h"

namespace solitaire {

/// What is to be learned from a conflict: a clause that the others imply and that, had it been known, would
/// have assigned another value before it came to the conflict (the first unique implication point; Marques-
/// Silva and Sakallah 1996, Zhang et al. 2001).
class ConflictAnalysis {
 public:
  /// After propagate() returned false with a decision made.
  void analyze(const Propagator& propagator);

  /// The clause, false as yet. Its first literal is the one that it will assign; of the others none was
  /// assigned later than the second one.
  std::span<const int> clause() const { return clause_; }
  /// How many decisions can be kept so that the clause assigns its first literal.
  std::size_t decisions() const { return decisions_; }
  /// The variables that had a part in the conflict.
  std::span<const int> variables() const { return met_; }

 private:
  bool is_met(int variable) const { return is_met_[static_cast<std::size_t>(variable)] != 0; }
  void collect(const Propagator& propagator);
  void meet(const Propagator& propagator, int falsified);
  void shorten(const Propagator& propagator);
  bool follows_from_others(const Propagator& propagator, int falsified) const;

  std::vector<int> clause_;
  std::size_t decisions_ = 0;
  std::vector<int> met_;
  std::vector<char> is_met_;     // by variable
  std::size_t met_at_last_ = 0;  // variables assigned since the last decision that are still to be replaced
};

}  // namespace solitaire
