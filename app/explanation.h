#pragma once
#include <nlohmann/json_fwd.hpp>

#include "engines/explain/dead_asserts.h"
#include "engines/explain/explain.h"
#include "engines/explain/reachable_values.h"

namespace solitaire {

/// What explanations refer to: the program's text, and the addresses in it.
struct ExplanationContext {
  const SourceSet& sources;
  const AddressTable& addresses;
};

// As text for people.
std::string conflict_text(const Conflict& conflict, const ExplanationContext& context);
std::string dead_text(const DeadAsserts& asserts, const SourceSet& sources);
std::string values_text(const ReachableValues& choice, const ExplanationContext& context);

// As JSON; docs/formats.md describes it.
nlohmann::ordered_json conflict_json(const Conflict& conflict, const ExplanationContext& context);
nlohmann::ordered_json dead_json(const DeadAsserts& asserts, const SourceSet& sources);
nlohmann::ordered_json values_json(const ReachableValues& choice, const ExplanationContext& context);

/// A broken or conflicting condition in a few words: "x > 5", "the list must have such an element".
std::string words_of(const Condition& condition, const ExplanationContext& context);

}  // namespace solitaire
