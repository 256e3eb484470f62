#include "engines/solve/executions/exclusion.h"

#include <algorithm>
#include <utility>

#include "base/hash.h"
#include "engines/errors.h"
#include "engines/seen.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

std::uint64_t hash_of(const Valuation& values) {
  std::uint64_t hash = values.size();
  for (const auto& [address, value] : values)
    hash = mix(mix(hash, address.index), std::hash<TypedScalar>{}(value));
  return hash;
}

}  // namespace

Exclusion::Exclusion(ExecutionSolver& solver, const TracingOptions& options)
    : solver_(solver),
      method_(*options.method),
      diverse_(options.diverse),
      relax_(options.relax),
      apart_(options.apart) {}

void Exclusion::add(Valuation values) {
  by_hash_.emplace(hash_of(key(values)), known_.size());
  known_.push_back({std::move(values), {}});
}

bool Exclusion::tells_at_once() const {
  const bool best_first = relax_ || solver_.trace().has_costs();
  return apart_ != Apart::kChoices || !diverse_ || method_.excludes_at_once() || best_first ||
         tuning::kRepeatsWorthTelling * repeated_ > known_.size() + tuning::kFewKnown;
}

void Exclusion::tell_last() {
  if (tells_at_once()) tell(known_.back());
}

void Exclusion::tell_all() {
  for (Known& known : known_) tell(known);
}

void Exclusion::find_auxiliary() {
  std::unordered_set<AddressId> auxiliary = auxiliary_choices(solver_.trace());
  if (auxiliary == auxiliary_) return;
  auxiliary_ = std::move(auxiliary);
  by_hash_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i) by_hash_.emplace(hash_of(key(known_[i].values)), i);
}

void Exclusion::meet_pass() {
  find_auxiliary();
  const bool all = tells_at_once();
  for (Known& known : known_) {
    if (all || known.differs) tell(known);
  }
}

bool Exclusion::repeats(const Valuation& model) {
  const Valuation shown = key(model);
  const auto [begin, end] = by_hash_.equal_range(hash_of(shown));
  const auto found =
      std::find_if(begin, end, [&](const auto& entry) { return key(known_[entry.second].values) == shown; });
  if (found == end) return false;
  Known& known = known_[found->second];
  if (known.differs) throw InternalError("a model repeats a solution that is excluded");
  tell(known);
  ++repeated_;
  if (tells_at_once()) tell_all();
  return true;
}

void Exclusion::tell(Known& known) {
  const Stopwatch watch(solver_.times().encode);
  Assignment assignment = assignment_of(solver_.graph(), known.values);
  const TracedChoices met = solver_.met(assignment);
  if (!met.complete) return;  // it cannot be found yet
  std::vector<NodeId> differs = difference(met, assignment);
  if (known.differs == differs) return;
  solver_.add_clause(differs);
  known.differs = std::move(differs);
}

/// Returns conditions, of which each solution that is another one fulfils at least one.
std::vector<NodeId> Exclusion::difference(const TracedChoices& met, Assignment& assignment) {
  if (says_what_is_seen(solver_.pass(), apart_)) {
    // What is seen of an execution that leaves the paths explored so far is not known.
    std::vector<NodeId> differs = something_else(solver_.graph(), solver_.pass(), apart_, assignment);
    if (const NodeId unexplored = solver_.unexplored(); unexplored != kFalse) differs.push_back(unexplored);
    return differs;
  }
  Valuation values;
  std::vector<NodeId> variables;
  std::size_t i = 0;
  for (const auto& [address, value] : met.values) {
    const NodeId variable = met.variables[i++];
    if (auxiliary_.count(address) != 0) continue;
    values.emplace(address, value);
    variables.push_back(variable);
  }
  return method_.difference(solver_.graph(), solver_.trace(), values, variables);
}

std::vector<NodeId> Exclusion::conditions() {
  std::vector<NodeId> conditions;
  for (const Known& known : known_) {
    if (!known.differs) continue;
    NodeId differs = kFalse;
    for (const NodeId one : *known.differs) differs = solver_.graph().disjunction(differs, one);
    conditions.push_back(differs);
  }
  return conditions;
}

Assignment assignment_of(const Graph& graph, const Valuation& values, bool* possible) {
  return {graph, [&graph, &values, possible](std::size_t number) {
            const ChoiceVariable& variable = graph.variables()[number];
            const auto value = values.find(variable.address);
            if (value == values.end()) return Scalar::of(variable.domain.lo);
            if (possible != nullptr && !variable.domain.contains(value->second)) *possible = false;
            return value->second.scalar();
          }};
}

}  // namespace solitaire
