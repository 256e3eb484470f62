#include "library/solution_file.h"

#include <fmt/format.h>
#include <fstream>
#include <solitaire/error.h>

namespace solitaire::api {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error(Error::Kind::kFile, fmt::format("{}: {}", path.string(), reason));
}

/// Refuses a file whose members are others than those of this run. `of` is what they are members of.
void check_run(const Json& file, const Json& expected, const fs::path& path, const std::string& of = "") {
  Json all = expected;
  if (!of.empty() && file.is_object())
    all.update(file);  // an option that only the earlier run had differs, too
  for (const auto& [member, unused] : all.items()) {
    const Json found = file.is_object() ? file.value(member, Json()) : Json();
    const Json wanted = expected.value(member, Json());
    if (found == wanted) continue;
    if (wanted.is_object() && of.empty() && member == "options") {
      check_run(found, wanted, path, "option ");
      continue;
    }
    throw Error(of.empty() ? Error::Kind::kFile : Error::Kind::kUsage,
                fmt::format("{}: comes from a run with another {}{}: {} and not {}; resume with the same "
                            "options, or generate into another folder",
                            path.string(), of, member, found.dump(), wanted.dump()));
  }
}

}  // namespace

Json read_solution_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail(path, "is a folder, not the .json file of a solution");
  std::ifstream stream(path);
  if (!stream) fail(path, "cannot be read");
  Json solution = Json::parse(stream, nullptr, false);
  if (!solution.is_object()) fail(path, "is not the .json file of a solution");
  return solution;
}

std::vector<EarlierSolution> read_earlier_run(const fs::path& folder, const std::string& name,
                                              const Json& expected) {
  std::vector<EarlierSolution> solutions;
  while (true) {
    const fs::path path = folder / fmt::format("{}-{:04}.json", name, solutions.size() + 1);
    if (!fs::exists(path)) return solutions;
    const Json file = read_solution_file(path);
    check_run(file, expected, path);
    EarlierSolution solution{all_choices_of(file, path.string()), {}, {}};
    if (file.contains("optimal")) solution.optimal = file["optimal"] == true;
    if (file.contains("least_cost") && file["least_cost"].is_number_integer())
      solution.least_cost = file["least_cost"].get<std::int64_t>();
    solutions.push_back(std::move(solution));
  }
}

}  // namespace solitaire::api
