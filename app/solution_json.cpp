#include "app/solution_json.h"

namespace solitaire {

using Json = nlohmann::ordered_json;

Json solution_json(const Solution& solution, const AddressTable& addresses) {
  Json choices = Json::array();
  for (const AnsweredChoice& choice : readable(solution.choices, addresses)) {
    Json value = choice.value;
    if (choice.kind == ChoiceKind::kBool) value = choice.value != 0;
    choices.push_back({{"at", choice.address}, {"value", value}});
  }
  return {{"value", Json::parse(to_json(solution.execution.value))}, {"choices", choices}};
}

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace solitaire
