#include "library/choice_columns.h"

#include <variant>

#include "library/json.h"

namespace solitaire::api {

void ChoiceColumns::add(const std::vector<Choice>& choices) {
  Json row = Json::array();
  for (const Choice& choice : choices) {
    row.push_back(position_of(choice.address));
    std::visit([&](const auto& value) { row.push_back(value); }, choice.value);
  }
  if (!solutions_.empty()) solutions_ += ",\n";
  solutions_ += json_text(row);
}

std::string ChoiceColumns::json() const {
  return "{\"addresses\":" + json_text(Json(addresses_)) + ",\n\"solutions\":[" + solutions_ + "]}";
}

std::size_t ChoiceColumns::position_of(const std::string& address) {
  const auto [place, added] = positions_.try_emplace(address, addresses_.size());
  if (added) addresses_.push_back(address);
  return place->second;
}

}  // namespace solitaire::api
