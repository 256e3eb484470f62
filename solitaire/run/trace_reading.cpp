#include "solitaire/run/trace_reading.h"

#include <algorithm>

#include "solitaire/builtins/placing.h"
#include "solitaire/value/elements.h"
#include "solitaire/value/merge.h"

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

std::optional<Value> joined_under(Assignment& assignment, const Joined& joined) {
  std::vector<Value> parts;
  if (!values_under(assignment, joined.parts, parts)) return std::nullopt;
  std::string text;
  for (const Value& part : parts) text += part.object<String>()->text;
  return Value::string(std::move(text));
}

std::optional<Placement> read(const SymbolicPlacement& symbolic, Assignment& assignment) {
  std::vector<Value> arguments;
  if (!values_under(assignment, symbolic.arguments, arguments)) return std::nullopt;
  std::vector<std::pair<std::string_view, Value>> extras;
  for (const auto& [name, value] : symbolic.extras) {
    std::optional<Value> known = value_under(assignment, value);
    if (!known) return std::nullopt;
    extras.emplace_back(name, std::move(*known));
  }
  Placement made = read_placement({arguments, *symbolic.site, extras});
  made.id = symbolic.placement.id;
  made.span = symbolic.placement.span;
  made.call = symbolic.placement.call;
  return made;
}

bool read_scene(const SymbolicPass& pass, Assignment& assignment, Execution& execution) {
  for (const TracePlaced& placed : pass.trace.placed) {
    if (!assignment.holds(placed.guard)) continue;
    std::optional<Placement> made = read(pass.placements[placed.number], assignment);
    if (!made) return false;
    execution.placements.push_back(std::move(*made));
  }
  execution.calls = pass.calls;
  return true;
}

/// Returns the element that a list of the pass has at a position; Unset if it has none there.
std::optional<Value> element_under(Assignment& assignment, const Value& list, std::int64_t position) {
  if (const Union* several = list.as_union()) {
    for (const Union::Alternative& one : several->alternatives) {
      if (assignment.holds(one.guard)) return element_under(assignment, one.value, position);
    }
    return std::nullopt;
  }
  if (!list.is_list()) return Value();
  const Elements elements(list);
  if (elements.packed()) {
    const auto at = static_cast<std::size_t>(position);
    const bool has_it = at < elements.size() && assignment.holds(elements.guard(at));
    return has_it ? value_under(assignment, elements.value(at)) : Value();
  }
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (assignment.holds(elements.guard(i)) && position-- == 0)
      return value_under(assignment, elements.value(i));
  }
  return Value();
}

Type type_of(const Value& scalar) {
  if (scalar.has_type(Type::kBool)) return Type::kBool;
  return scalar.has_type(Type::kInt) ? Type::kInt : Type::kFloat;
}

/// Returns true if the execution comes to its end on the paths of the trace.
bool is_covered(const Trace& trace, Assignment& assignment) {
  const auto none = [&](const auto& effects) {
    return std::none_of(effects.begin(), effects.end(),
                        [&](const auto& effect) { return assignment.holds(effect.guard); });
  };
  return none(trace.blockers) && none(trace.program_errors) &&
         std::all_of(trace.hard_terms.begin(), trace.hard_terms.end(), [&](const Term& required) {
           return !assignment.holds(required.guard) || assignment.holds(required.node);
         });
}

}  // namespace

std::optional<Value> value_under(Assignment& assignment, const Value& value) {
  if (const auto* symbol = value.get<Symbol>()) return scalar_under(assignment, *symbol);
  if (value.traced()) return scalar_under(assignment, {value.node(), type_of(value)});
  if (const List* list = value.as_list()) {
    std::vector<Value> items;
    if (!values_under(assignment, list->items, items)) return std::nullopt;
    return Value::list(std::move(items));
  }
  if (const auto* list = value.object<ChosenList>()) {
    std::vector<Value> items;
    for (const auto& [guard, element] : list->elements) {
      if (!assignment.holds(guard)) continue;
      std::optional<Value> item = value_under(assignment, element);
      if (!item) return std::nullopt;
      items.push_back(std::move(*item));
    }
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
  if (const Joined* joined = value.object<Joined>()) return joined_under(assignment, *joined);
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
    const std::int64_t answer = assignment.value(choice.variable)->i;
    execution.choices.push_back(
        {choice.address, choice.domain, choice.domain.typed(answer), {}, choice.auxiliary});
    if (choice.list >= pass.lists.size()) continue;
    std::optional<Value> element = element_under(assignment, pass.lists[choice.list], answer);
    if (!element) return std::nullopt;
    execution.choices.back().element = std::move(*element);
  }
  for (const Term& term : trace.soft_terms) {
    if (term.strength != Term::Strength::kCost || !assignment.holds(term.guard)) continue;
    const std::optional<Scalar> cost = assignment.value(term.node);
    if (!cost) return std::nullopt;
    execution.wishes.push_back({cost->i, term.span, "", term.address});
    execution.cost += cost->i;
  }
  std::optional<Value> value = value_under(assignment, pass.value);
  if (!value || (scene && !read_scene(pass, assignment, execution))) return std::nullopt;
  execution.value = std::move(*value);
  add_texts(execution, program, addresses);
  return execution;
}

}  // namespace solitaire
