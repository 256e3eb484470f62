// Sampling: every solution with the same probability, by a chi-square test against all solutions that there
// are.
#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/count/uniform_series.h"
#include "tests/support/chi_square.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

/// Programs whose paths have unequally many solutions, with what is pinned.
struct Sampled {
  const char* text;
  std::vector<Pin> pins = {};
};

Pin pin(const char* pattern, std::int64_t value, bool forbidden) {
  return {AddressPattern(pattern), TypedScalar::of(value), forbidden, pattern};
}

const std::vector<Sampled>& sampled() {
  static const std::vector<Sampled> programs = {
      // One solution on a path of one choice, others on paths of two and three.
      {"if flip() { return 0; }\nx = range(0, 5);\nif x > 2 { return x; }\ny = range(0, x + 1);\nreturn [x, "
       "y];\n"},
      // A range that depends on another choice, and steps.
      {"a = range(0, 12, 4);\nx = range(0, a, 2);\nassert(x != 6);\nreturn [a, x];\n"},
      // The same choice on both sides of a branch, with another range on each.
      {"fun pick(n) { return range(0, n); }\nif flip() { n = pick(2); } else { n = pick(9); }\n"
       "assert(n != 1);\nreturn n;\n"},
      // Choices that no condition ties to the others.
      {"f = flip();\ng = range(-1, 1);\nx = range(0, 2);\ny = range(0, 2);\nassert(x < y);\nreturn [f, g, x, "
       "y];\n"},
      // A loop whose length is chosen, with a pin on what only some executions meet.
      {"n = range(0, 3);\nxs = [];\nfor i in 1..n { x = range(0, 2); xs = xs + [x]; }\nassert(n != 2);\n"
       "return xs;\n",
       {pin("x[1]", 1, true)}},
      {"x = range(0, 9);\ny = range(0, x);\nif y > 4 { z = flip(); }\nreturn [x, y];\n",
       {pin("x", 7, false)}},
  };
  return programs;
}

TracingOptions options_of(const Sampled& program, std::uint64_t seed) {
  TracingOptions options;
  options.seed = seed;
  options.pins = program.pins;
  return options;
}

std::string text_of(const Solution& solution) {
  std::string text;
  for (const ChosenValue& choice : solution.choices)
    text += fmt::format("{}={} ", choice.address, to_text(choice.value));
  return text;
}

DrawCounts all_of(const Sampled& program) {
  const Program loaded = program_of(program.text);
  TracingEngine engine(loaded, {}, options_of(program, 0));
  DrawCounts tally;
  while (const auto solution = engine.next()) tally[text_of(*solution)] = 0;
  return tally;
}

/// The first solution of an engine for each of many seeds.
template <typename Make>
DrawCounts first_solutions(const Sampled& program, std::uint64_t seeds, Make make) {
  DrawCounts tally = all_of(program);
  const Program loaded = program_of(program.text);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    auto engine = make(loaded, options_of(program, seed));
    const auto solution = engine.next();
    REQUIRE(solution);
    const auto at = tally.find(text_of(*solution));
    REQUIRE(at != tally.end());
    ++at->second;
  }
  return tally;
}

TEST_CASE("uniform: solutions are alike probable where all are listed (slow)") {
  for (const Sampled& program : sampled()) {
    CAPTURE(program.text);
    CHECK_FALSE(
        uneven(first_solutions(program, 1000, [](const Program& loaded, const TracingOptions& options) {
          return UniformEngine(loaded, {}, options);
        })));
  }
}

TEST_CASE("uniform: the test of evenness fails for the engine that searches") {
  for (const std::size_t number : {0, 2}) {
    CHECK(uneven(
        first_solutions(sampled()[number], 400, [](const Program& loaded, const TracingOptions& options) {
          return TracingEngine(loaded, {}, options);
        })));
  }
}

