#pragma once
#include <solitaire/search.h>
#include <solitaire/solution.h>

#include "base/source.h"
#include "engines/solution.h"
#include "tracegraph/scalar.h"

namespace solitaire::api {

// Translate the plain data that engines hand out to that of the public headers.

Value frozen(const PlainValue& value);
ChoiceValue frozen(TypedScalar value);
Choice frozen(const ChosenValue& choice);
Solution frozen(const solitaire::Solution& solution, std::uint64_t number, const SourceSet& sources);

/// Returns the value as engines have it.
TypedScalar scalar_of(const ChoiceValue& value);

/// Returns the choices as engines have those of a solution that is known from before.
ChosenValues known_choices(const std::vector<Choice>& choices);

}  // namespace solitaire::api
