#pragma once
#include <vector>

#include "solitaire/builtins/builtin.h"

namespace solitaire {

/// The builtins that draw from distributions, make distributions as values, and weight executions by them.
std::vector<Builtin> distribution_builtins();

}  // namespace solitaire
