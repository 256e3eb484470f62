#include "app/earlier_run.h"

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/diagnostic.h"
#include "base/file_error.h"

namespace solitaire {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

KnownChoices choices_of(const Json& file, const std::string& path) {
  KnownChoices choices;
  try {
    for (const Json& choice : file.at("choices")) {
      const Json& value = choice.at("value");
      choices.push_back({choice.at("at").get<std::string>(),
                         value.is_boolean() ? Distribution::Family::kFlip : Distribution::Family::kRange,
                         value.is_boolean() ? TypedScalar::of(value.get<bool>())
                                            : TypedScalar::of(value.get<std::int64_t>())});
    }
  } catch (const Json::exception&) {
    throw FileError(path, "is not the .json file of a solution");
  }
  return choices;
}

void check_run(const Json& file, const Json& expected, const std::string& path) {
  for (const auto& [member, value] : expected.items()) {
    const Json found = file.value(member, Json());
    if (found == value) continue;
    throw FileError(path, fmt::format("comes from a run with another {}: {} and not {}; resume with the same "
                                      "options, or generate into another folder",
                                      member, found.dump(), value.dump()));
  }
}

}  // namespace

std::vector<EarlierSolution> read_earlier_run(const fs::path& folder, const std::string& name,
                                              const Json& expected) {
  std::vector<EarlierSolution> solutions;
  while (true) {
    const fs::path path = folder / fmt::format("{}-{:04}.json", name, solutions.size() + 1);
    if (!fs::exists(path)) return solutions;
    std::ifstream stream(path);
    if (!stream) throw FileError(path.string(), "cannot be read");
    const Json file = Json::parse(stream, nullptr, false);
    if (!file.is_object()) throw FileError(path.string(), "is not the .json file of a solution");
    check_run(file, expected, path.string());
    EarlierSolution solution{choices_of(file, path.string()), {}};
    if (file.contains("optimal")) solution.optimal = file["optimal"] == true;
    solutions.push_back(std::move(solution));
  }
}

}  // namespace solitaire
