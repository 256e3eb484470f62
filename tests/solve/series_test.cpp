// A series of solutions that was interrupted goes on as if it had not been.
#include "engines/solve/series.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <set>

#include "engines/distance.h"
#include "smt/write_dimacs.h"
#include "tests/solve/proof.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

/// 720 solutions, of which several look like each other.
constexpr const char* kSixRooks =
    "column = [range(0, 5) for row in 0..5];\nassert(distinct(column));\n"
    "for row in 0..5 { place(\"rook\", at: [row, column[row] / 2], size: [1, 1]); }\nreturn 0;\n";

std::vector<std::string> take(Series& series, std::size_t count) {
  std::vector<std::string> taken;
  while (taken.size() < count) {
    const auto solution = series.next();
    if (!solution) break;
    std::string text;
    for (const ChosenValue& choice : solution->choices)
      text += fmt::format("{}={} ", choice.address, to_text(choice.value));
    taken.push_back(std::move(text));
  }
  return taken;
}

std::vector<ChosenValues> take_choices(Series& series, std::size_t count) {
  std::vector<ChosenValues> taken;
  while (taken.size() < count) taken.push_back(series.next()->choices);
  return taken;
}

SeriesOptions different_looks() {
  SeriesOptions options;
  options.apart = Apart::kResult;
  return options;
}

void check_resumed(const char* text, const SeriesOptions& options, const std::vector<std::size_t>& cuts,
                   std::size_t count, bool diverse = true) {
  const Program program = program_of(text);
  TracingOptions tracing;
  tracing.seed = 7;
  tracing.diverse = diverse;
  Series whole(program, {}, tracing, options);
  const std::vector<std::string> expected = take(whole, count);
  for (const std::size_t cut : cuts) {
    CAPTURE(cut);
    Series first(program, {}, tracing, options);
    const std::vector<ChosenValues> earlier = take_choices(first, cut);
    Series second(program, {}, tracing, options);
    const std::vector<Solution> again = second.resume(earlier);
    REQUIRE(again.size() == cut);
    const std::vector<std::string> rest = take(second, count - cut);
    CHECK(rest ==
          std::vector<std::string>(expected.begin() + static_cast<std::ptrdiff_t>(cut), expected.end()));
    CHECK(second.ending() == whole.ending());
  }
}

/// 1305 solutions: 870 pairs, half of which have two.
constexpr const char* kPairs =
    "x = range(0, 29); y = range(0, 29); assert(x != y); if x > y { z = flip(); } return x;";

/// The least distance of two solutions of different blocks, of which the first has four.
double nearest_of_blocks(Series& series, std::size_t count) {
  std::vector<HashedFeatures> blocks[2];
  double nearest = 1;
  for (std::size_t i = 0; i < count; ++i) {
    HashedFeatures features(choice_features(series.next()->choices));
    for (const HashedFeatures& other : blocks[0])
      if (i >= 4) nearest = std::min(nearest, overlap_of(features, other).distance());
    blocks[i < 4 ? 0 : 1].push_back(std::move(features));
  }
  return nearest;
}

TEST_CASE("series: solutions of blocks that do not know each other are apart") {
  // Of two random solutions, one pair in eighteen has two choices at most that differ.
  const Program program = program_of("x = [range(0, 1) for i in 1..10]; assert(sum(x) > 0); return x;");
  for (const std::size_t jobs : {1, 3}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      TracingOptions tracing;
      tracing.seed = seed;
      SeriesOptions options;
      options.jobs = jobs;
      Series series(program, {}, tracing, options);
      CHECK(nearest_of_blocks(series, 12) >= 0.3);
    }
  }
}

