#include "kernel/score_program.h"

#include <algorithm>
#include <map>

#include "kernel/combination.h"
#include "kernel/few.h"
#include "kernel/known_forms.h"
#include "kernel/normal_block.h"
#include "tracegraph/density.h"

namespace solitaire {
namespace {

NodeId guarded(Graph& graph, NodeId guard, NodeId term) {
  return guard == kTrue ? term : graph.phi(guard, term, graph.constant(0.0));
}

/// Returns true if the values of the choice are few, and the same in all executions: then nobody proposes
/// another one.
bool has_fixed_values(const Graph& graph, const TraceChoice& choice) {
  return choice.domain.is_finite() && (!choice.domain.weights.empty() || has_fixed_parameters(graph, choice));
}

void add_choice(Graph& graph, const TraceChoice& choice, Demands& demands) {
  if (!has_fixed_values(graph, choice))
    demands.required.push_back(graph.implication(
        choice.guard, in_support(graph, choice.domain, choice.parameters, choice.variable)));
  const NodeId density = log_density(graph, choice.domain, choice.parameters, choice.variable);
  demands.terms.push_back(guarded(graph, choice.guard, density));
}

void add_soft_term(Graph& graph, const Term& term, Demands& demands) {
  NodeId log_weight = term.node;
  if (term.strength == Term::Strength::kCost)
    log_weight = graph.apply(Op::kNegFloat, {graph.apply(Op::kToFloat, {term.node})});
  demands.terms.push_back(guarded(graph, term.guard, log_weight));
}

Demands demands_of(Graph& graph, const Trace& trace, std::span<const NodeId> path) {
  Demands demands;
  for (const TraceChoice& choice : trace.choices) add_choice(graph, choice, demands);
  for (const Term& term : trace.soft_terms) add_soft_term(graph, term, demands);
  for (const Term& term : trace.hard_terms)
    demands.required.push_back(graph.implication(term.guard, term.node));
  demands.assumed.assign(path.begin(), path.end());
  return demands;
}

/// Numbers nodes as cells.
class Cells {
 public:
  Cells(const Graph& graph, ScoreProgram& program)
      : graph_(graph), program_(program), cell_of_(graph.size(), kNoCell), live_(graph.size(), false) {}

  void need(std::span<const NodeId> nodes) {
    for (const NodeId node : nodes) live_[node.index] = true;
  }

  /// Gives cells to all that is needed and has none yet, and writes the code that makes them. Nodes are made
  /// after their operands, so one pass down finds what is needed and one up writes it.
  void write(std::vector<Instruction>& code) {
    for (std::size_t i = graph_.size(); i-- > 0;)
      if (live_[i]) need(graph_.node({static_cast<std::uint32_t>(i)}).args());
    for (std::uint32_t i = 0; i < graph_.size(); ++i) {
      if (!live_[i] || cell_of_[i] != kNoCell) continue;
      const Graph::Node& node = graph_.node({i});
      cell_of_[i] = add_cell(node, {i});
      if (node.args().empty()) continue;
      Instruction made(node.op, cell_of_[i], {});
      for (std::size_t k = 0; k < node.args().size(); ++k) made.operands[k] = of(node.args()[k]);
      code.push_back(made);
    }
  }

  Cell of(NodeId node) const { return cell_of_[node.index]; }
  std::vector<Cell> of(std::span<const NodeId> nodes) const {
    std::vector<Cell> cells;
    for (const NodeId node : nodes) cells.push_back(of(node));
    return cells;
  }

 private:
  Cell add_cell(const Graph::Node& node, NodeId id) {
    program_.cells.push_back(node.is_constant() ? graph_.scalar(id) : Scalar{});
    program_.types.push_back(node.type());
    return static_cast<Cell>(program_.cells.size() - 1);
  }

  const Graph& graph_;
  ScoreProgram& program_;
  std::vector<Cell> cell_of_;
  std::vector<bool> live_;
};

/// Constants that hold are left out, and each node is kept once.
std::vector<NodeId> open_conditions(std::vector<NodeId> conditions) {
  std::sort(conditions.begin(), conditions.end(), [](NodeId a, NodeId b) { return a.index < b.index; });
  conditions.erase(std::unique(conditions.begin(), conditions.end()), conditions.end());
  std::erase(conditions, kTrue);
  return conditions;
}

/// Takes constant terms out and returns their sum.
double take_constants(const Graph& graph, std::vector<NodeId>& terms) {
  double sum = 0;
  for (const NodeId term : terms)
    if (graph.node(term).is_constant()) sum += graph.scalar(term).f;
  std::erase_if(terms, [&](NodeId term) { return graph.node(term).is_constant(); });
  return sum;
}

/// Terms that depend on the same choices, of which there are few.
class AlikeTerms {
 public:
  AlikeTerms(const Graph& graph, const std::vector<NodeId>& terms) : choices_(graph.size()) {
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
      const Graph::Node& node = graph.node({i});
      if (is_choice(node.op)) choices_[i].add(i);
      for (const NodeId operand : node.args()) choices_[i].add(choices_[operand.index]);
    }
    for (const NodeId term : terms) add(term);
  }

