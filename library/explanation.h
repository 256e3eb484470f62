#pragma once
#include <solitaire/explain.h>
#include <string>

#include "base/source.h"
#include "engines/explain/dead_asserts.h"
#include "engines/explain/explain.h"
#include "engines/explain/reachable_values.h"
#include "tracegraph/address.h"

namespace solitaire::api {

/// Explanations refer to this: the program's text, and the addresses in it.
struct ExplanationContext {
  const SourceSet& sources;
  const AddressTable& addresses;
};

/// Returns a broken or conflicting condition in a few words: "x > 5", "the list must have such an element".
std::string words_of(const solitaire::Condition& condition, const ExplanationContext& context);

// Make plain data with texts of what engines found out.
Conflict frozen(const solitaire::Conflict& conflict, const ExplanationContext& context);
DeadAsserts frozen(const solitaire::DeadAsserts& asserts, const SourceSet& sources);
ReachableValues frozen(const solitaire::ReachableValues& choice, const AddressTable& addresses);

}  // namespace solitaire::api