TEST_CASE("series: where most solutions have come, the rest comes as from a list in random order") {
  const Program program = program_of(kPairs);
  for (const std::size_t jobs : {0, 3}) {
    SeriesOptions options;
    options.jobs = jobs;
    Series series(program, {}, {}, options);
    const std::vector<std::string> all = take(series, 2000);
    CHECK(all.size() == 1305);
    CHECK(std::set<std::string>(all.begin(), all.end()).size() == 1305);
    CHECK(series.ending() == Ending::kExhausted);
    std::size_t ascending = 0;
    for (std::size_t i = 600; i + 1 < all.size(); ++i) ascending += all[i] < all[i + 1] ? 1U : 0U;
    CHECK(ascending > 250);  // about a half of 704, as in no order
    CHECK(ascending < 450);
  }
  check_resumed(kPairs, {}, {250, 300, 700, 1304}, 2000);
}

TEST_CASE("series: nothing is left after solutions that came from a list") {
  const Program program = program_of(kPairs);
  Series series(program, {}, {}, {});
  CHECK(take(series, 2000).size() == 1305);
  const Formula rest = series.formula_of_rest();
  CHECK_FALSE(cadical_verdict(to_dimacs(rest.graph, rest.addresses, rest.conditions)).satisfiable);
}

TEST_CASE("series: an interrupted one goes on with exactly what would have come, wherever it was cut") {
  check_resumed(kSixRooks, {}, {0, 1, 3, 4, 5, 24, 31, 56, 57, 120}, 140);
}

TEST_CASE("series: the same without solutions that look like others, to the end of all") {
  check_resumed(kSixRooks, different_looks(), {0, 5, 32, 50, 90}, 1000);  // there are 90
}

TEST_CASE("series: the same with the best first") {
  check_resumed("x = range(0, 9); y = range(0, 9); assert(x != y); minimize(x / 3 + y / 2); return x;", {},
                {10, 40}, 90);
}

TEST_CASE("series: the same where all are gone through in order") {
  check_resumed("x = range(0, 19); y = range(0, 1); return x;", {}, {0, 13, 39}, 100, false);
}

/// What comes with so many searches at work beside each other.
std::vector<std::string> take_with(std::size_t jobs, const char* text, SeriesOptions options,
                                   std::size_t count, Ending* ending) {
  const Program program = program_of(text);
  options.jobs = jobs;
  Series series(program, {}, {}, options);
  std::vector<std::string> taken = take(series, count);
  *ending = series.ending();
  return taken;
}

TEST_CASE("series: the same solutions come in the same order, however many searches are at work (slow)") {
  for (const bool looks : {false, true}) {
    for (const std::size_t count : {1, 7, 60, 1000}) {
      const SeriesOptions options = looks ? different_looks() : SeriesOptions{};
      Ending ending = Ending::kNone;
      const std::vector<std::string> expected = take_with(0, kSixRooks, options, count, &ending);
      CHECK(expected.size() == std::min<std::size_t>(count, looks ? 90 : 720));
      CHECK(std::set<std::string>(expected.begin(), expected.end()).size() == expected.size());
      for (const std::size_t jobs : {2, 3, 8, 20}) {
        CAPTURE(jobs);
        Ending other = Ending::kNone;
        CHECK(take_with(jobs, kSixRooks, options, count, &other) == expected);
        CHECK(other == ending);
      }
    }
  }
}

TEST_CASE("series: a search at work beside others hands on its errors, in its turn") {
  // Half of all executions come to a mistake, which is looked for before anything is found.
  const char* const text = "x = range(0, 99);\nif x > 49 { y = 1 + \"a\"; }\nreturn x;\n";
  const Program program = program_of(text);
  SeriesOptions options;
  options.jobs = 2;
  Series series(program, {}, {}, options);
  CHECK_THROWS_AS(series.next(), ProgramError);
}

TEST_CASE("series: searches at work beside others end when they are told to") {
  const char* const text = "x = [range(0, 1000) for i in 1..20]; assert(sum(x) == 999); return x;";
  const Program program = program_of(text);
  SeriesOptions options;
  options.jobs = 3;
  StopSignal stop;
  TracingOptions tracing;
  tracing.limits.stop = &stop;
  Series series(program, {}, tracing, options);
  REQUIRE(series.next());
  stop.request();
  while (series.next()) {
  }
  CHECK(series.ending() == Ending::kStopped);
}

