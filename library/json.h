#pragma once
#include <nlohmann/json.hpp>
#include <solitaire/solution.h>
#include <string>

namespace solitaire::api {

// All JSON that leaves the library is made here and written by json_text().

using Json = nlohmann::ordered_json;

Json json_of(const Value& value);
/// Returns {"value": ..., "choices": [{"at": ..., "value": ...}, ...]}, and of a solution that is better or
/// worse than others "cost", "optimal" and "broken".
Json json_of(const Solution& solution);

/// Returns the text on one line or, indented, on several; broken UTF-8 is replaced.
std::string json_text(const Json& json, int indent = -1);

/// Returns the choices of a solution's object. Throws Error (kFile), which names `file`, if it has none in
/// that form.
std::vector<Choice> choices_of(const Json& solution, const std::string& file);
/// Returns these and, behind them, the auxiliary ones.
std::vector<Choice> all_choices_of(const Json& solution, const std::string& file);
Json json_of(const std::vector<Choice>& choices);

}  // namespace solitaire::api
