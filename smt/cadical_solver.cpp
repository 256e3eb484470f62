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
    for (const int literal : assumed) solver_.assume(literal);
    switch (solve(signal)) {
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

  int solve(const StopSignal& signal) {
    Stop stop(signal);
    solver_.connect_terminator(&stop);
    if (effort_ > 0) solver_.limit("conflicts", effort_);  // of this call
    const int status = solver_.solve();
    solver_.disconnect_terminator();
    return status;
  }

  /// Suggestions for choices that no condition has met yet wait.
  void apply_suggestions() {
    std::vector<std::size_t> waiting;
    for (const std::size_t variable : suggested_) {
      const std::span<const Literal> bits = blaster_.choice_bits(variable);
      if (bits.empty()) waiting.push_back(variable);
      const std::uint64_t wanted = blaster_.bits_of(variable, *suggestions_[variable]);
      for (std::size_t i = 0; i < bits.size(); ++i) {
        if (is_constant(bits[i])) continue;
        const int number = cnf_.variable(bits[i]);
        solver_.phase(((wanted >> i) & 1) != 0 ? number : -number);
      }
    }
    suggested_ = std::move(waiting);
  }

  /// CaDiCaL forgets its model with the next clause.
  void take_model() {
    model_.resize(graph_.variables().size());
    for (std::size_t i = 0; i < model_.size(); ++i) {
      const std::span<const Literal> bits = blaster_.choice_bits(i);
      model_[i] = bits.empty() ? free_value(i) : blaster_.decode(i, value_of(bits));
    }
  }

  /// Of a choice on which no condition depends, so that any of its values will do.
  std::int64_t free_value(std::size_t variable) const {
    const std::int64_t lowest = graph_.variables()[variable].domain.lo;
    return variable < suggestions_.size() ? suggestions_[variable].value_or(lowest) : lowest;
  }

  std::uint64_t value_of(std::span<const Literal> bits) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const int number = is_constant(bits[i]) ? 0 : cnf_.known_variable(bits[i]);
      const bool holds = number != 0 ? solver_.val(number) > 0 : bits[i] == kTrueLiteral;
      if (holds) value |= std::uint64_t{1} << i;
    }
    return value;
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
};

}  // namespace

std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, const CadicalOptions& options) {
  return std::make_unique<CadicalSolver>(graph, options);
}

}  // namespace solitaire
