#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "engines/engine.h"

namespace solitaire {

/// {"value": ..., "choices": [{"at": ..., "value": ...}, ...]}
nlohmann::ordered_json solution_json(const Solution& solution, const AddressTable& addresses);

/// As text, on one line or, indented, on several; broken UTF-8 is replaced.
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace solitaire
