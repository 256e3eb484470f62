// Sampling by nested bounds: every solution with the same probability, by a chi-square test against all
// solutions that there are; and how many there are, from how many attempts fail.
#include "engines/count/nested/nested_sampler.h"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/count/estimate.h"
#include "tests/support/chi_square.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

/// A program whose choices are all tied to each other.
class TiedProgram {
 public:
  explicit TiedProgram(const char* text) : program_(program_of(text)), traced_(program_, {}, {}) {
    REQUIRE(traced_.explore_fully());
    space_.emplace(traced_);
    REQUIRE(space_->parts().size() == 1);
  }

  SpacePart& part() { return space_->parts().front(); }
  std::vector<VariableValues> all() {
    std::vector<VariableValues> solutions;
    for (const BitModel& model : part().find({}, SIZE_MAX, stop_)) {
      solutions.push_back(space_->lowest());
      part().decode(model, solutions.back());
    }
    return solutions;
  }
  NestedSampler sampler(const NestedLimits& limits) {
    auto sampler = part().nested_sampler(RandomStream(1, Purpose::kCells, 0), stop_, limits);
    REQUIRE(sampler);
    CHECK(sampler->clusters().size() > 1);
    return std::move(*sampler);
  }
  VariableValues draw(NestedSampler& sampler, RandomStream& random) {
    VariableValues values = space_->lowest();
    sampler.clusters().decode(sampler.draw(random, stop_), values);
    return values;
  }

 private:
  Program program_;
  TracedProgram traced_;
  std::optional<SolutionSpace> space_;
  StopSignal stop_;
};

/// Things that do not overlap, of which one turns: 496 solutions.
constexpr const char* kThings =
    "import \"std/layout.sol\";\n"
    "a = Thing(\"a\", 2, 1, range(0, 1), range(0, 3), range(0, 3));\n"
    "b = Thing(\"b\", 2, 2, 0, range(0, 2), range(0, 2));\n"
    "c = Thing(\"c\", 1, 1, 0, range(0, 3), range(0, 3));\n"
    "assert(inside(a, Rect(0, 0, 4, 4)));\n"
    "assert(all_apart([a, b, c]));\n"
    "assert(touching(a, b));\n"
    "return a.x;\n";
/// A condition on all choices together, which says nothing before the last one is left.
constexpr const char* kSum = "d = [range(1, 6) for i in 1..5];\nassert(sum(d) == 12);\nreturn d;\n";
/// Operations that have no value for some choices, and operations of all kinds.
constexpr const char* kOperations =
    "a, b, c = range(-4, 8), range(0, 4), range(0, 9, 3);\n"
    "if b != 0 { assert(a / b == 1 or a % b == 1); } else { assert(abs(a) < 3); }\n"
    "assert(max(a, c) - min(b, c) != 2 and b * c < 30 and (a < b) == (b < c));\n"
    "return [a, b, c];\n";
/// Choices that some executions do not meet.
constexpr const char* kUnequalPaths =
    "n = range(0, 3);\nxs = [range(0, 4) for i in 1..n];\nassert(sum(xs) % 3 != 1);\n"
    "if flip() { assert(length(xs) != 2); }\nreturn xs;\n";

TEST_CASE("nested bounds: solutions are alike probable (slow)") {
  for (const char* text : {kThings, kSum, kOperations, kUnequalPaths}) {
    // Once all places are kept, the bounds of small programs are exact; without any, most attempts fail.
    for (const NestedLimits limits :
         {NestedLimits{1}, NestedLimits{40}, NestedLimits{1, 0}, NestedLimits{40, 0}}) {
      CAPTURE(text);
      CAPTURE(limits.most_in_cluster);
      CAPTURE(limits.most_cases_kept);
      TiedProgram program(text);
      DrawCounts tally;
      for (const VariableValues& solution : program.all())
        tally[fmt::format("{}", fmt::join(solution, " "))] = 0;
      const std::size_t count = tally.size();
      NestedSampler sampler = program.sampler(limits);
      CHECK(sampler.bound() >= static_cast<double>(count) * (1 - 1e-9));
      RandomStream random(2, Purpose::kSample, 0);
      for (std::size_t i = 0; i < 20 * count; ++i)
        ++tally[fmt::format("{}", fmt::join(program.draw(sampler, random), " "))];
      CHECK(tally.size() == count);
      CHECK_FALSE(uneven(tally));
    }
  }
}

TEST_CASE("nested bounds: estimates are within their tolerance as often as they say") {
  TiedProgram program(kSum);
  const double known = std::log10(static_cast<double>(program.all().size()));
  NestedSampler sampler = program.sampler({1});
  const StopSignal stop;
  std::size_t off = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    const Estimate estimate =
        estimate_solutions(sampler, {0.3, 0.9}, RandomStream(3, Purpose::kCount, index), stop);
    if (std::abs(estimate.log10 - known) > std::log10(1.3)) ++off;
  }
  CHECK(off < 65);  // 40 on the average; more than 64 in one of 30,000 such tests
  CHECK(off > 15);  // more successes are not waited for than are needed
}

TEST_CASE("nested bounds: what cannot be put into clusters is refused") {
  for (const char* text :
       {"x = range(0, 100000);\ny = range(0, 1);\nassert(x + y != 7);\nreturn x;\n",
        "x = range(0, 3);\ny = range(0, 3);\nassert(x * 3000000000 < y * 2000000000);\nreturn x;\n"}) {
    CAPTURE(text);
    TiedProgram program(text);
    CHECK_FALSE(program.part().nested_sampler(RandomStream(1, Purpose::kCells, 0), StopSignal()));
  }
}

}  // namespace
}  // namespace solitaire
