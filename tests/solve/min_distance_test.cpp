// Solutions that keep a distance from each other: all of them do, and there is no further one that does.
#include "engines/solve/executions/min_distance.h"

#include <algorithm>
#include <doctest/doctest.h>

#include "engines/solve/series.h"
#include "tests/generator/program_generator.h"
#include "tests/solve/proof.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

using Choices = std::map<std::string, TypedScalar>;

Choices choices_of(const Solution& solution) {
  Choices choices;
  for (const ChosenValue& choice : solution.choices) choices.emplace(choice.address, choice.value);
  return choices;
}

/// As the definition has it, without fractions of integers.
bool is_far(const Choices& a, const Choices& b, double bound) {
  return overlap_of(a, b).distance() >= bound - 1e-9;
}

bool is_far_from_all(const Choices& choices, const std::vector<Choices>& all, double bound) {
  return std::all_of(all.begin(), all.end(),
                     [&](const Choices& other) { return is_far(choices, other, bound); });
}

/// Holds a search for all solutions at that distance against brute force. False if there are too many
/// executions for that.
bool check_all(const std::string& text, double bound, TracingOptions tracing = {}) {
  CAPTURE(text);
  CAPTURE(bound);
  const Program program = program_of(text);
  if (!brute_force(program, {}, 4000)) return false;
  tracing.min_distance = DistanceBound::of(bound);
  Series series(program, {}, tracing, {});
  std::vector<Choices> found;
  while (const auto solution = series.next()) {
    found.push_back(choices_of(*solution));
    CHECK(is_far_from_all(found.back(), {found.begin(), found.end() - 1}, bound));
  }
  CHECK(series.ending() == Ending::kExhausted);
  ExhaustiveEngine everything(program, {}, {});
  while (const auto solution = everything.next())
    CHECK(!(found.empty() || is_far_from_all(choices_of(*solution), found, std::max(bound, 1e-3))));
  return true;
}

constexpr const char* kRooks = "xs = [range(0, 4) for i in 0..4]; assert(distinct(xs)); return xs;";
constexpr const char* kPaths =
    "n = range(0, 3); xs = [range(0, 2) for i in 1..n]; if flip() { y = range(0, 3); assert(y != n); } "
    "return "
    "xs;";

TEST_CASE("min distance: all solutions that are that far from each other, and no further one is") {
  for (const double bound : {0.0, 0.2, 0.25, 1.0 / 3, 0.5, 0.61, 0.8, 1.0}) {
    CHECK(check_all(kRooks, bound));
    CHECK(check_all(kPaths, bound));
    CHECK(check_all("return 5;", bound));
    CHECK(check_all("x = range(0, 9); assert(x > 3); return x;", bound));
    CHECK(check_all("x = range(0, 9, 3); y = range(3, 3); return x + y;", bound));
  }
}

TEST_CASE("min distance: the same by Z3, without diversity, and over paths that are opened one by one") {
  TracingOptions z3, plain, little;
  z3.method = &z3_method();
  plain.diverse = false;
  little.exploration.unasked_sides = 0;
  little.exploration.levels = 1;
  little.exploration.grant = 1;
  for (const TracingOptions& options : {z3, plain, little}) {
    for (const double bound : {0.3, 0.5, 0.75}) {
      CHECK(check_all(kRooks, bound, options));
      CHECK(check_all(kPaths, bound, options));
    }
  }
}

TEST_CASE("min distance: of generated programs (slow)") {
  TracingOptions little;
  little.exploration.unasked_sides = 0;
  little.exploration.levels = 1;
  int checked = 0;
  for (std::uint64_t seed = 500'000; seed < 500'060; ++seed) {
    ByteSource bytes(seed);
    const std::string text = generate_script(bytes);
    try {
      if (check_all(text, 0.5) && check_all(text, 0.3, little)) ++checked;
    } catch (const ProgramError&) {  // program_errors are another test's business
    }
  }
  CHECK(checked >= 20);
}

TEST_CASE("min distance: the best come first, of those that are far enough") {
  const Program program = program_of("xs = [range(0, 3) for i in 0..2]; minimize(sum(xs)); return sum(xs);");
  TracingOptions tracing;
  tracing.min_distance = DistanceBound::of(1);
  TracingEngine engine(program, {}, tracing);
  std::vector<std::int64_t> costs;
  while (const auto solution = engine.next()) {
    costs.push_back(solution->quality->cost);
    CHECK(solution->quality->proved);
    engine.keep_away_from(solution->choices);
  }
  CHECK(costs == std::vector<std::int64_t>{0, 3, 6, 9});
  check_that_nothing_is_left(engine);
}

TEST_CASE("min distance: the formula that is left has no model, over paths that were opened one by one") {
  TracingOptions tracing;
  tracing.min_distance = DistanceBound::of(0.5);
  tracing.exploration.unasked_sides = 0;
  tracing.exploration.levels = 1;
  const Program program = program_of(kPaths);
  TracingEngine engine(program, {}, tracing);
  while (const auto solution = engine.next()) engine.keep_away_from(solution->choices);
  CHECK(engine.ending() == Ending::kExhausted);
  check_that_nothing_is_left(engine);
}

TEST_CASE("min distance: a bound is an exact fraction") {
  const DistanceBound half = DistanceBound::of(0.5), tenth = DistanceBound::of(0.1);
  CHECK(half.part == 1);
  CHECK(half.whole == 2);
  CHECK(tenth.whole == 10);
  CHECK(tenth.reached({9, 10}));
  CHECK(!tenth.reached({10, 11}));
  CHECK(DistanceBound::of(1).reached({0, 3}));
  CHECK(!DistanceBound::of(1).reached({1, 3}));
  CHECK(!DistanceBound::of(0).any());
}

TEST_CASE("min distance: on the command line, where it ends and goes on") {
  const Workplace place;
  const std::string script = place.file("rooks.sol", kRooks);
  const Outcome all = run_solitaire({"solve", script, "--all", "--min-distance", "1"});
  CHECK(all.status == 0);
  CHECK(all.err.find("proved that no other is that far from all of them") != std::string::npos);
  CHECK(all.err.find("mean distance of choices 1.00") != std::string::npos);
  CHECK(run_solitaire({"solve", script, "-n", "100", "--min-distance", "0.9"}).status == 1);
  CHECK(run_solitaire({"solve", script, "--min-distance", "1.5"}).status == 2);
  const std::string rooks =
      place.file("more.sol", "xs = [range(0, 6) for i in 0..6]; assert(distinct(xs)); return xs;");
  const auto generate = [&](const char* folder, const char* count, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"generate", rooks, "-n", count, "--min-distance", "0.5", "-o", place / folder});
    return run_solitaire(more);
  };
  CHECK(generate("whole", "45", {}).status == 0);
  for (const char* count : {"10", "35", "45"}) CHECK(generate("parts", count, {"--resume"}).status == 0);
  CHECK(run({"diff", "-r", place / "whole", place / "parts"}).out == "");
  CHECK(bytes_of(place / "whole/more-run.json").find("\"min_distance\": 0.5") != std::string::npos);
}

}  // namespace
}  // namespace solitaire
