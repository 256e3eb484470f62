#pragma once
#include <solitaire/search.h>
#include <solitaire/solution.h>

#include "engines/engine.h"
#include "engines/solve/tracing.h"

namespace solitaire::api {

// From what an engine has, which belongs to its thread and program, to plain data that refers to nothing.

Value frozen(const solitaire::Value& value);
Choice frozen(const AnsweredChoice& choice);
Solution frozen(const solitaire::Solution& solution, std::uint64_t number, const SourceSet& sources);

/// Returns the choices as engines have those of a solution that is known from before.
KnownChoices known_choices(const std::vector<Choice>& choices);

}  // namespace solitaire::api