void check_cells(const Sampled& program) {
  const Program loaded = program_of(program.text);
  TracedProgram traced(loaded, {}, options_of(program, 0));
  REQUIRE(traced.explore_fully());
  SolutionSpace space(traced);
  REQUIRE(space.parts().size() == 1);
  SpacePart& part = space.parts().front();
  const StopSignal stop;
  CellSampler sampler(part, RandomStream(1, Purpose::kCells, 0), stop);
  DrawCounts tally;
  for (const BitModel& model : part.find({}, SIZE_MAX, stop))
    tally[fmt::format("{}", fmt::join(model, ""))] = 0;
  RandomStream random(1, Purpose::kSample, 0);
  for (std::size_t i = 0; i < 5 * tally.size(); ++i)
    ++tally[fmt::format("{}", fmt::join(sampler.draw(random, stop), ""))];
  CHECK_FALSE(uneven(tally));
}

TEST_CASE("uniform: models drawn from cells are alike probable") { check_cells(sampled()[0]); }
TEST_CASE("uniform: models drawn from cells are alike probable in another program") {
  check_cells(sampled()[2]);
}
TEST_CASE("uniform: models drawn from cells are alike probable on unequal paths (slow)") {
  check_cells(
      {"if flip() { x = range(0, 60, 3); return x; }\ny = range(0, 12);\nz = range(0, y);\n"
       "assert(y + z < 18);\nreturn [y, z];\n"});
}

TEST_CASE("uniform: without repetitions each solution comes once, listed or from cells (slow)") {
  for (const Sampled& program : sampled()) {
    CAPTURE(program.text);
    const DrawCounts all = all_of(program);
    for (const std::uint64_t most_listed : {10'000, 0}) {
      const Program loaded = program_of(program.text);
      UniformEngine engine(loaded, {}, options_of(program, 5), {most_listed});
      DrawCounts tally;
      while (const auto solution = engine.next()) ++tally[text_of(*solution)];
      CHECK(engine.ending() == Ending::kExhausted);
      CHECK(tally.size() == all.size());
      for (const auto& [key, times] : tally) CHECK((times == 1 && all.count(key) == 1));
    }
  }
}

/// 720 solutions, of which several look like each other.
constexpr const char* kTwoRooks =
    "column = [range(0, 5) for row in 0..5];\nassert(distinct(column));\n"
    "for row in 0..5 { place(\"rook\", at: [row, column[row] / 2], size: [1, 1]); }\nreturn 0;\n";

std::vector<ChosenValues> take(UniformSeries& series, std::size_t count) {
  std::vector<ChosenValues> taken;
  while (taken.size() < count) {
    const auto solution = series.next();
    if (!solution) break;
    taken.push_back(solution->choices);
  }
  return taken;
}

void check_resumed(const UniformOptions& uniform, bool distinct, const std::vector<std::size_t>& cuts,
                   std::size_t count) {
  const Program program = program_of(kTwoRooks);
  TracingOptions tracing;
  tracing.seed = 7;
  UniformSeries whole(program, {}, tracing, distinct ? Apart::kResult : Apart::kChoices, uniform);
  const std::vector<ChosenValues> expected = take(whole, count);
  for (const std::size_t cut : cuts) {
    CAPTURE(cut);
    UniformSeries series(program, {}, tracing, distinct ? Apart::kResult : Apart::kChoices, uniform);
    const auto middle = expected.begin() + static_cast<std::ptrdiff_t>(cut);
    series.resume({expected.begin(), middle});
    const std::vector<ChosenValues> rest = take(series, count - cut);
    REQUIRE(rest.size() == expected.size() - cut);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      CHECK(std::equal(rest[i].begin(), rest[i].end(), expected[cut + i].begin(),
                       [](const ChosenValue& a, const ChosenValue& b) {
                         return a.address == b.address && a.value == b.value;
                       }));
    }
    CHECK(series.ending() == whole.ending());
  }
}

TEST_CASE("uniform: an interrupted series goes on with exactly what would have come") {
  check_resumed({}, false, {0, 1, 30}, 40);
  check_resumed({}, true, {0, 40, 90}, 100);  // there are 90 looks
  check_resumed({0}, false, {3}, 6);
}

