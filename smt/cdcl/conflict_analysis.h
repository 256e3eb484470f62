#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "smt/cdcl/propagator.h"

namespace solitaire {

/// Finds out what is to be learned from a conflict. That is a clause which follows from the others; had it
/// been known, it would have assigned another value before the conflict was reached (the first unique
/// implication point; Marques-Silva and Sakallah 1996, Zhang et al. 2001).
class ConflictAnalysis {
 public:
  /// Analyzes the conflict of the last propagate(), which returned false while some decision was made.
  void analyze(const Propagator& propagator);

  /// Returns the learned clause, whose literals are all false at this time. Its first literal is the one that
  /// it will assign. No other literal was assigned later than the second one.
  std::span<const int> clause() const { return clause_; }
  /// Returns how many decisions can be kept so that the clause assigns its first literal.
  std::size_t decisions() const { return decisions_; }
  /// Returns the variables that had a part in the conflict.
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
