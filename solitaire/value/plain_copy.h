#pragma once
#include <string>

#include "solitaire/value/plain_value.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// Copies a value. A variable that was never set counts as nil, and what depends on choices that are left
/// open as a function called '?'.
PlainValue plain(const Value& value);

/// The value as JSON, as that of its copy.
std::string to_json(const Value& value);

}  // namespace solitaire
