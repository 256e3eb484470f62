// Counting: exactly what brute force finds, and estimates within their tolerance of numbers that are known.
#include "engines/count/counting.h"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "engines/count/estimate.h"
#include "engines/count/solution_space.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

SolutionCount counted(const Program& program, const CountOptions& options = {}) {
  const auto count = SolutionCounter(program, {}, {}, options).run([](const std::string&) {});
  REQUIRE(count);
  return *count;
}

std::string exact(const Program& program) {
  const SolutionCount count = counted(program, {CountOptions::Way::kExact, 0, {}});
  CHECK_FALSE(count.estimate);
  return count.digits();
}

TEST_CASE("counting: exactly the solutions that brute force finds") {
  std::size_t compared = 0;
  for (const char* folder : {"differential", "explain"}) {
    for (const auto& file : std::filesystem::directory_iterator(tests_folder() / folder)) {
      if (file.path().extension() != ".sol") continue;
      if (file.path().stem() == "refused_steps") continue;  // exploring all of it takes minutes
      const std::string path = fmt::format("{}/{}", folder, file.path().filename().string());
      CAPTURE(path);
      std::optional<std::vector<Found>> all;
      std::string count;
      try {
        const Program program = load(path);
        all = brute_force(program, {}, 3000);
        if (all) count = exact(program);
      } catch (
          const ProgramError&) {  // as it should be: these have program_errors, or what no pass can express
        continue;
      }
      if (!all) continue;
      CHECK(count == std::to_string(all->size()));
      ++compared;
    }
  }
  CHECK(compared > 40);
}

TEST_CASE("counting: products of any size") {
  CHECK(exact(program_of("p = [range(0, 9999) for i in 0..2];\nreturn p;\n")) == "1000000000000");
  CHECK(exact(program_of("p = [range(1, 1000000000) for i in 0..4];\nreturn p;\n")) ==
        "1" + std::string(45, '0'));
  CHECK(SolutionCount{{UINT64_MAX, UINT64_MAX}, {}}.digits() == "340282366920938463426481119284349108225");
  CHECK(SolutionCount{{7, 0, 5}, {}}.digits() == "0");
  CHECK(SolutionCount{{}, {}}.digits() == "1");
}

TEST_CASE("counting: estimates are within their tolerance of what is known") {
  const auto check = [](const std::string& text, double known, double tolerance) {
    CAPTURE(text);
    const Program program = program_of(text);
    const SolutionCount count = counted(program, {CountOptions::Way::kApproximate, 0, {tolerance, 0.9}});
    REQUIRE(count.estimate);
    CHECK(std::abs(count.log10() - std::log10(known)) < std::log10(1 + tolerance));
  };
  check("p = [range(0, 6) for i in 0..6];\nassert(distinct(p));\nreturn p;\n", 5040, 0.8);
  check("d = [range(1, 6) for i in 1..8];\nassert(sum(d) == 28);\nreturn d;\n", 135954, 0.8);
  check("x = range(0, 999);\ny = range(0, 999);\nz = range(1, 1000);\nassert(x < y);\nreturn [x, y, z];\n",
        499500e3, 0.5);
}

TEST_CASE("counting: estimates from cells are within their tolerance as often as they say") {
  const Program program =
      program_of("x = range(0, 30);\ny = range(0, 30);\nassert(x < y);\nreturn [x, y];\n");
  TracedProgram traced(program, {}, {});
  REQUIRE(traced.explore_fully());
  SolutionSpace space(traced);
  REQUIRE(space.parts().size() == 1);
  const StopSignal stop;
  int off = 0;
  for (std::uint64_t index = 0; index < 10; ++index) {
    const RandomStream random(3, Purpose::kCount, index);
    const Estimate estimate = estimate_models(space.parts().front(), {0.8, 0.9}, random, stop);
    if (std::abs(estimate.log10 - std::log10(465.0)) > std::log10(1.8)) ++off;
  }
  CHECK(off < 5);  // 1 on the average at most; 5 and more in one of 600 such tests
}

TEST_CASE("counting: what is gone through and not kept may be ten times as much as what is listed") {
  const auto count = [](const char* text) {
    return counted(program_of(text), {CountOptions::Way::kExactIfSmall, 100, {}});
  };
  const SolutionCount all = count("x = range(0, 44);\ny = range(0, 44);\nassert(x < y);\nreturn [x, y];\n");
  CHECK(all.digits() == "990");
  CHECK_FALSE(all.estimate);
  const SolutionCount more = count("x = range(0, 49);\ny = range(0, 49);\nassert(x < y);\nreturn [x, y];\n");
  CHECK(more.estimate);  // of 1225
  // What follows from other choices cannot be gone through, so it is listed.
  const SolutionCount followed = count(
      "x = range(0, 44);\naux y = range(0, 44);\nz = range(0, 44);\nassert(y == x);\nassert(y < z);\nreturn "
      "z;\n");
  CHECK(followed.estimate);
}

TEST_CASE("counting: on the command line") {
  const Workplace place;
  const std::string pairs =
      place.file("pairs.sol", "x = range(0, 3);\ny = range(0, 3);\nassert(x < y);\nreturn [x, y];\n");
  const std::string none = place.file("none.sol", "x = range(0, 3);\nassert(x > 5);\n");
  const std::string large =
      place.file("large.sol", "p = [range(0, 13) for i in 0..13];\nassert(distinct(p));\nreturn p;\n");
  const std::string endless =
      place.file("endless.sol", "fun f() { if flip() then return 1 + f(); else return 0; }\nreturn f();\n");
  const Outcome six = run_solitaire({"count", pairs});
  CHECK(six.status == 0);
  CHECK(six.out == "6 solutions\n");
  CHECK(run_solitaire({"count", pairs, "--pin", "x=2"}).out == "1 solution\n");
  CHECK(run_solitaire({"count", pairs, "--json"}).out == "{\"solutions\":6,\"exact\":true}\n");
  CHECK(run_solitaire({"count", none}).out == "0 solutions\n");
  CHECK(run_solitaire({"count", none}).status == 0);
  const Outcome stopped = run_solitaire({"count", large, "--exact", "--timeout", "0.5"});
  CHECK(stopped.status == 4);
  CHECK(stopped.out.find("at least ") == 0);
  CHECK(stopped.out != "at least 0 solutions\n");
  const Outcome unexplored = run_solitaire({"count", endless, "--explore", "random:3"});
  CHECK(unexplored.status == 4);
  CHECK(unexplored.err.find("not all paths could be explored") != std::string::npos);
  CHECK(run_solitaire({"count", pairs, "--exact", "--approximate"}).status == 2);
  CHECK(run_solitaire({"count", pairs, "--pin", "z=2"}).status == 2);
}

}  // namespace
}  // namespace solitaire
