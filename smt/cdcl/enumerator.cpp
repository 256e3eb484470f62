#include "smt/cdcl/enumerator.h"

#include <algorithm>

#include "smt/cdcl/choice_search.h"
#include "smt/sat/bit_blast.h"
#include "smt/tuning.h"

namespace solitaire {
class Enumerator::Search {
 public:
  Search(const Graph& graph, std::span<const NodeId> conditions, std::span<const std::size_t> choices)
      : search_(propagator_), cnf_(circuit_, propagator_), blaster_(graph, circuit_, cnf_) {
    for (const NodeId condition : conditions) {
      const Literal holds = blaster_.condition(condition);
      cnf_.add_clause({&holds, 1});
    }
    for (const std::size_t variable : choices) {
      blaster_.choices().add(variable);
      search_.add(blaster_.choices().inputs(variable), cnf_);
    }
  }

  Outcome next(const StopSignal& stop) {
    if (over_ != Outcome::kFound) return over_;
    if (stop.stopped()) return over_ = Outcome::kStopped;
    if (at_model_ && !search_.turn_back()) return over_ = Outcome::kNone;
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
        if (++dead_ends % tuning::kDeadEndsPerLook == 0 && stop.stopped()) return over_ = Outcome::kStopped;
        if (dead_ends > tuning::kMostDeadEnds) return over_ = Outcome::kTooHard;
        if (!search_.turn_back()) return over_ = Outcome::kNone;
      }
    }
  }

  std::int64_t value(std::size_t variable) const {
    return blaster_.choices().decode(variable, [this](Literal input) {
      if (is_constant(input)) return input == kTrueLiteral;
      return propagator_.value(cnf_.known_variable(input)) > 0;
    });
  }

 private:
  /// Returns a literal that says that a choice takes the lowest of its values, or 0 if all choices are
  /// decided.
  int next_decision() {
    const auto choice = search_.next();
    if (!choice) return 0;
    const auto inputs = search_.inputs(*choice);
    return -*std::ranges::find_if(inputs, [this](int input) { return propagator_.is_open(input); });
  }

  Circuit circuit_;
  Propagator propagator_;
  ChoiceSearch search_;
  Cnf cnf_;
  BitBlaster blaster_;
  Outcome over_ = Outcome::kFound;  // how the enumeration ended; kFound while it goes on
  bool at_model_ = false;
};

Enumerator::Enumerator(const Graph& graph, std::span<const NodeId> conditions,
                       std::span<const std::size_t> choices)
    : search_(std::make_unique<Search>(graph, conditions, choices)) {}

Enumerator::~Enumerator() = default;

Enumerator::Outcome Enumerator::next(const StopSignal& stop) { return search_->next(stop); }

std::int64_t Enumerator::value(std::size_t variable) const { return search_->value(variable); }

}  // namespace solitaire
