#pragma once
#include <string>

#include "solitaire/value/value.h"

namespace solitaire {

/// The most that is short: characters of a text, and parts of a list or record.
constexpr std::size_t kShortText = 60;
constexpr std::size_t kShortList = 8;

/// Returns the value as the language writes it, if that is short: "oven", 3, [1, 2]. Returns "" for what is
/// long or nests, functions without a name, and what depends on choices that are left open.
std::string short_text(const Value& value);

}  // namespace solitaire
