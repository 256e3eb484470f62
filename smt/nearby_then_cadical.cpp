#include "smt/nearby_then_cadical.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
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

using Model = std::vector<std::optional<std::int64_t>>;  // the values of the choices, where they have any

/// Returns the share of choices in which two models differ. Choices that one of them lacks count as
/// different.
double distance(const Model& a, const Model& b) {
  const std::size_t all = std::max(a.size(), b.size());
  std::size_t differ = all - std::min(a.size(), b.size());
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) differ += a[i] != b[i] ? 1 : 0;
  return static_cast<double>(differ) / static_cast<double>(std::max<std::size_t>(all, 1));
}

/// Remembers the last models, and says which others are much nearer to one of them than they are to each
/// other.
class LastModels {
 public:
  /// What is nearer than `share` percent of their mean distance is near.
  explicit LastModels(unsigned share) : share_(share / 100.0) {}

  void add(const Model& model) {
    for (const Model& earlier : models_) distances_ += distance(model, earlier);
    pairs_ += models_.size();
    models_.push_back(model);
    if (models_.size() > tuning::kModelsToLeave) models_.pop_front();
  }

  bool is_near(const Model& model) const {
    const double usual = pairs_ == 0 ? 1 : distances_ / static_cast<double>(pairs_);
    return std::ranges::any_of(
        models_, [&](const Model& earlier) { return distance(model, earlier) < share_ * usual; });
  }

 private:
  double share_;
  std::deque<Model> models_;
  double distances_ = 0;  // summed over all pairs that were remembered at a time
  std::size_t pairs_ = 0;
};

class NearbyThenCadical : public Solver, private ClauseSink {
 public:
  NearbyThenCadical(const Graph& graph, const NearbyOptions& options)
      : graph_(graph),
        options_(options),
        spread_(options.far_apart ? tuning::kFarApart : tuning::kUsualSpread),
        cadical_(Cadical::Use::kRefutation, options.seed),
        clauses_(graph, *this),
        nearby_(propagator_, clauses_, options.seed, spread_.searches_that_forget),
        random_(options.seed, Purpose::kSigns, 0),
        last_models_(spread_.near_models) {}

  void add_clause(std::span<const NodeId> conditions) override { clauses_.add_clause(conditions); }

  Verdict check(std::span<const NodeId> assumptions, const StopSignal& signal) override {
    const std::vector<int> assumed = clauses_.assume(assumptions);
    if (signal.stopped()) return Verdict::kStopped;
    if (has_suggestions_ && found_nearby(assumed, signal)) return Verdict::kSatisfiable;
    const bool had_suggestions = has_suggestions_;
    const Verdict verdict = ask_cadical(assumed, signal);
    if (verdict == Verdict::kSatisfiable) {
      model_ = cadical_model();
      if (had_suggestions) leave_last_models(assumed, signal);
      last_models_.add(model_);
    }
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

  void order_difference(const OrderDifference& difference) override {
    propagator_.order_difference(difference);
    cadical_.order_difference(difference);
  }

  bool takes_linear_implications() const override { return propagator_.takes_linear_implications(); }

  /// CaDiCaL gets their clauses when it is first asked.
  void linear_implication(const LinearImplication& implication) override {
    propagator_.linear_implication(implication);
  }

  bool found_nearby(std::span<const int> assumed, const StopSignal& signal) {
    const bool found = nearby_.find(assumed, signal);
    if (found) model_ = clauses_.values([this](int variable) { return propagator_.value(variable) > 0; });
    nearby_.end();
    return found;
  }

  Verdict ask_cadical(std::span<const int> assumed, const StopSignal& signal) {
    clauses_.cnf().write_linear_as_clauses();
    if (std::exchange(has_suggestions_, false)) {
      cadical_.use_for(Cadical::Use::kDiversity);
      cadical_.prefer(with_drawn_signs(nearby_.wanted()));
      const Verdict verdict = cadical_.solve(assumed, signal, options_.conflicts_near_suggestions);
      cadical_.prefer_nothing();
      if (verdict != Verdict::kStopped) return verdict;
    }
    if (conflicts_ == 0 && ends_help_) {
      const Verdict verdict = search_from_ends(assumed, signal);
      if (verdict != Verdict::kStopped || signal.stopped()) return verdict;
    }
    return cadical_.solve(assumed, signal, conflicts_);
  }

  /// Goes CaDiCaL's own way for a while, then begins anew with all literals true, so that ints in order
  /// encoding have their greatest values, and with all of them false, or the other way round. Random values
  /// can lead a search to where it takes hundreds of times as long. If neither end helps once, that is not
  /// tried again.
  Verdict search_from_ends(std::span<const int> assumed, const StopSignal& signal) {
    Verdict verdict = cadical_.solve(assumed, signal, options_.conflicts_of_one_way);
    for (const bool phase : {first_end_, !first_end_}) {
      if (verdict != Verdict::kStopped || signal.stopped()) return verdict;
      cadical_.start_anew(random_.next(), phase);
      verdict = cadical_.solve(assumed, signal, options_.conflicts_of_one_way);
    }
    ends_help_ = verdict != Verdict::kStopped;
    return verdict;
  }

  /// Begins anew, from the same suggestions, as long as the model is one near those of before, and not too
  /// often: a search that has to go its own way returns to where it ended before. Where all models are near
  /// each other that is in vain, and is tried more and more rarely. Each time the other end of the ranges is
  /// the one that is tried first, as searches from one end end near each other.
  void leave_last_models(std::span<const int> assumed, const StopSignal& signal) {
    if (conflicts_ > 0 || !last_models_.is_near(model_)) return;
    if (checks_to_skip_ > 0) {
      --checks_to_skip_;
      return;
    }
    for (unsigned i = 0; i < tuning::kNewBeginnings && last_models_.is_near(model_); ++i) {
      cadical_.start_anew(random_.next());
      first_end_ = !first_end_;
      has_suggestions_ = true;
      if (ask_cadical(assumed, signal) != Verdict::kSatisfiable) return;
      model_ = cadical_model();
    }
    in_vain_ = last_models_.is_near(model_) ? in_vain_ + 1 : 0;
    checks_to_skip_ = (1U << std::min(in_vain_, 20U)) - 1;
  }

  Model cadical_model() const {
    return clauses_.values([this](int variable) { return cadical_.holds(variable); });
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
  const NearbyOptions options_;
  const tuning::Spread spread_;
  Cadical cadical_;
  Propagator propagator_;
  GraphClauses clauses_;
  NearbySearch nearby_;
  RandomStream random_;
  bool has_suggestions_ = false;  // there are suggestions that CaDiCaL has not followed yet
  Model model_;
  LastModels last_models_;  // that CaDiCaL found
  unsigned in_vain_ = 0;    // so many times in a row no new beginning led away from earlier models
  unsigned checks_to_skip_ = 0;
  bool first_end_ = true;  // all literals are true first, then false
  bool ends_help_ = true;  // to begin at the ends of the ranges has not been in vain
  std::vector<NodeId> core_;
  std::uint64_t conflicts_ = 0;  // CaDiCaL gives up after so many; 0: it does not
};

}  // namespace

std::unique_ptr<Solver> make_nearby_then_cadical(const Graph& graph, const NearbyOptions& options) {
  return std::make_unique<NearbyThenCadical>(graph, options);
}

}  // namespace solitaire