  /// In the order of their first terms.
  const std::vector<std::vector<NodeId>>& groups() const { return groups_; }

 private:
  void add(NodeId term) {
    const Few& choices = choices_[term.index];
    std::vector<std::uint32_t> key(choices.begin(), choices.end());
    std::sort(key.begin(), key.end());
    if (choices.many()) key.push_back(term.index);
    const auto [found, is_new] = group_of_.try_emplace(key, groups_.size());
    if (is_new) groups_.emplace_back();
    groups_[found->second].push_back(term);
  }

  std::vector<Few> choices_;  // on which each node depends
  std::map<std::vector<std::uint32_t>, std::size_t> group_of_;
  std::vector<std::vector<NodeId>> groups_;
};

/// Terms that depend on the same choices change together, so that their sum takes their place, in which what
/// they have in common is computed once.
std::vector<NodeId> sums_of_alike(Graph& graph, const std::vector<NodeId>& terms) {
  const AlikeTerms alike_terms(graph, terms);
  std::vector<NodeId> sums;
  for (const std::vector<NodeId>& alike : alike_terms.groups()) {
    Combination sum;
    for (const NodeId term : alike) sum.add(Combination(graph, term));
    sum.settle();
    if (alike.size() > 1 && sum.is_finite() && !sum.is_number()) {
      sums.push_back(sum.node(graph));
    } else {
      sums.insert(sums.end(), alike.begin(), alike.end());
    }
  }
  return sums;
}

}  // namespace

ScoreProgram score_program(Graph& graph, const Trace& trace, std::span<const NodeId> path,
                           std::span<const NodeId> outputs, Forms wanted) {
  Demands demands = demands_of(graph, trace, path);
  ScoreProgram program;
  program.constant = take_constants(graph, demands.terms);
  demands.required = open_conditions(std::move(demands.required));
  demands.assumed = open_conditions(std::move(demands.assumed));
  std::vector<NodeId> numbers;
  for (const double number : kSlopeNumbers) numbers.push_back(graph.constant(number));
  std::vector<KnownForm> forms(trace.choices.size());
  if (wanted == Forms::kFound) forms = known_forms(graph, trace, demands);
  const NormalBlock block = normal_block(graph, trace, forms);
  demands.terms = sums_of_alike(graph, demands.terms);
  Cells cells(graph, program);
  for (const std::vector<NodeId>* needed : {&demands.terms, &demands.required, &demands.assumed})
    cells.need(*needed);
  for (const TraceChoice& choice : trace.choices) {
    cells.need(std::span(&choice.variable, 1));
    cells.need(choice.parameters);
  }
  cells.need(numbers);
  cells.write(program.code);
  for (const KnownForm& form : forms) {
    cells.need(form.numbers);
    cells.need(form.required);
  }
  cells.need(block.mixed);
  cells.write(program.form_code);
  program.block = {block.choices, cells.of(block.mixed)};
  program.slope_numbers = cells.of(numbers);
  program.terms = cells.of(demands.terms);
  program.required = cells.of(demands.required);
  program.assumed = cells.of(demands.assumed);
  for (std::size_t i = 0; i < trace.choices.size(); ++i) {
    const TraceChoice& choice = trace.choices[i];
    const bool open = is_choice(graph.node(choice.variable).op);
    const Scalar only = open ? Scalar{} : graph.scalar(choice.variable);
    program.choices.push_back({open ? cells.of(choice.variable) : kNoCell, choice.address,
                               has_fixed_parameters(graph, choice), forms[i].form, choice.domain,
                               cells.of(choice.parameters), only, cells.of(forms[i].numbers),
                               cells.of(forms[i].required)});
  }
  cells.need(outputs);
  cells.write(program.output_code);
  program.outputs = cells.of(outputs);
  return program;
}

}  // namespace solitaire