/// How often a series that gives so many solutions runs the program with one.
std::uint64_t replays(Replay replay, bool diverse, std::size_t jobs, std::size_t count) {
  const Program program = program_of(kSixRooks);
  SeriesOptions options;
  options.jobs = jobs;
  TracingOptions tracing;
  tracing.replay = replay;
  tracing.diverse = diverse;
  Series series(program, {}, tracing, options);
  CHECK(take(series, count).size() == count);
  return series.times().replays;
}

TEST_CASE("series: every solution is run where that is asked for, and few where it is not") {
  CHECK(replays(Replay::kEvery, false, 0, 100) == 100);
  CHECK(replays(Replay::kSome, false, 0, 100) == 2);    // the first and the sixteenth
  CHECK(replays(Replay::kEvery, true, 0, 100) >= 100);  // more where two blocks find the same
  CHECK(replays(Replay::kSome, true, 0, 100) < 20);
  CHECK(replays(Replay::kEvery, true, 3, 100) >= 100);
  CHECK(replays(Replay::kSome, true, 3, 100) < 20);
}

TEST_CASE("series: every solution is run by default, also those that come from an earlier run") {
  const Program program = program_of(kSixRooks);
  Series first(program, {}, {}, {});
  const std::vector<ChosenValues> earlier = take_choices(first, 3);
  CHECK(first.times().replays == 3);
  Series second(program, {}, {}, {});
  second.resume(earlier);
  CHECK(second.times().replays == 3);
}

ChosenValue int_choice(const char* address, std::int64_t value) {
  return {address, Distribution::Family::kRange, TypedScalar::of(value)};
}

TEST_CASE("series: what is no solution of the program is refused, by its number") {
  const Program program = program_of("x = range(0, 3); y = range(0, 3); assert(x < y); return x;");
  const std::vector<std::vector<ChosenValues>> wrong = {
      {{int_choice("x", 2), int_choice("y", 1)}},   // its assert fails
      {{int_choice("x", -1), int_choice("y", 1)}},  // a value out of the range
      {{int_choice("x", 1)}},                       // a choice is missing
      {{int_choice("x", 1), int_choice("y", 2), int_choice("z", 2)}},
  };
  for (const auto& earlier : wrong) {
    Series series(program, {}, {}, {});
    CHECK_THROWS_WITH_AS(series.resume(earlier), doctest::Contains("solution 1 is none of this program"),
                         NotASolution);
  }
}

TEST_CASE("series: a solution is not found again over a choice whose range grew with the paths explored") {
  // The range of m depends on a path that demand opens last.
  const Program program = program_of(
      "deep = flip();\nn = 3;\n"
      "if deep then { if flip() { if flip() { if flip() { if flip() { if flip() { n = 10; } } } } } }\n"
      "m = range(0, n);\nassert(m < 5);\nreturn [deep, m, n];\n");
  TracingOptions options;
  options.exploration.unasked_sides = 0;
  options.exploration.levels = 1;
  options.exploration.grant = 1;
  TracingEngine engine(program, {}, options);
  CHECK(all_solutions(engine).size() == 29);  // checks that each comes once
  CHECK(engine.traced().solver().passes() > 2);
  check_that_nothing_is_left(engine);  // though the formula knows the last pass only
}

TEST_CASE("series: each pass goes on where the one before had opened as many sides as it may") {
  const Program program = program_of(
      "n = 0;\nfor i in 1..40 { if flip() then { n = n + range(1, 2); } else n = n + range(0, 1); }\n"
      "assert(n == 79);\nreturn n;\n");
  TracingOptions options;
  options.exploration.unasked_sides = 10;
  TracingEngine engine(program, {}, options);
  CHECK(all_solutions(engine).size() == 80);
  CHECK(engine.traced().solver().passes() <= 80 / 10);
}

}  // namespace
}  // namespace solitaire
