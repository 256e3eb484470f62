#include "library/json.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <solitaire/error.h>
#include <solitaire/explain.h>

namespace solitaire::api {
namespace {

struct ValueWriter {
  Json operator()(const Nil&) const { return nullptr; }
  Json operator()(bool value) const { return value; }
  Json operator()(std::int64_t value) const { return value; }
  Json operator()(double value) const { return value; }
  Json operator()(const std::string& value) const { return value; }
  Json operator()(const List& list) const {
    Json json = Json::array();
    for (const Value& item : list.items) json.push_back(json_of(item));
    return json;
  }
  Json operator()(const Record& record) const {
    Json json = Json::object();
    for (const Field& field : record.fields) json[field.name] = json_of(field.value);
    return json;
  }
  Json operator()(const Function& function) const { return function.name; }
};

Json broken_json(const BrokenAssert& broken) {
  Json json{{"at", broken.address}, {"source", broken.source}, {"condition", broken.condition}};
  if (!broken.message.empty()) json["message"] = broken.message;
  return json;
}

Json unmet_json(const UnmetWish& wish) {
  return {{"at", wish.address}, {"source", wish.source}, {"wish", wish.text}, {"cost", wish.cost}};
}

template <class Members, class ToJson>
Json list_of(const Members& members, const ToJson& to_json) {
  Json list = Json::array();
  for (const auto& member : members) list.push_back(to_json(member));
  return list;
}

Json value_json(const ChoiceValue& value) {
  return std::visit([](const auto& answer) { return Json(answer); }, value);
}

/// An element as JSON, if its text is that, else as a string of its text; null if it has none.
Json element_json(const std::string& text) {
  if (text.empty()) return nullptr;
  Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json(text) : json;
}

Json choice_json(const Choice& choice) {
  Json json{{"at", choice.address}, {"value", value_json(choice.value)}};
  if (!choice.element.empty()) json["element"] = element_json(choice.element);
  return json;
}

Json place_json(const Place& place) {
  return {{"file", place.file}, {"line", place.line}, {"column", place.column}, {"text", place.text}};
}

Json condition_json(const Condition& condition) {
  Json json{{"kind", condition.kind}};
  json.update(place_json(condition.place));
  json["at"] = condition.address;
  json["condition"] = condition.words;
  if (!condition.message.empty()) json["message"] = condition.message;
  if (condition.pin) {
    json["pin"] = condition.pin->source;
    json["value"] =
        condition.pin->value ? value_json(*condition.pin->value) : element_json(condition.pin->element);
  }
  return json;
}

Json conflict_json(const Conflict& conflict) {
  Json json{{"minimal", conflict.minimal}, {"members", list_of(conflict.members, condition_json)}};
  if (!conflict.reason.empty()) json["reason"] = conflict.reason;
  return json;
}

Json dead_json(const DeadAssert& dead) {
  Json json = place_json(dead.place);
  json["met"] = dead.met;
  return json;
}

Json reachable_json(const ReachableValues& choice) {
  Json json{{"at", choice.address},
            {"from", choice.from},
            {"to", choice.to},
            {"step", choice.step},
            {"complete", choice.complete}};
  if (!choice.elements.empty()) json["elements"] = list_of(choice.elements, element_json);
  if (choice.listed) {
    json["values"] = choice.values;
    if (choice.complete) json["never"] = choice.missing;
  } else if (!choice.values.empty()) {
    json["least"] = choice.values.front();
    json["greatest"] = choice.values.back();
  }
  return json;
}

ChoiceValue read_value(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  return json.get<double>();
}

bool is_choice(const Json& json) {
  return json.is_object() && json.contains("at") && json["at"].is_string() && json.contains("value") &&
         (json["value"].is_number() || json["value"].is_boolean());
}

}  // namespace

Json json_of(const Value& value) { return std::visit(ValueWriter{}, value.is); }

namespace {

Json json_without_choices(const Solution& solution) {
  Json json{{"value", json_of(solution.value)}};
  if (solution.quality) {
    json["cost"] = solution.quality->cost;
    json["optimal"] = solution.quality->proved_best;
    if (solution.quality->least_cost) json["least_cost"] = *solution.quality->least_cost;
    json["broken"] = list_of(solution.broken, broken_json);
    json["unmet"] = list_of(solution.unmet, unmet_json);
  }
  return json;
}

/// Appends what json_text(choice_json(choice)) gives, which takes long where solutions are many.
void write_choice(const Choice& choice, std::string& text) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  const auto* number = std::get_if<std::int64_t>(&choice.value);
  if (number == nullptr || !choice.element.empty() || !std::ranges::all_of(choice.address, is_plain)) {
    text += json_text(choice_json(choice));
    return;
  }
  fmt::format_to(std::back_inserter(text), R"({{"at":"{}","value":{}}})", choice.address, *number);
}

}  // namespace

Json json_of(const Solution& solution) {
  Json json = json_without_choices(solution);
  json["choices"] = list_of(solution.choices, choice_json);
  return json;
}

Json json_of(const std::vector<Choice>& choices) { return list_of(choices, choice_json); }

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

namespace {

std::vector<Choice> read_choices(const Json& solution, const char* name, const std::string& file) {
  if (!solution.is_object() || !solution.contains(name) || !solution[name].is_array())
    throw Error(Error::Kind::kFile, file + ": is not the .json file of a solution");
  std::vector<Choice> choices;
  for (const Json& choice : solution[name]) {
    if (!is_choice(choice)) {
      throw Error(Error::Kind::kFile,
                  file + ": has a choice that is not of the form {\"at\": ADDRESS, \"value\": VALUE}");
    }
    choices.push_back({choice["at"].get<std::string>(), read_value(choice["value"])});
  }
  return choices;
}

}  // namespace

std::vector<Choice> choices_of(const Json& solution, const std::string& file) {
  return read_choices(solution, "choices", file);
}

std::vector<Choice> all_choices_of(const Json& solution, const std::string& file) {
  std::vector<Choice> choices = choices_of(solution, file);
  if (!solution.contains("auxiliary")) return choices;
  const std::vector<Choice> auxiliary = read_choices(solution, "auxiliary", file);
  choices.insert(choices.end(), auxiliary.begin(), auxiliary.end());
  return choices;
}

std::string to_json(const Solution& solution) {
  Json json = Json::object();
  if (solution.number > 0) json["index"] = solution.number;
  json.update(json_without_choices(solution));
  std::string text = json_text(json);
  text.back() = ',';
  text += "\"choices\":[";
  for (const Choice& choice : solution.choices) {
    if (text.back() == '}') text += ',';
    write_choice(choice, text);
  }
  return text + "]}";
}

std::string to_json(const Explanation& explanation) {
  Json json{{"program", explanation.program}};
  if (explanation.solutions) json["solutions"] = *explanation.solutions;
  if (explanation.solutions == false) json["conflicts"] = list_of(explanation.conflicts, conflict_json);
  if (explanation.asserts) {
    json["dead"] = list_of(explanation.asserts->dead, dead_json);
    json["undecided"] = explanation.asserts->undecided;
    json["choices"] = list_of(explanation.choices, reachable_json);
  }
  return json_text(json);
}

}  // namespace solitaire::api
