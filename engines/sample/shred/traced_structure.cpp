#include "engines/sample/shred/traced_structure.h"

#include "engines/sample/state_choices.h"
#include "solitaire/value/merge.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire {
namespace {

/// The nodes of the numbers in a value, in the order in which ReturnedNumbers reads them.
void collect_numbers(Graph& graph, const Value& value, std::vector<NodeId>& nodes) {
  if (value.is<bool>() || value.is_number()) {
    nodes.push_back(node_of(graph, value));
  } else if (const List* list = value.as_list()) {
    for (const Value& item : list->items) collect_numbers(graph, item, nodes);
  } else if (const Record* record = value.object<Record>()) {
    for (const Value& field : record->fields) collect_numbers(graph, field, nodes);
  }
}

}  // namespace

TracedStructure trace_structure(const Program& program, const ParamValues& params, const SampledState& state,
                                AddressTable& addresses, const Limits& limits,
                                const ReturnedNumbers& returned) {
  Graph graph;
  StateChoices choices(state);
  TracedExecution traced = trace_execution(program, params, choices, graph, addresses, limits);
  std::vector<NodeId> path;
  for (const PathCondition& condition : traced.path) path.push_back(condition.holds);
  std::vector<NodeId> numbers;
  collect_numbers(graph, traced.execution.value, numbers);
  Kernel kernel(score_program(graph, traced.trace, path, numbers));
  std::vector<std::string> names;
  std::vector<double> values;
  returned.read(plain(traced.execution.value), names, values);
  const bool branches = !kernel.program().assumed.empty();
  return {std::move(kernel), std::move(names), branches, {}, {}};
}

bool TracedStructure::load(const SampledState& state) {
  const auto& choices = kernel.program().choices;
  if (choices.size() != state.choices.size()) return false;
  std::vector<Scalar> values;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const MetChoice& choice = state.choices[i];
    if (choices[i].address != choice.address) return false;
    if (choices[i].distribution.type() != choice.value.type()) return false;
    values.push_back(choice.value.scalar());
  }
  return kernel.load(values) == Kernel::Outcome::kScored;
}

SampledState state_of(const Kernel& kernel) {
  SampledState state;
  for (ChoiceNumber i = 0; i < kernel.program().choices.size(); ++i) {
    MetChoice choice;
    choice.address = kernel.program().choices[i].address;
    choice.domain = kernel.distribution(i);
    choice.value = TypedScalar(choice.domain.type(), kernel.value(i));
    state.log_priors.push_back(choice.domain.log_density(choice.value));
    state.log_prior += state.log_priors.back();
    state.choices.push_back(std::move(choice));
  }
  state.log_weight = kernel.log_score() - state.log_prior;
  return state;
}

double log_prior(const Kernel& kernel, ChoiceNumber choice) {
  const Distribution distribution = kernel.distribution(choice);
  return distribution.log_density(TypedScalar(distribution.type(), kernel.value(choice)));
}

}  // namespace solitaire
