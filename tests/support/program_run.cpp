#include "tests/support/program_run.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "engines/thesis/published_method.h"
#include "library/known_models.h"
#include "library/known_tile_files.h"
#include "tests/solve/proof.h"

namespace solitaire {

std::filesystem::path tests_folder() { return std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "tests"; }

LoadOptions library() {
  static const std::filesystem::path source = SOLITAIRE_SOURCE_DIR;
  static const auto models = std::make_shared<api::KnownModels>(AssetLibrary(source / "assets", "."));
  static const auto tile_files = std::make_shared<api::KnownTileFiles>(source / "tests" / "language");
  return {{source / "solitaire"}, models, tile_files};
}

namespace {

Found found(const Solution& solution) {
  Found made{to_text(solution.value), {}, solution.printed};
  for (const ChosenValue& choice : solution.choices) {
    made.choices.push_back(fmt::format("{} = {}", choice.address, to_text(choice.value)));
  }
  return made;
}

std::vector<Found> sorted(std::vector<Found> all) {
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());  // each solution once
  return all;
}

}  // namespace

std::vector<Found> all_solutions(SolutionStream& engine) {
  std::vector<Found> all;
  while (const auto solution = engine.next()) all.push_back(found(*solution));
  return sorted(std::move(all));
}

std::optional<std::vector<Found>> brute_force(const Program& program, const ParamValues& params,
                                              std::uint64_t most_executions) {
  ExhaustiveEngine engine(program, params, {}, most_executions);
  std::vector<Found> all;
  while (const auto solution = engine.next()) all.push_back(found(*solution));
  if (engine.ending() != Ending::kExhausted) return std::nullopt;
  return sorted(std::move(all));
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
  if (way == Way::kZ3) options.method = &z3_method();
  if (way == Way::kThesis) options.method = &published_method();
  if (way == Way::kRandom || way == Way::kThesis) options.exploration = {Exploration::Policy::kRandom, 40};
  TracingEngine engine(program, params, options);
  auto found = all_solutions(engine);
  if (way == Way::kDemand || way == Way::kZ3) CHECK(engine.ending() == Ending::kExhausted);
  if (way == Way::kDemand) check_that_nothing_is_left(engine);
  return found;
}

std::optional<std::vector<Execution>> all_executions(const Program& program, AddressTable& addresses,
                                                     const Limits& limits, std::uint64_t most) {
  ExhaustiveChoices choices;
  std::vector<Execution> all;
  for (std::uint64_t count = 0; choices.advance(); ++count) {
    if (count == most) return std::nullopt;
    Execution execution = execute(program, {}, choices, addresses, limits);
    if (!execution.rejection) all.push_back(std::move(execution));
  }
  return all;
}

namespace {

class GivenChoices : public Choices {
 public:
  GivenChoices(const ChosenValues& choices, AddressTable& addresses) {
    for (const ChosenValue& choice : choices)
      values_.emplace(addresses.address(choice.address), choice.value);
  }
  std::optional<TypedScalar> answer(AddressId address, const Distribution&) override {
    return values_.at(address);
  }

 private:
  Valuation values_;
};

}  // namespace

Execution run_again(const Program& program, const ParamValues& params, const ChosenValues& choices,
                    const Limits& limits) {
  AddressTable addresses;
  GivenChoices given(choices, addresses);
  return execute(program, params, given, addresses, limits);
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
