#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "solitaire/value/value.h"

namespace solitaire {

/// Returns true for a string that is no union: a known one, one of parts, or one that only executions know.
bool is_one_string(const Value& value);

/// Returns true for a string, of choices or not, whose alternatives and parts are known.
bool is_text(const Value& value);

/// Returns true for a Joined, and for a union with one.
bool has_parts(const Value& value);

/// Returns one text behind the other, both of which are texts: a string, a union of strings, or a Joined of
/// which `span` is the place.
Value concatenate(const Value& a, const Value& b, Span span);

/// Returns the condition under which a text says exactly this.
NodeId says(Graph& graph, const Value& text, std::string_view what);

/// Returns a text as a string or a union of strings; nothing if there are more than that many.
std::optional<Value> spelled_out(Graph& graph, const Value& text, std::size_t most);

/// How many bytes a text has, depending on choices.
struct TextSizes {
  std::size_t least = 0, most = 0;
};
TextSizes sizes(const Value& text);

/// Returns true for two that are Joined of as many parts, each of which has one size in bytes, whatever is
/// chosen, and the same as its counterpart.
bool same_sizes(const Value& a, const Value& b);

}  // namespace solitaire
