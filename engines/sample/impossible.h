#pragma once
#include <optional>

#include "base/diagnostic.h"
#include "base/span.h"

namespace solitaire {

/// The error where none of the executions that were drawn to start from is possible. `ruled_out` is what was
/// not so in the last of them: a condition, or what was observed.
ProgramError no_start(const std::optional<Span>& ruled_out);

}  // namespace solitaire
