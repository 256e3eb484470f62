#include "smt/cadical_solver.h"

#include <algorithm>
#include <cadical.hpp>
#include <climits>
#include <optional>

#include "smt/bit_blast.h"

namespace solitaire {
namespace {

/// What CaDiCaL's solve() says, else that it was stopped.
constexpr int kSatisfied = 10;
constexpr int kUnsatisfied = 20;

/// A search that takes suggested values first, whatever it learns, can take forever where things stand close.
constexpr int kConflictsFollowing = 300;

/// CaDiCaL asks all the time, so the clock is looked at only now and then.
class Stop : public CaDiCaL::Terminator {
 public:
  explicit Stop(const StopSignal& signal) : signal_(signal) {}

  bool terminate() override {
    if (calls_++ % 256 == 0 && signal_.stopped()) stopped_ = true;
    return stopped_;
  }

 private:
  const StopSignal& signal_;
  unsigned calls_ = 0;
  bool stopped_ = false;
};

class CadicalSolver : public Solver, private ClauseSink {
 public:
  CadicalSolver(const Graph& graph, const CadicalOptions& options)
      : graph_(graph), cnf_(circuit_, *this), blaster_(graph, circuit_, cnf_) {
    solver_.set("quiet", 1);
    solver_.set("seed", static_cast<int>(options.seed % 2'000'000'000));
    // Tried first, it would find the same solution whatever the seed and the suggestions.
    solver_.set("lucky", 0);
    solver_.set("stabilizeonly", 1);
    if (options.diverse) {
      // Else it would search around the assignment that came furthest, so around the last model.
      solver_.set("target", 0);
      // The search for a model near suggested values is short; what simplifying gains is lost with the next
      // clause. So it is done a tenth as often as CaDiCaL does by itself.
      solver_.set("elimint", 20'000);
      solver_.set("probeint", 50'000);
      solver_.set("subsumeint", 100'000);
    }
  }

  void add_clause(std::span<const NodeId> conditions) override {
    std::vector<Literal> literals;
    for (const NodeId condition : conditions) blaster_.add_alternatives(condition, literals);
    cnf_.add_clause(literals);
  }

  Verdict check(std::span<const NodeId> assumptions, const StopSignal& signal) override {
    std::vector<int> assumed;
    for (const NodeId assumption : assumptions) {
      assumed.push_back(cnf_.assumable(blaster_.condition(assumption)));
    }
    apply_suggestions();
    if (signal.stopped()) return Verdict::kStopped;
    switch (solve(signal, assumed)) {
      case kSatisfied:
        take_model();
        return Verdict::kSatisfiable;
      case kUnsatisfied:
        take_core(assumptions, assumed);
        return Verdict::kUnsatisfiable;
      default:
        return Verdict::kStopped;
    }
  }

  void limit_effort(std::uint64_t conflicts) override {
    effort_ = static_cast<int>(std::min<std::uint64_t>(conflicts, INT_MAX));
  }

  bool suggest(std::size_t variable, std::int64_t value) override {
    if (suggestions_.size() <= variable) suggestions_.resize(variable + 1);
    suggestions_[variable] = value;
    suggested_.push_back(variable);
    return true;
  }

  std::int64_t value(std::size_t variable) override {
    if (variable < model_.size()) return model_[variable];
    return free_value(variable);
  }

  std::vector<NodeId> core() override { return core_; }

 private:
  void clause(std::span<const int> literals) override {
    for (const int literal : literals) solver_.add(literal);
    solver_.add(0);
  }

  int solve(const StopSignal& signal, const std::vector<int>& assumed) {
    Stop stop(signal);
    solver_.connect_terminator(&stop);
    int status = 0;
    if (!following_.empty()) {
      status = solve_within(kConflictsFollowing, assumed);
      for (const int variable : following_) solver_.unphase(variable);
      following_.clear();
    }
    if (status == 0 && !signal.stopped()) status = solve_within(effort_, assumed);
    solver_.disconnect_terminator();
    return status;
  }

  int solve_within(int conflicts, const std::vector<int>& assumed) {
    for (const int literal : assumed) solver_.assume(literal);
    if (conflicts > 0) solver_.limit("conflicts", conflicts);  // of this call
    return solver_.solve();
  }

  /// Suggestions for choices that no condition has met yet wait.
  void apply_suggestions() {
    std::vector<std::size_t> waiting;
    for (const std::size_t variable : suggested_) {
      const std::span<const Literal> inputs = blaster_.choice_inputs(variable);
      if (inputs.empty()) waiting.push_back(variable);
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (is_constant(inputs[i])) continue;
        const int number = cnf_.variable(inputs[i]);
        following_.push_back(number);
        solver_.phase(blaster_.input_at(variable, i, *suggestions_[variable]) ? number : -number);
      }
    }
    suggested_ = std::move(waiting);
  }

  /// CaDiCaL forgets its model with the next clause.
  void take_model() {
    model_.resize(graph_.variables().size());
    const auto holds = [this](Literal input) { return this->holds(input); };
    for (std::size_t i = 0; i < model_.size(); ++i) {
      model_[i] = blaster_.choice_inputs(i).empty() ? free_value(i) : blaster_.decode(i, holds);
    }
  }

  /// Of a choice on which no condition depends, so that any of its values will do.
  std::int64_t free_value(std::size_t variable) const {
    const std::int64_t lowest = graph_.variables()[variable].domain.lo;
    return variable < suggestions_.size() ? suggestions_[variable].value_or(lowest) : lowest;
  }

  bool holds(Literal input) {
    const int number = is_constant(input) ? 0 : cnf_.known_variable(input);
    return number != 0 ? solver_.val(number) > 0 : input == kTrueLiteral;
  }

  void take_core(std::span<const NodeId> assumptions, const std::vector<int>& assumed) {
    core_.clear();
    for (std::size_t i = 0; i < assumed.size(); ++i) {
      if (solver_.failed(assumed[i])) core_.push_back(assumptions[i]);
    }
  }

  const Graph& graph_;
  CaDiCaL::Solver solver_;
  Circuit circuit_;
  Cnf cnf_;
  BitBlaster blaster_;
  std::vector<std::optional<std::int64_t>> suggestions_;  // by variable
  std::vector<std::size_t> suggested_;  // variables whose suggestions CaDiCaL does not know yet
  std::vector<std::int64_t> model_;     // by variable
  std::vector<NodeId> core_;
  int effort_ = 0;
  std::vector<int> following_;  // variables that take suggested values first
};

}  // namespace

std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, const CadicalOptions& options) {
  return std::make_unique<CadicalSolver>(graph, options);
}

}  // namespace solitaire