TEST_CASE("uniform: every solution is run where that is asked for") {
  const Program program = program_of(kTwoRooks);
  for (const Replay replay : {Replay::kEvery, Replay::kSome}) {
    TracingOptions tracing;
    tracing.replay = replay;
    UniformEngine engine(program, {}, tracing);
    for (int i = 0; i < 40; ++i) REQUIRE(engine.next());
    CHECK(engine.times().replays == (replay == Replay::kEvery ? 40 : 2));
  }
}

TEST_CASE("uniform: what cannot be sampled is refused") {
  const Program wishes = program_of("x = range(0, 3);\nminimize(x);\nreturn x;\n");
  CHECK_THROWS_AS(UniformEngine(wishes, {}, {}).next(), UnequalSolutions);
  const Program endless =
      program_of("fun f() { if flip() then return 1 + f(); else return 0; }\nreturn f();\n");
  TracingOptions random;
  random.exploration = {Exploration::Policy::kRandom, 3};
  UniformEngine unexplored(endless, {}, random);
  CHECK_FALSE(unexplored.next());
  CHECK(unexplored.ending() == Ending::kUnexplored);
}

TEST_CASE("uniform: a limit ends it in the middle of whatever it does") {
  const Program program = program_of("p = [range(0, 13) for i in 0..13];\nassert(distinct(p));\nreturn p;\n");
  StopSignal stop;
  stop.set_deadline(StopSignal::Clock::now() + std::chrono::milliseconds(300));
  TracingOptions options;
  options.limits.stop = &stop;
  UniformEngine engine(program, {}, options);
  const auto start = StopSignal::Clock::now();
  CHECK_FALSE(engine.next());
  CHECK(engine.ending() == Ending::kStopped);
  CHECK(StopSignal::Clock::now() - start < std::chrono::seconds(3));
}

TEST_CASE("uniform: on the command line") {
  const Workplace place;
  const std::string dice = place.file("dice.sol", "x = range(1, 6);\ny = range(1, x);\nreturn [x, y];\n");
  const std::string wish = place.file("wish.sol", "x = range(1, 6);\nminimize(x);\nreturn x;\n");
  const Outcome all = run_solitaire({"solve", dice, "--sample", "uniform", "-n", "22"});
  CHECK(all.status == 1);
  CHECK(all.err.find("21 solutions") != std::string::npos);
  CHECK(run_solitaire({"solve", dice, "--sample", "uniform", "-n", "22"}).out == all.out);
  CHECK(run_solitaire({"solve", dice, "--sample", "uniform", "-n", "22", "--seed", "1"}).out != all.out);
  CHECK(run_solitaire({"solve", wish, "--sample", "uniform"}).status == 2);
  for (const char* other : {"--all", "--relax", "--formula=a.smt2"})
    CHECK(run_solitaire({"solve", dice, "--sample", "uniform", other}).status == 2);
}

TEST_CASE("uniform: generate writes which engine it was, and goes on with no other") {
  const Workplace place;
  const std::string dice = place.file("dice.sol", "x = range(1, 6);\ny = range(1, x);\nreturn [x, y];\n");
  const std::vector<std::string> command = {"generate", dice,       "-o",     place / "out",
                                            "-q",       "--sample", "uniform"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), command.begin(), command.end());
    return run_solitaire(more).status;
  };
  CHECK(with({"-n", "3"}) == 0);
  CHECK(bytes_of(place / "out/dice-0003.json").find("uniform/cadical") != std::string::npos);
  CHECK(with({"-n", "6", "--resume"}) == 0);
  CHECK(run_solitaire({"generate", dice, "-o", place / "out", "-q", "-n", "8", "--resume"}).status == 3);
  const std::string sixth = bytes_of(place / "out/dice-0006.json");
  CHECK(with({"-n", "6"}) == 0);
  CHECK(bytes_of(place / "out/dice-0006.json") == sixth);
}

}  // namespace
}  // namespace solitaire
