#pragma once
#include <optional>

#include "solitaire/run/execution.h"

namespace solitaire {

/// The error where none of the executions that were drawn to start from is possible. `rejection` is what
/// ruled the last of them out, or nothing where its density was 0.
ProgramError no_start(const std::optional<Rejection>& rejection);

}  // namespace solitaire
