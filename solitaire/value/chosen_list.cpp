#include "solitaire/value/chosen_list.h"

#include <cstdint>
#include <utility>

#include "solitaire/value/elements.h"
#include "solitaire/value/merge.h"

namespace solitaire {
namespace {

using Element = ChosenList::Element;

/// Returns how many elements at the start of a packed list are there in all executions.
std::size_t least_length(const std::vector<Element>& elements) {
  std::size_t least = 0;
  while (least < elements.size() && elements[least].guard == kTrue) ++least;
  return least;
}

/// The condition under which a packed list is at least so long, from 0.
NodeId reaches(const std::vector<Element>& elements, std::size_t length) {
  if (length == 0) return kTrue;
  return length > elements.size() ? kFalse : elements[length - 1].guard;
}

/// Adds an element behind those of a packed list: it comes to lie in the first place that is free.
void add_packed(Graph& graph, std::vector<Element>& elements, std::size_t least, const Element& added) {
  elements.push_back({kFalse, added.value});
  for (std::size_t at = elements.size(); at-- > least;) {
    Element& place = elements[at];
    const NodeId comes_here = graph.conjunction(reaches(elements, at), added.guard);
    place.value = merge(graph, place.guard, place.value, added.value);
    place.guard = graph.disjunction(place.guard, comes_here);
  }
  if (elements.back().guard == kFalse) elements.pop_back();
}

}  // namespace

Value concatenate_lists(const Value& a, const Value& b) {
  const Elements first(a), second(b);
  std::vector<Element> elements;
  elements.reserve(first.size() + second.size());
  for (std::size_t i = 0; i < first.size(); ++i) elements.push_back({first.guard(i), first.value(i)});
  for (std::size_t i = 0; i < second.size(); ++i) elements.push_back({second.guard(i), second.value(i)});
  const bool in_place = second.size() == 0 ? first.packed() : a.is<List>() && second.packed();
  return Value::chosen_list(std::move(elements), in_place);
}

Value packed(Graph& graph, const Value& list) {
  const Elements given(list);
  if (given.packed()) return list;
  std::vector<Element> elements;
  std::size_t least = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    add_packed(graph, elements, least, {given.guard(i), given.value(i)});
    while (least < elements.size() && elements[least].guard == kTrue) ++least;
  }
  return Value::chosen_list(std::move(elements), true);
}

NodeId length_of(Graph& graph, const Value& list) {
  const Elements elements(list);
  NodeId length = graph.constant(std::int64_t{0});
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const NodeId guard = elements.guard(i);
    length = elements.packed()
                 ? graph.phi(guard, graph.constant(static_cast<std::int64_t>(i) + 1), length)
                 : graph.apply(Op::kAdd, {length, graph.phi(guard, graph.constant(std::int64_t{1}),
                                                            graph.constant(std::int64_t{0}))});
  }
  return length;
}

Value of_each_length(Graph& graph, const Value& list) {
  const Value in_place = packed(graph, list);
  const ChosenList* chosen = in_place.object<ChosenList>();
  if (chosen == nullptr) return in_place;
  std::vector<Value> items;
  std::vector<Union::Alternative> lists;
  for (std::size_t length = 0; length <= chosen->elements.size(); ++length) {
    if (length > 0) items.push_back(chosen->elements[length - 1].value);
    if (length < least_length(chosen->elements)) continue;
    const NodeId longer = reaches(chosen->elements, length + 1);
    const NodeId exactly = graph.conjunction(reaches(chosen->elements, length), graph.negation(longer));
    if (exactly != kFalse) lists.push_back({exactly, Value::list(items)});
  }
  if (lists.size() == 1) return lists.front().value;
  return make_ref<Union>(std::move(lists));
}

}  // namespace solitaire
