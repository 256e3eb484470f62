#include "solitaire/run/trace_reading.h"

#include <algorithm>

#include "solitaire/builtins/placing.h"
#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

bool values_under(Assignment& assignment, const std::vector<Value>& values, std::vector<Value>& made) {
  made.reserve(values.size());
  for (const Value& value : values) {
    std::optional<Value> one = value_under(assignment, value);
    if (!one) return false;
    made.push_back(std::move(*one));
  }
  return true;
}

std::optional<Value> scalar_under(Assignment& assignment, Symbol symbol) {
  const std::optional<Scalar> scalar = assignment.value(symbol.node);
  if (!scalar) return std::nullopt;
  switch (symbol.type) {
    case Type::kBool:
      return Value(scalar->i != 0);
    case Type::kInt:
      return Value(scalar->i);
    case Type::kFloat:
      break;
  }
  return Value(scalar->f);
}

/// Reads placements of one pass. It stands in for the evaluator that met them.
class SceneReader {
 public:
  SceneReader(const Program& program, AddressTable& addresses, Assignment& assignment)
      : assignment_(assignment),
        evaluator_(program, params_, choices_, nullptr, graph_, addresses, nullptr, limits_) {}

  std::optional<Placement> read(const SymbolicPlacement& symbolic) {
    std::vector<Value> arguments;
    if (!values_under(assignment_, symbolic.arguments, arguments)) return std::nullopt;
    std::vector<std::pair<std::string_view, Value>> extras;
    for (const auto& [name, value] : symbolic.extras) {
      std::optional<Value> known = value_under(assignment_, value);
      if (!known) return std::nullopt;
      extras.emplace_back(name, std::move(*known));
    }
    Placement made = read_placement(evaluator_, {arguments, *symbolic.site, extras});
    made.address = symbolic.placement.address;
    made.calls = symbolic.placement.calls;
    made.source = symbolic.placement.source;
    return made;
  }

 private:
  Assignment& assignment_;
  ParamValues params_;
  OpenChoices choices_;
  Graph graph_;
  Limits limits_;
  Evaluator evaluator_;
};

bool read_scene(const Program& program, const SymbolicPass& pass, AddressTable& addresses,
                Assignment& assignment, Execution& execution) {
  SceneReader reader(program, addresses, assignment);
  for (const TracePlaced& placed : pass.trace.placed) {
    if (!assignment.holds(placed.guard)) continue;
    std::optional<Placement> made = reader.read(pass.placements[placed.number]);
    if (!made) return false;
    execution.placements.push_back(std::move(*made));
  }
  return true;
}

/// Whether the execution comes to its end on the paths of the trace.
bool is_covered(const Trace& trace, Assignment& assignment) {
  const auto none = [&](const auto& effects) {
    return std::none_of(effects.begin(), effects.end(),
                        [&](const auto& effect) { return assignment.holds(effect.guard); });
  };
  return none(trace.blockers) && none(trace.program_errors) &&
         std::all_of(trace.asserts.begin(), trace.asserts.end(), [&](const TraceAssert& required) {
           return !assignment.holds(required.guard) || assignment.holds(required.condition);
         });
}

}  // namespace

std::optional<Value> value_under(Assignment& assignment, const Value& value) {
  if (const auto* symbol = value.get<Symbol>()) return scalar_under(assignment, *symbol);
  if (const List* list = value.as_list()) {
    std::vector<Value> items;
    if (!values_under(assignment, list->items, items)) return std::nullopt;
    return Value::list(std::move(items));
  }
  if (const auto* record = value.object<Record>()) {
    std::vector<Value> fields;
    if (!values_under(assignment, record->fields, fields)) return std::nullopt;
    return make_ref<Record>(record->type, std::move(fields));
  }
  if (const Union* several = value.as_union()) {
    for (const Union::Alternative& one : several->alternatives) {
      if (assignment.holds(one.guard)) return value_under(assignment, one.value);
    }
    return std::nullopt;
  }
  if (const auto* text = value.object<String>(); text != nullptr && text->opaque) return std::nullopt;
  return value;
}

std::optional<Execution> read_execution(const Program& program, const SymbolicPass& pass,
                                        AddressTable& addresses, Assignment& assignment, bool scene) {
  const Trace& trace = pass.trace;
  if (!pass.complete || !is_covered(trace, assignment)) return std::nullopt;
  Execution execution;
  execution.unit = pass.unit;
  for (const TraceChoice& choice : trace.choices) {
    if (!assignment.holds(choice.guard)) continue;
    execution.choices.push_back(
        {choice.address, choice.domain, choice.domain.typed(assignment.value(choice.variable)->i)});
  }
  for (const SoftConstraint& wish : trace.wishes) {
    if (!assignment.holds(wish.guard)) continue;
    const std::optional<Scalar> cost = assignment.value(wish.cost);
    if (!cost) return std::nullopt;
    execution.wishes.push_back({cost->i, wish.span, addresses.text(wish.address)});
    execution.cost += cost->i;
  }
  std::optional<Value> value = value_under(assignment, pass.value);
  if (!value || (scene && !read_scene(program, pass, addresses, assignment, execution))) return std::nullopt;
  execution.value = std::move(*value);
  return execution;
}

}  // namespace solitaire
