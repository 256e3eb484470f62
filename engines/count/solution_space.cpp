#include "engines/count/solution_space.h"

#include <algorithm>
#include <numeric>

#include "engines/errors.h"
#include "engines/solve/executions/auxiliary.h"
#include "engines/solve/executions/exclusion.h"
#include "smt/cdcl/enumerator.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// Sets of numbers that are merged (Galler and Fischer 1964).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0); }

  std::size_t find(std::size_t member) {
    while (parents_[member] != member) member = parents_[member] = parents_[parents_[member]];
    return member;
  }
  void merge(std::size_t a, std::size_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parents_;
};

/// Puts nodes into one set if a condition depends on both.
DisjointSets tied_nodes(const Graph& graph, const std::vector<NodeId>& conditions) {
  DisjointSets sets(graph.size());
  for (const NodeId node : nodes_below(graph, conditions)) {
    for (const NodeId operand : graph.node(node).args()) {
      if (!graph.node(operand).is_constant()) sets.merge(node.index, operand.index);
    }
  }
  return sets;
}

}  // namespace

struct SpacePart::Compiled {
  Circuit circuit;
  ProjectedModels models;
  Cnf cnf{circuit, models};
  BitBlaster blaster;

  explicit Compiled(const Graph& graph) : blaster(graph, circuit, cnf) {}
};

SpacePart::SpacePart(const Graph& graph, std::vector<std::size_t> variables, std::vector<NodeId> conditions)
    : graph_(&graph), variables_(std::move(variables)), conditions_(std::move(conditions)) {}

std::optional<std::uint64_t> SpacePart::free_values() const {
  if (variables_.size() != 1 || !conditions_.empty()) return std::nullopt;
  const Distribution& domain = graph_->variables()[variables_.front()].domain;
  return domain.size();
}

std::int64_t SpacePart::free_value(std::uint64_t number) const {
  const Distribution& domain = graph_->variables()[variables_.front()].domain;
  return domain.value(number);
}

const ProjectedModels& SpacePart::models() {
  if (compiled_) return compiled_->models;
  const auto compiled = std::make_shared<Compiled>(*graph_);
  for (const NodeId condition : conditions_) compiled->blaster.require(condition);
  std::vector<int> projection;
  for (const std::size_t variable : variables_) {
    compiled->blaster.choices().add(variable);
    for (const Literal bit : compiled->blaster.choices().bits(variable)) {
      if (!is_constant(bit)) projection.push_back(compiled->cnf.equivalent(bit));
    }
  }
  compiled->models.project_on(std::move(projection));
  compiled_ = compiled;
  return compiled_->models;
}

std::optional<std::uint64_t> SpacePart::enumerate(std::uint64_t most, const StopSignal& stop,
                                                  std::atomic<std::uint64_t>& found) const {
  Enumerator enumerator(*graph_, conditions_, variables_);
  for (found = 0; found < most; ++found) {
    switch (enumerator.next(stop)) {
      case Enumerator::Outcome::kFound:
        break;
      case Enumerator::Outcome::kNone:
        return found;
      case Enumerator::Outcome::kStopped:
        throw Interrupted{};
      case Enumerator::Outcome::kTooHard:
        return std::nullopt;
    }
  }
  return found;
}

std::optional<NestedSampler> SpacePart::nested_sampler(RandomStream random, const StopSignal& stop,
                                                       const NestedLimits& limits) const {
  auto clusters = Clusters::of(*graph_, variables_, conditions_, limits.most_in_cluster);
  if (!clusters) return std::nullopt;
  return NestedSampler::prepared(ClusterNetwork(*graph_, std::move(*clusters)), random, stop,
                                 limits.most_cases_kept);
}

void SpacePart::decode(const BitModel& model, VariableValues& values) const {
  std::size_t position = 0;
  for (const std::size_t variable : variables_) {
    const Bits bits = compiled_->blaster.choices().bits(variable);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bits.size(); ++i) {
      const bool holds = is_constant(bits[i]) ? bits[i] == kTrueLiteral : model[position++];
      if (holds) number |= std::uint64_t{1} << i;
    }
    values[variable] = compiled_->blaster.choices().decode(variable, number);
  }
}

SolutionSpace::SolutionSpace(TracedProgram& program)
    : graph_(program.graph()),
      addresses_(program.addresses()),
      meeting_(meeting_conditions(program.graph(), program.trace())),
      auxiliary_(auxiliary_variables(program.graph(), program.trace())) {
  std::vector<NodeId> conditions = program.requirements(true);
  const std::vector<NodeId> fixed = fixed_unmet_choices(program.graph(), meeting_);
  conditions.insert(conditions.end(), fixed.begin(), fixed.end());
  const std::vector<NodeId>& implied = program.solver().implied();
  conditions.insert(conditions.end(), implied.begin(), implied.end());
  conditions = conjuncts(graph_, std::move(conditions));
  DisjointSets sets = tied_nodes(graph_, conditions);
  std::map<std::size_t, std::pair<std::vector<std::size_t>, std::vector<NodeId>>> parts;
  for (const auto& [variable, condition] : meeting_) {
    if (auxiliary_.count(variable) == 0)
      parts[sets.find(graph_.variable_node(variable).index)].first.push_back(variable);
  }
  for (const NodeId condition : conditions) parts[sets.find(condition.index)].second.push_back(condition);
  for (auto& [set, part] : parts) parts_.emplace_back(graph_, std::move(part.first), std::move(part.second));
}

void SolutionSpace::join(const std::vector<std::size_t>& numbers) {
  std::vector<std::size_t> variables;
  std::vector<NodeId> conditions;
  std::vector<SpacePart> others;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const SpacePart& part = parts_[i];
    if (std::find(numbers.begin(), numbers.end(), i) == numbers.end()) {
      others.push_back(part);
      continue;
    }
    variables.insert(variables.end(), part.variables().begin(), part.variables().end());
    conditions.insert(conditions.end(), part.conditions().begin(), part.conditions().end());
  }
  parts_ = std::move(others);
  parts_.emplace_back(graph_, std::move(variables), std::move(conditions));
}

VariableValues SolutionSpace::lowest() const {
  VariableValues values;
  for (const ChoiceVariable& variable : graph_.variables()) values.push_back(variable.domain.lo);
  return values;
}

VariableValues SolutionSpace::values_of(const ChosenValues& choices) const {
  Valuation known;
  for (const ChosenValue& choice : choices) known.emplace(addresses_.address(choice.address), choice.value);
  Assignment assignment = assignment_of(graph_, known);
  VariableValues values = lowest();
  for (const auto& [variable, condition] : meeting_) {
    if (auxiliary_.count(variable) == 0 && assignment.holds(condition))
      values[variable] = assignment.value(graph_.variable_node(variable))->i;
  }
  return values;
}

}  // namespace solitaire
