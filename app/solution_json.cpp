#include "app/solution_json.h"

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace solitaire {
namespace {

using Json = nlohmann::ordered_json;

/// "file.sol:3:8", without the folder, so that files do not depend on where the program stands.
std::string place(Span span, const SourceSet& sources) {
  return std::filesystem::path(sources.place(span)).filename().string();
}

Json broken_json(const Solution& solution, const SourceSet& sources) {
  Json list = Json::array();
  for (const Rejection& broken : solution.execution.broken) {
    Json entry{{"at", broken.address},
               {"source", place(broken.span, sources)},
               {"condition", sources.text(broken.span)}};
    if (!broken.message.empty()) entry["message"] = broken.message;
    list.push_back(std::move(entry));
  }
  return list;
}

/// The members of a solution's object, from "value" to "choices", piece by piece, since there can be very
/// many.
std::string members(const Solution& solution, const SourceSet& sources) {
  std::string text = fmt::format("\"value\":{}", to_json(solution.execution.value));
  if (solution.quality) {
    text += fmt::format(",\"cost\":{},\"optimal\":{},\"broken\":{}", solution.quality->cost,
                        solution.quality->proved, json_text(broken_json(solution, sources)));
  }
  text += ",\"choices\":[";
  for (const AnsweredChoice& choice : solution.answers) {
    text += text.back() == '[' ? "{\"at\":" : ",{\"at\":";
    text += json_string(choice.address);
    text += ",\"value\":";
    text += to_text(choice.value);
    text += '}';
  }
  return text + ']';
}

}  // namespace

Json solution_json(const Solution& solution, const SourceSet& sources) {
  return Json::parse('{' + members(solution, sources) + '}');
}

std::string solution_line(std::uint64_t number, const Solution& solution, const SourceSet& sources) {
  return fmt::format("{{\"index\":{},{}}}\n", number, members(solution, sources));
}

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string quality_text(const Solution& solution) {
  if (!solution.quality) return "";
  const Quality& quality = *solution.quality;
  std::string text;
  if (quality.broken > 0)
    text += fmt::format("{} assert{} broken, ", quality.broken, quality.broken == 1 ? "" : "s");
  if (!solution.execution.wishes.empty()) text += fmt::format("cost {}, ", quality.cost);
  return text + (quality.proved ? "proved the best left" : "not proved the best left");
}

std::string broken_text(const Rejection& broken, const SourceSet& sources) {
  std::string text =
      fmt::format("{}: {} (at {})", place(broken.span, sources), sources.text(broken.span), broken.address);
  if (!broken.message.empty()) text += ": " + broken.message;
  return text;
}

}  // namespace solitaire
