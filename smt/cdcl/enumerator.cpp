#include "smt/cdcl/enumerator.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "smt/cdcl/choice_search.h"
#include "smt/cdcl/conflict_analysis.h"
#include "smt/sat/bit_blast.h"
#include "smt/tuning.h"

namespace solitaire {
class Enumerator::Search {
 public:
  Search(const Graph& graph, std::span<const NodeId> conditions, std::span<const std::size_t> choices)
      : choices_(choices.begin(), choices.end()),
        search_(propagator_),
        cnf_(circuit_, propagator_),
        blaster_(graph, circuit_, cnf_) {
    for (const NodeId condition : conditions) blaster_.require(condition);
    for (const std::size_t variable : choices_) {
      blaster_.choices().add(variable);
      search_.add(blaster_.choices().inputs(variable), cnf_);
    }
  }

  Outcome next(const StopSignal& stop, std::uint64_t most_dead_ends) {
    if (over_ != Outcome::kFound) return over_;
    if (stop.stopped()) return over_ = Outcome::kStopped;
    if (at_model_ && !turn_back()) return over_ = Outcome::kNone;
    at_model_ = false;
    std::uint64_t dead_ends = 0;
    while (true) {
      if (propagator_.propagate()) {
        const int literal = next_decision();
        if (literal == 0) {
          at_model_ = true;
          return Outcome::kFound;
        }
        propagator_.decide(literal);
      } else {
        if (!suggested_.empty()) failed_ = decided_;
        if (++dead_ends % tuning::kDeadEndsPerLook == 0 && stop.stopped()) return over_ = Outcome::kStopped;
        if (dead_ends > most_dead_ends) return over_ = Outcome::kTooHard;
        const bool learns = !suggested_.empty() || dead_ends > tuning::kDeadEndsToLearn;
        if (!(learns ? leave_dead_end() : turn_back())) return over_ = Outcome::kNone;
      }
    }
  }

  void begin_near(const std::function<std::int64_t(std::size_t)>& value_of) {
    while (propagator_.decisions() > 0) propagator_.undo();
    suggested_.assign(propagator_.variables(), false);
    for (const std::size_t variable : choices_) {
      const auto inputs = blaster_.choices().inputs(variable);
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (is_constant(inputs[i])) continue;
        suggested_[static_cast<std::size_t>(cnf_.variable(inputs[i]))] =
            blaster_.choices().input_at(variable, i, value_of(variable));
      }
    }
    over_ = Outcome::kFound;
  }

  std::int64_t value(std::size_t variable) const {
    return blaster_.choices().decode(variable, [this](Literal input) {
      if (is_constant(input)) return input == kTrueLiteral;
      return propagator_.value(cnf_.known_variable(input)) > 0;
    });
  }

 private:
  /// Replaces the last decision by its negation. Returns false if there is none.
  bool turn_back() {
    if (!search_.turn_back()) return false;
    turned_ = propagator_.decisions();
    return true;
  }

  /// Learns from a conflict, and takes back the decisions that had no part in it, but none below which models
  /// were found.
  bool leave_dead_end() {
    if (propagator_.decisions() <= turned_ || propagator_.learned() >= tuning::kMostLearned)
      return turn_back();
    analysis_.analyze(propagator_);
    const std::size_t kept = std::max(analysis_.decisions(), turned_);
    while (propagator_.decisions() > kept) propagator_.undo();
    propagator_.learn(analysis_.clause());
    return true;
  }

  /// Returns a literal to decide next, or 0 if all choices are decided.
  int next_decision() {
    if (failed_ && decision(*failed_) == 0) failed_.reset();  // it stands in the way no more
    decided_ = failed_ ? failed_ : search_.next();
    return decided_ ? decision(*decided_) : 0;
  }

  /// Returns a literal that says that a choice takes its suggested value, or comes as near to it as an input
  /// can say; without suggestions, that it takes the lowest of its values. Returns 0 if it is decided.
  int decision(std::size_t choice) const {
    int decided = 0;
    for (const int input : search_.inputs(choice)) {
      if (propagator_.is_open(input) && (decided == 0 || is_suggested(input))) decided = input;
    }
    return is_suggested(decided) ? decided : -decided;
  }

  bool is_suggested(int variable) const {
    return !suggested_.empty() && suggested_[static_cast<std::size_t>(variable)];
  }

  std::vector<std::size_t> choices_;
  Circuit circuit_;
  Propagator propagator_;
  ChoiceSearch search_;
  ConflictAnalysis analysis_;
  std::optional<std::size_t> decided_, failed_;  // the choice decided last, and that before the last dead end
  std::size_t turned_ = 0;  // so many decisions stood when one was last replaced by its negation
  Cnf cnf_;
  BitBlaster blaster_;
  Outcome over_ = Outcome::kFound;  // how the enumeration ended; kFound while it goes on
  bool at_model_ = false;
  std::vector<bool> suggested_;  // by variable of the propagator: whether it is to be tried as true first
};

Enumerator::Enumerator(const Graph& graph, std::span<const NodeId> conditions,
                       std::span<const std::size_t> choices)
    : search_(std::make_unique<Search>(graph, conditions, choices)) {}

Enumerator::~Enumerator() = default;

Enumerator::Outcome Enumerator::next(const StopSignal& stop, std::uint64_t most_dead_ends) {
  return search_->next(stop, most_dead_ends);
}

void Enumerator::begin_near(const std::function<std::int64_t(std::size_t)>& value_of) {
  search_->begin_near(value_of);
}

std::int64_t Enumerator::value(std::size_t variable) const { return search_->value(variable); }

}  // namespace solitaire
