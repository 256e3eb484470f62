#include "solitaire/value/joined.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "solitaire/value/merge.h"

namespace solitaire {
namespace {

using Parts = std::vector<Value>;

bool is_string(const Value& value) { return value.is<String>(); }

bool is_union_of_strings(const Value& value) {
  const Union* several = value.as_union();
  return several != nullptr && std::ranges::all_of(several->alternatives, [](const Union::Alternative& one) {
           return is_string(one.value);
         });
}

const std::string& text_of(const Value& string) { return string.object<String>()->text; }

Value append(const Value& a, const Value& b) { return Value::string(text_of(a) + text_of(b)); }

/// A union with the same guards, whose alternatives are made by f. They differ where they did before.
template <class Function>
Value map_alternatives(const Union& several, Function f) {
  std::vector<Union::Alternative> made;
  for (const auto& [guard, value] : several.alternatives) made.push_back({guard, f(value)});
  return make_ref<Union>(std::move(made));
}

/// Adds a text to parts, of which no two strings stand next to each other.
void add_part(Parts& parts, const Value& text) {
  if (const Joined* joined = text.object<Joined>()) {
    for (const Value& part : joined->parts) add_part(parts, part);
  } else if (is_string(text) && !parts.empty() && is_string(parts.back())) {
    parts.back() = append(parts.back(), text);
  } else if (!is_string(text) || !text_of(text).empty()) {
    parts.push_back(text);
  }
}

/// How much of a text has been matched, and when.
using Matched = std::map<std::size_t, NodeId>;

void add(Graph& graph, Matched& matched, std::size_t size, NodeId guard) {
  if (guard == kFalse) return;
  const auto [at, added] = matched.emplace(size, guard);
  if (!added) at->second = graph.disjunction(at->second, guard);
}

/// Matches a text behind what has been matched of `what`.
Matched match(Graph& graph, const Value& text, std::string_view what, const Matched& before) {
  Matched after;
  if (const Joined* joined = text.object<Joined>()) {
    after = before;
    for (const Value& part : joined->parts) after = match(graph, part, what, after);
  } else if (const Union* several = text.as_union()) {
    for (const auto& [guard, value] : several->alternatives) {
      for (const auto& [size, when] : match(graph, value, what, before))
        add(graph, after, size, graph.conjunction(when, guard));
    }
  } else {
    const std::string& own = text_of(text);
    for (const auto& [size, when] : before) {
      if (what.substr(size).starts_with(own)) add(graph, after, size + own.size(), when);
    }
  }
  return after;
}

/// The different strings that a text can be, and when it is each.
using Strings = std::map<std::string, NodeId>;

/// Adds what a text can be behind each of `before`; false if there are too many.
bool spell(Graph& graph, const Value& text, const Strings& before, std::size_t most, Strings& after) {
  const auto add_to = [&](const std::string& string, NodeId guard) {
    if (guard == kFalse) return;
    const auto [at, added] = after.emplace(string, guard);
    if (!added) at->second = graph.disjunction(at->second, guard);
  };
  if (const Joined* joined = text.object<Joined>()) {
    Strings now = before;
    for (const Value& part : joined->parts) {
      Strings next;
      if (!spell(graph, part, now, most, next)) return false;
      now = std::move(next);
    }
    for (const auto& [string, guard] : now) add_to(string, guard);
  } else if (const Union* several = text.as_union()) {
    for (const auto& [guard, value] : several->alternatives) {
      Strings made;
      if (!spell(graph, value, before, most, made)) return false;
      for (const auto& [string, when] : made) add_to(string, graph.conjunction(when, guard));
      if (after.size() > most) return false;
    }
  } else {
    for (const auto& [string, when] : before) add_to(string + text_of(text), when);
  }
  return after.size() <= most;
}

}  // namespace

bool is_one_string(const Value& value) { return value.is<String>() || value.is<Joined>(); }

bool is_text(const Value& value) {
  if (const String* text = value.object<String>()) return !text->opaque;
  if (value.is<Joined>()) return true;
  const Union* several = value.as_union();
  return several != nullptr && std::ranges::all_of(several->alternatives, [](const Union::Alternative& one) {
           return is_text(one.value);
         });
}

bool has_parts(const Value& value) {
  if (value.is<Joined>()) return true;
  const Union* several = value.as_union();
  return several != nullptr && std::ranges::any_of(several->alternatives, [](const Union::Alternative& one) {
           return one.value.is<Joined>();
         });
}

Value concatenate(const Value& a, const Value& b, Span span) {
  if (is_string(a) && is_string(b)) return append(a, b);
  if (is_string(a) && is_union_of_strings(b))
    return map_alternatives(*b.as_union(), [&](const Value& one) { return append(a, one); });
  if (is_union_of_strings(a) && is_string(b))
    return map_alternatives(*a.as_union(), [&](const Value& one) { return append(one, b); });
  Parts parts;
  add_part(parts, a);
  add_part(parts, b);
  if (parts.size() == 1) return parts.front();
  return make_ref<Joined>(std::move(parts), span);
}

NodeId says(Graph& graph, const Value& text, std::string_view what) {
  const Matched ends = match(graph, text, what, {{0, kTrue}});
  const auto whole = ends.find(what.size());
  return whole == ends.end() ? kFalse : whole->second;
}

std::optional<Value> spelled_out(Graph& graph, const Value& text, std::size_t most) {
  Strings made;
  if (!spell(graph, text, {{"", kTrue}}, most, made)) return std::nullopt;
  std::vector<Union::Alternative> strings;
  for (const auto& [string, guard] : made) strings.push_back({guard, Value::string(string)});
  if (strings.size() == 1) return strings.front().value;
  return make_ref<Union>(std::move(strings));
}

TextSizes sizes(const Value& text) {
  if (is_string(text)) return {text_of(text).size(), text_of(text).size()};
  TextSizes all;
  if (const Joined* joined = text.object<Joined>()) {
    for (const Value& part : joined->parts) {
      const TextSizes own = sizes(part);
      all = {all.least + own.least, all.most + own.most};
    }
    return all;
  }
  all.least = SIZE_MAX;
  for (const auto& [guard, value] : text.as_union()->alternatives) {
    const TextSizes own = sizes(value);
    all = {std::min(all.least, own.least), std::max(all.most, own.most)};
  }
  return all;
}

bool same_sizes(const Value& a, const Value& b) {
  const Joined* joined = a.object<Joined>();
  const Joined* other = b.object<Joined>();
  return joined != nullptr && other != nullptr &&
         std::ranges::equal(joined->parts, other->parts, [](const Value& x, const Value& y) {
           const TextSizes of_x = sizes(x), of_y = sizes(y);
           return of_x.least == of_x.most && of_y.least == of_y.most && of_x.most == of_y.most;
         });
}

}  // namespace solitaire
