#include "smt/enumerator.h"

#include <algorithm>

#include "smt/bit_blast.h"
#include "smt/propagator.h"

namespace solitaire {
namespace {

/// Dead ends between two models after which a search that learns will do better.
constexpr std::uint64_t kMostDeadEnds = 50'000;

}  // namespace

class Enumerator::Search {
 public:
  Search(const Graph& graph, std::span<const NodeId> conditions, std::span<const std::size_t> choices)
      : cnf_(circuit_, propagator_), blaster_(graph, circuit_, cnf_) {
    for (const NodeId condition : conditions) {
      const Literal holds = blaster_.condition(condition);
      cnf_.add_clause({&holds, 1});
    }
    for (const std::size_t variable : choices) add_choice(variable);
  }

  Outcome next(const StopSignal& stop) {
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
        if (++dead_ends % 256 == 0 && stop.stopped()) return over_ = Outcome::kStopped;
        if (dead_ends > kMostDeadEnds) return over_ = Outcome::kTooHard;
        if (!turn_back()) return over_ = Outcome::kNone;
      }
    }
  }

  std::int64_t value(std::size_t variable) const {
    return blaster_.decode(variable, [this](Literal input) {
      if (is_constant(input)) return input == kTrueLiteral;
      return propagator_.value(cnf_.known_variable(input)) > 0;
    });
  }

 private:
  void add_choice(std::size_t variable) {
    std::vector<int>& inputs = choices_.emplace_back();
    for (const Literal input : blaster_.add_choice(variable)) {
      if (is_constant(input)) continue;
      inputs.push_back(cnf_.variable(input));
      propagator_.reserve(inputs.back());
    }
  }

  /// Turns the last decision round; false if there is none left.
  bool turn_back() {
    if (propagator_.decisions() == 0) return false;
    propagator_.assign(-propagator_.undo());
    return true;
  }

  /// That the choice with the fewest values left takes the lowest of them; 0 if all are decided.
  int next_decision() const {
    std::ptrdiff_t fewest = PTRDIFF_MAX;
    int decision = 0;
    for (const std::vector<int>& inputs : choices_) {
      const auto open = [this](int input) { return propagator_.is_open(input); };
      const std::ptrdiff_t count = std::count_if(inputs.begin(), inputs.end(), open);
      if (count == 0 || count >= fewest) continue;
      fewest = count;
      decision = -*std::find_if(inputs.begin(), inputs.end(), open);
    }
    return decision;
  }

  Circuit circuit_;
  Propagator propagator_;
  Cnf cnf_;
  BitBlaster blaster_;
  std::vector<std::vector<int>> choices_;  // the variables of each one's inputs
  Outcome over_ = Outcome::kFound;         // until it is
  bool at_model_ = false;
};

Enumerator::Enumerator(const Graph& graph, std::span<const NodeId> conditions,
                       std::span<const std::size_t> choices)
    : search_(std::make_unique<Search>(graph, conditions, choices)) {}

Enumerator::~Enumerator() = default;

Enumerator::Outcome Enumerator::next(const StopSignal& stop) { return search_->next(stop); }

std::int64_t Enumerator::value(std::size_t variable) const { return search_->value(variable); }

}  // namespace solitaire
