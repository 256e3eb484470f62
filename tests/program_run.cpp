#include "tests/program_run.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>

namespace solitaire {

std::filesystem::path tests_folder() { return std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "tests"; }

LoadOptions library() { return {{std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "solitaire"}}; }

std::vector<Found> all_solutions(Engine& engine) {
  std::vector<Found> all;
  while (const auto solution = engine.next()) {
    Found found{to_text(solution->execution.value), {}, solution->execution.printed};
    for (const AnsweredChoice& choice : readable(solution->choices, engine.addresses())) {
      found.choices.push_back(fmt::format("{} = {}", choice.address, choice.value));
    }
    all.push_back(std::move(found));
  }
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());  // each solution once
  return all;
}

std::vector<Found> all_solutions(const Program& program, const ParamValues& params, Way way) {
  if (way == Way::kExhaustive) {
    ExhaustiveEngine engine(program, params, {});
    auto found = all_solutions(engine);
    CHECK(engine.ending() == Ending::kExhausted);
    return found;
  }
  TracingOptions options;
  options.diverse = false;
  if (way == Way::kZ3) options.backend = Backend::kZ3;
  if (way == Way::kRandom) options.exploration = {Exploration::Policy::kRandom, 40};
  TracingEngine engine(program, params, options);
  auto found = all_solutions(engine);
  if (way != Way::kRandom) CHECK(engine.ending() == Ending::kExhausted);
  return found;
}

Program load(const std::string& path) {
  SourceSet sources;
  return load_program(tests_folder() / path, library(), sources);
}

Program program_of(const std::string& text) {
  SourceSet sources;
  return load_program_text("test.sol", text, library(), sources);
}

std::vector<std::string> values_of(const std::string& text) {
  const Program program = program_of(text);
  const std::vector<Found> found = all_solutions(program, {}, Way::kDemand);
  CHECK(found == all_solutions(program, {}, Way::kExhaustive));
  std::vector<std::string> values;
  for (const Found& each : found) values.push_back(each.value);
  return values;
}

}  // namespace solitaire
