#include "smt/nearby_then_cadical.h"

#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "base/random.h"
#include "smt/cdcl/nearby_search.h"
#include "smt/sat/cadical.h"
#include "smt/sat/graph_clauses.h"
#include "smt/tuning.h"

namespace solitaire {
namespace {

class NearbyThenCadical : public Solver, private ClauseSink {
 public:
  NearbyThenCadical(const Graph& graph, const NearbyOptions& options)
      : graph_(graph),
        spread_(options.far_apart ? tuning::kFarApart : tuning::kUsualSpread),
        cadical_(Cadical::Use::kDiversity, options.seed),
        clauses_(graph, *this),
        nearby_(propagator_, clauses_, options.seed, spread_.searches_that_forget),
        random_(options.seed, Purpose::kSigns, 0) {}

  void add_clause(std::span<const NodeId> conditions) override { clauses_.add_clause(conditions); }

  Verdict check(std::span<const NodeId> assumptions, const StopSignal& signal) override {
    const std::vector<int> assumed = clauses_.assume(assumptions);
    if (signal.stopped()) return Verdict::kStopped;
    if (has_suggestions_ && found_nearby(assumed, signal)) return Verdict::kSatisfiable;
    const Verdict verdict = ask_cadical(assumed, signal);
    if (verdict == Verdict::kSatisfiable)
      model_ = clauses_.values([this](int variable) { return cadical_.holds(variable); });
    if (verdict == Verdict::kUnsatisfiable) core_ = cadical_.core(assumptions, assumed);
    return verdict;
  }

  void limit_effort(std::uint64_t conflicts) override { conflicts_ = conflicts; }

  bool suggest(std::size_t variable, std::int64_t value) override {
    nearby_.suggest(variable, value);
    return has_suggestions_ = true;
  }

  std::int64_t value(std::size_t variable) override {
    const auto value = variable < model_.size() ? model_[variable] : std::nullopt;
    if (value) return *value;
    return nearby_.suggestion(variable).value_or(
        graph_.variables()[variable].domain.lo);  // the choice may have any value
  }

  std::vector<NodeId> core() override { return core_; }

 private:
  void clause(std::span<const int> literals) override {
    propagator_.clause(literals);
    cadical_.clause(literals);
  }

  void order_implication(const OrderImplication& order_implication) override {
    propagator_.order_implication(order_implication);
    cadical_.order_implication(order_implication);
  }

  bool found_nearby(std::span<const int> assumed, const StopSignal& signal) {
    const bool found = nearby_.find(assumed, signal);
    if (found) model_ = clauses_.values([this](int variable) { return propagator_.value(variable) > 0; });
    nearby_.end();
    return found;
  }

  Verdict ask_cadical(std::span<const int> assumed, const StopSignal& signal) {
    if (std::exchange(has_suggestions_, false)) {
      cadical_.prefer(with_drawn_signs(nearby_.wanted()));
      const Verdict verdict = cadical_.solve(assumed, signal, tuning::kConflictsNearSuggestions);
      cadical_.prefer_nothing();
      if (verdict != Verdict::kStopped) return verdict;
    }
    return cadical_.solve(assumed, signal, conflicts_);
  }

  /// Adds random signs of some variables that stand for no choice, so that it is also left to chance which of
  /// several alternatives holds.
  std::vector<int> with_drawn_signs(std::vector<int> wanted) {
    std::vector<bool> is_wanted(static_cast<std::size_t>(clauses_.variables()) + 1);
    for (const int literal : wanted) is_wanted[static_cast<std::size_t>(std::abs(literal))] = true;
    for (int variable = 1; variable <= clauses_.variables(); ++variable) {
      if (is_wanted[static_cast<std::size_t>(variable)]) continue;
      if (random_.below(100) >= spread_.random_signs) continue;
      wanted.push_back(random_.below(2) == 0 ? variable : -variable);
    }
    return wanted;
  }

  const Graph& graph_;
  const tuning::Spread spread_;
  Cadical cadical_;
  Propagator propagator_;
  GraphClauses clauses_;
  NearbySearch nearby_;
  RandomStream random_;
  bool has_suggestions_ = false;  // there are suggestions that CaDiCaL has not followed yet
  std::vector<std::optional<std::int64_t>> model_;
  std::vector<NodeId> core_;
  std::uint64_t conflicts_ = 0;  // CaDiCaL gives up after so many; 0: it does not
};

}  // namespace

std::unique_ptr<Solver> make_nearby_then_cadical(const Graph& graph, const NearbyOptions& options) {
  return std::make_unique<NearbyThenCadical>(graph, options);
}

}  // namespace solitaire
