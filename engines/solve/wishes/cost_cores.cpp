#include "engines/solve/wishes/cost_cores.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <unordered_set>
#include <utility>

#include "engines/solve/conclusions/linear_sum.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

bool is_worth_it(const LinearSum& sum) {
  const auto is_fine = [](const LinearSum::Term& term) {
    return term.range.hi - term.range.lo <= tuning::kMostStepsOfCost;
  };
  return sum.terms().size() >= tuning::kManyCosts && std::ranges::all_of(sum.terms(), is_fine);
}

/// Counts how far a term is above the least that it can come to.
std::unique_ptr<Tally> tally_of(Graph& graph, const LinearSum::Term& term) {
  const bool grows = term.factor > 0;
  if (graph.node(term.node).type() == Type::kBool)
    return Tally::of({grows ? term.node : graph.negation(term.node)});
  std::vector<NodeId> reached;
  for (std::int64_t i = 0; i <= term.range.hi - term.range.lo; ++i) {
    const NodeId end = graph.constant(grows ? term.range.lo + i : term.range.hi - i);
    reached.push_back(grows ? graph.apply(Op::kLeInt, {end, term.node})
                            : graph.apply(Op::kLeInt, {term.node, end}));
  }
  return std::make_unique<Tally>(std::move(reached));
}

}  // namespace

std::optional<CostCores> CostCores::of(Graph& graph, NodeId cost) {
  LinearSum sum(graph);
  if (!sum.add(cost, 1) || !is_worth_it(sum)) return std::nullopt;
  CostCores cores(graph, sum.constant());
  for (const LinearSum::Term& term : sum.terms()) {
    if (term.factor == 0) continue;
    cores.least_ += term.factor * (term.factor > 0 ? term.range.lo : term.range.hi);
    cores.add(tally_of(graph, term), 1, std::abs(term.factor));
  }
  cores.want_more();
  return cores;
}

void CostCores::add(std::unique_ptr<Tally> tally, std::size_t number, std::int64_t weight) {
  tallies_.push_back(std::move(tally));
  add(*tallies_.back(), number, weight);
}

void CostCores::add(Tally& tally, std::size_t number, std::int64_t weight) {
  if (number > tally.most()) return;
  const NodeId unpaid = graph_->negation(tally.at_least(*graph_, number));
  const auto known = std::ranges::find(costs_, unpaid, &Cost::unpaid);
  if (known != costs_.end() && known->tally == &tally) {
    known->weight += weight;
  } else {
    costs_.push_back({&tally, number, unpaid, weight});
  }
}

std::vector<NodeId> CostCores::wanted() const {
  std::vector<NodeId> wanted;
  for (const Cost& cost : costs_) {
    if (cost.weight >= stratum_) wanted.push_back(cost.unpaid);
  }
  return wanted;
}

bool CostCores::wants_all() const {
  return std::ranges::all_of(costs_, [&](const Cost& cost) { return cost.weight >= stratum_; });
}

void CostCores::want_more() {
  std::int64_t next = 0;
  for (const Cost& cost : costs_) {
    if (stratum_ == 0 || cost.weight < stratum_) next = std::max(next, cost.weight);
  }
  stratum_ = next;
}

bool CostCores::raise(std::span<const NodeId> core) {
  const std::unordered_set<NodeId> in_core(core.begin(), core.end());
  const auto is_in_core = [&](const Cost& cost) {
    return cost.weight >= stratum_ && in_core.count(cost.unpaid) != 0;
  };
  const auto middle = std::stable_partition(costs_.begin(), costs_.end(), std::not_fn(is_in_core));
  const std::vector<Cost> paid(middle, costs_.end());
  if (paid.empty()) return false;
  costs_.erase(middle, costs_.end());
  const std::int64_t weight = std::ranges::min(paid, {}, &Cost::weight).weight;
  least_ += weight;
  std::vector<NodeId> conditions;
  for (const Cost& cost : paid) {
    conditions.push_back(graph_->negation(cost.unpaid));
    if (cost.weight > weight) costs_.push_back({cost.tally, cost.number, cost.unpaid, cost.weight - weight});
  }
  for (const Cost& cost : paid) add(*cost.tally, cost.number + 1, weight);
  if (paid.size() > 1) add(Tally::of(conditions), 2, weight);
  return true;
}

}  // namespace solitaire
