#include "engines/seen.h"

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "engines/distinct.h"
#include "solitaire/value/chosen_list.h"
#include "solitaire/value/elements.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// The number of place()'s first arguments that decide what a thing looks like.
constexpr std::size_t kLookArguments = 6;

/// Collects conditions by which a value is another one than under an assignment.
class Difference {
 public:
  Difference(Graph& graph, const Trace& trace, Assignment& assignment)
      : graph_(graph), trace_(trace), assignment_(assignment) {}

  void value(const Value& value) {
    if (const auto* symbol = value.get<Symbol>()) return node(symbol->node);
    if (const List* list = value.as_list()) return all(list->items);
    if (value.is<ChosenList>()) return list(packed(graph_, value));
    if (const auto* record = value.object<Record>()) return all(record->fields);
    if (const auto* text = value.object<Joined>()) return all(text->parts);
    const Union* several = value.as_union();
    if (several == nullptr) return;
    for (const Union::Alternative& each : several->alternatives) {
      if (!assignment_.holds(each.guard)) continue;
      add(graph_.negation(each.guard));
      return this->value(each.value);
    }
  }

  void all(std::span<const Value> values) {
    for (const Value& each : values) value(each);
  }

  void placed(NodeId guard, std::span<const Value> look) {
    if (!assignment_.holds(guard)) return add(guard);
    add(graph_.negation(guard));
    all(look);
  }

  std::vector<NodeId> take() { return std::move(conditions_); }

 private:
  /// Of packed lists: another length, or another element where there is one.
  void list(const Value& packed) {
    const Elements elements(packed);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const NodeId guard = elements.guard(i);
      if (!assignment_.holds(guard)) return add(guard);
      add(graph_.negation(guard));
      value(elements.value(i));
    }
  }

  void add(NodeId condition) {
    if (condition != kFalse) conditions_.push_back(condition);
  }

  void node(NodeId node) {
    if (graph_.node(node).is_constant()) return;
    if (!graph_.node(node).has_float) return other(node);
    // Solvers know no floats; where one differs, a choice differs of which it is made. The first such choice
    // is one that this execution meets, too; of others, the values say nothing.
    for (const std::size_t variable : variables_below(graph_, {&node, 1})) {
      const NodeId chosen = graph_.variable_node(variable);
      if (is_met(chosen)) other(chosen);
    }
  }

  bool is_met(NodeId variable) {
    if (!met_) {
      met_.emplace();
      for (const TraceChoice& choice : trace_.choices)
        if (assignment_.holds(choice.guard)) met_->insert(choice.variable);
    }
    return met_->contains(variable);
  }

  void other(NodeId node) {
    const std::int64_t value = assignment_.value(node)->i;
    if (graph_.node(node).type() == Type::kBool) return add(value != 0 ? graph_.negation(node) : node);
    add(graph_.negation(graph_.apply(Op::kEqInt, {node, graph_.constant(value)})));
  }

  Graph& graph_;
  const Trace& trace_;
  Assignment& assignment_;
  std::optional<std::unordered_set<NodeId>>
      met_;  // the variables of the choices that are met, once asked for
  std::vector<NodeId> conditions_;
};

}  // namespace

bool is_sayable(const Value& value) {
  const auto all = [](const std::vector<Value>& values) { return std::ranges::all_of(values, is_sayable); };
  if (const List* list = value.as_list()) return all(list->items);
  if (const auto* list = value.object<ChosenList>()) {
    return std::ranges::all_of(list->elements,
                               [](const GuardedElement& each) { return is_sayable(each.value); });
  }
  if (const auto* record = value.object<Record>()) return all(record->fields);
  if (const auto* text = value.object<String>()) return !text->opaque;
  if (const auto* text = value.object<Joined>()) return all(text->parts);
  if (const Union* several = value.as_union()) {
    return std::ranges::all_of(several->alternatives,
                               [](const Union::Alternative& each) { return is_sayable(each.value); });
  }
  return !value.is_function();
}

std::vector<Value> look_arguments(const SymbolicPlacement& placement) {
  const std::span<const Value> all = placement.arguments;
  const std::span<const Value> first = all.first(std::min(all.size(), kLookArguments));
  std::vector<Value> looks(first.begin(), first.end());
  for (const auto& [name, value] : placement.extras) {
    if (is_look(name)) looks.push_back(value);
  }
  return looks;
}

bool says_what_is_seen(const SymbolicPass& pass, Apart apart) {
  if (apart == Apart::kChoices || !is_sayable(pass.value)) return false;
  if (apart == Apart::kValue) return true;
  return !pass.has_output && std::ranges::all_of(pass.trace.placed, [&](const TracePlaced& placed) {
    return std::ranges::all_of(look_arguments(pass.placements[placed.number]), is_sayable);
  });
}

bool chooses_names(const SymbolicPass& pass) {
  return std::ranges::any_of(pass.placements, [](const SymbolicPlacement& placement) {
    std::vector<NodeId> nodes;
    const std::span<const Value> all = placement.arguments;
    for (const Value& value : all.subspan(std::min(all.size(), kLookArguments))) collect_nodes(value, nodes);
    for (const auto& [name, value] : placement.extras) {
      if (!is_look(name)) collect_nodes(value, nodes);
    }
    return !nodes.empty();
  });
}

std::vector<NodeId> something_else(Graph& graph, const SymbolicPass& pass, Apart apart,
                                   Assignment& assignment) {
  Difference difference(graph, pass.trace, assignment);
  difference.value(pass.value);
  if (apart == Apart::kResult) {
    for (const TracePlaced& placed : pass.trace.placed)
      difference.placed(placed.guard, look_arguments(pass.placements[placed.number]));
  }
  return difference.take();
}

}  // namespace solitaire
