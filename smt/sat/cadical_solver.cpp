#include "smt/sat/cadical_solver.h"

#include <algorithm>
#include <cadical.hpp>
#include <climits>
#include <cstdlib>
#include <random>
#include <utility>

#include "smt/cdcl/nearby_search.h"
#include "smt/sat/bit_blast.h"

namespace solitaire {
namespace {

/// What CaDiCaL's solve() says, else that it was stopped.
constexpr int kSatisfied = 10;
constexpr int kUnsatisfied = 20;

/// A search that takes suggested values first, whatever it learns, can take forever where things stand close.
constexpr int kConflictsFollowing = 300;

/// What brings models apart, in percent.
struct Spread {
  unsigned forgets;  // searches near suggestions that forget what earlier ones met
  /// Variables that stand for no choice, and are tried by CaDiCaL with a random sign first where values are
  /// suggested: which of several alternatives holds is then drawn, too.
  unsigned random_signs;
};
constexpr Spread kUsual{12, 10};
constexpr Spread kFarApart{100, 100};

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

class CadicalSink : public ClauseSink {
 public:
  explicit CadicalSink(CaDiCaL::Solver& solver) : solver_(solver) {}

  void clause(std::span<const int> literals) override {
    for (const int literal : literals) solver_.add(literal);
    solver_.add(0);
  }

 private:
  CaDiCaL::Solver& solver_;
};

class CadicalSolver : public Solver, private ClauseSink {
 public:
  CadicalSolver(const Graph& graph, const CadicalOptions& options)
      : graph_(graph),
        options_(options),
        spread_(options.far_apart ? kFarApart : kUsual),
        cnf_(circuit_, *this),
        blaster_(graph, circuit_, cnf_),
        nearby_search_(propagator_, cnf_, blaster_, options.seed, spread_.forgets) {
    untold_.reserve(kUsualLiterals);
    untold_implications_.reserve(kUsualLiterals / 16);
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
    if (signal.stopped()) return Verdict::kStopped;
    if (search_nearby(assumed, signal)) return Verdict::kSatisfiable;
    tell_cadical();
    switch (solve(signal, assumed)) {
      case kSatisfied:
        take_model([this](int variable) { return solver_->val(variable) > 0; });
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
    if (!options_.diverse) return false;
    nearby_search_.suggest(variable, value);
    return has_suggestions_ = true;
  }

  std::int64_t value(std::size_t variable) override {
    if (variable < model_.size()) return model_[variable];
    return free_value(variable);
  }

  std::vector<NodeId> core() override { return core_; }

 private:
  void clause(std::span<const int> literals) override {
    if (options_.diverse) propagator_.clause(literals);
    untold_.insert(untold_.end(), literals.begin(), literals.end());
    untold_.push_back(0);
  }

  void order_implication(const OrderImplication& order_implication) override {
    if (options_.diverse) propagator_.order_implication(order_implication);
    untold_implications_.push_back(order_implication);
  }

  /// Whether a model was found without CaDiCaL.
  bool search_nearby(std::span<const int> assumed, const StopSignal& signal) {
    if (!has_suggestions_) return false;
    const bool found = nearby_search_.find(assumed, signal);
    if (found) take_model([this](int variable) { return propagator_.value(variable) > 0; });
    nearby_search_.end();
    return found;
  }

  /// It takes its time to be made, and is needed only where the search near suggestions gives up.
  void make_cadical() {
    solver_ = std::make_unique<CaDiCaL::Solver>();
    solver_->set("quiet", 1);
    solver_->set("seed", static_cast<int>(options_.seed % 2'000'000'000));
    // Tried first, it would find the same solution whatever the seed and the suggestions.
    solver_->set("lucky", 0);
    solver_->set("stabilizeonly", 1);
    if (options_.diverse) {
      // Else it would search around the assignment that came furthest, so around the last model.
      solver_->set("target", 0);
      // The search for a model near suggested values is short; what simplifying gains is lost with the next
      // clause. So it is done a tenth as often as CaDiCaL does by itself.
      solver_->set("elimint", 20'000);
      solver_->set("probeint", 50'000);
      solver_->set("subsumeint", 100'000);
      // As solutions are asked for one after the other, what was learned is worth keeping for a while.
      solver_->set("reduceint", 1'000);
    }
  }

  void tell_cadical() {
    if (solver_ == nullptr) make_cadical();
    for (const int literal : untold_) solver_->add(literal);
    CadicalSink sink(*solver_);
    for (const OrderImplication& order_implication : untold_implications_)
      sink.order_implication(order_implication);
    untold_.clear();
    untold_implications_.clear();
    if (!std::exchange(has_suggestions_, false)) return;
    following_ = nearby_search_.wanted();
    draw_signs();
    for (const int literal : following_) solver_->phase(literal);
  }

  /// Of variables that do not follow a suggestion.
  void draw_signs() {
    std::vector<bool> follows(static_cast<std::size_t>(cnf_.variables()) + 1);
    for (const int literal : following_) follows[static_cast<std::size_t>(std::abs(literal))] = true;
    for (int variable = 1; variable <= cnf_.variables(); ++variable) {
      if (follows[static_cast<std::size_t>(variable)]) continue;
      const std::uint64_t drawn = random_();
      if (drawn / 2 % 100 < spread_.random_signs) following_.push_back(drawn % 2 == 0 ? variable : -variable);
    }
  }

  int solve(const StopSignal& signal, const std::vector<int>& assumed) {
    Stop stop(signal);
    solver_->connect_terminator(&stop);
    int status = 0;
    if (!following_.empty()) {
      status = solve_within(kConflictsFollowing, assumed);
      for (const int literal : following_) solver_->unphase(literal);
      following_.clear();
    }
    if (status == 0 && !signal.stopped()) status = solve_within(effort_, assumed);
    solver_->disconnect_terminator();
    return status;
  }

  int solve_within(int conflicts, const std::vector<int>& assumed) {
    for (const int literal : assumed) solver_->assume(literal);
    if (conflicts > 0) solver_->limit("conflicts", conflicts);  // of this call
    return solver_->solve();
  }

  /// `value`: of a variable of the clauses.
  template <class Value>
  void take_model(Value value) {
    model_.resize(graph_.variables().size());
    const auto holds = [&](Literal input) {
      const int number = is_constant(input) ? 0 : cnf_.known_variable(input);
      return number != 0 ? value(number) : input == kTrueLiteral;
    };
    for (std::size_t i = 0; i < model_.size(); ++i) {
      model_[i] = blaster_.choice_inputs(i).empty() ? free_value(i) : blaster_.decode(i, holds);
    }
  }

  /// Of a choice on which no condition depends, so that any of its values will do.
  std::int64_t free_value(std::size_t variable) const {
    return nearby_search_.suggestion(variable).value_or(graph_.variables()[variable].domain.lo);
  }

  void take_core(std::span<const NodeId> assumptions, const std::vector<int>& assumed) {
    core_.clear();
    for (std::size_t i = 0; i < assumed.size(); ++i) {
      if (solver_->failed(assumed[i])) core_.push_back(assumptions[i]);
    }
  }

  const Graph& graph_;
  const CadicalOptions options_;
  const Spread spread_;
  std::unique_ptr<CaDiCaL::Solver> solver_;
  Propagator propagator_;
  Circuit circuit_;
  Cnf cnf_;
  BitBlaster blaster_;
  NearbySearch nearby_search_;
  std::mt19937_64 random_{options_.seed};
  bool has_suggestions_ = false;  // that CaDiCaL does not know yet
  std::vector<int> untold_;       // clauses that CaDiCaL does not know yet, each ended by 0
  std::vector<OrderImplication> untold_implications_;
  std::vector<int> following_;       // literals that CaDiCaL tries first
  std::vector<std::int64_t> model_;  // by variable
  std::vector<NodeId> core_;
  int effort_ = 0;
};

}  // namespace

std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, const CadicalOptions& options) {
  return std::make_unique<CadicalSolver>(graph, options);
}

}  // namespace solitaire
