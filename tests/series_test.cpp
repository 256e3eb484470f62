// A series of solutions that was interrupted goes on as if it had not been.
#include "engines/series.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "tests/program_run.h"
#include "tests/proof.h"

namespace solitaire {
namespace {

/// 720 solutions, of which several look like each other.
constexpr const char* kRooks =
    "column = [range(0, 5) for row in 0..5];\nassert(distinct(column));\n"
    "for row in 0..5 { place(\"rook\", at: [row, column[row] / 2], size: [1, 1]); }\nreturn 0;\n";

std::vector<std::string> take(Series& series, std::size_t count) {
  std::vector<std::string> taken;
  while (taken.size() < count) {
    const auto solution = series.next();
    if (!solution) break;
    std::string text;
    for (const AnsweredChoice& choice : solution->answers)
      text += fmt::format("{}={} ", choice.address, choice.value);
    taken.push_back(std::move(text));
  }
  return taken;
}

std::vector<KnownChoices> take_choices(Series& series, std::size_t count) {
  std::vector<KnownChoices> taken;
  while (taken.size() < count) taken.push_back(series.next()->answers);
  return taken;
}

void check_resumed(const char* text, const SeriesOptions& options, const std::vector<std::size_t>& cuts,
                   std::size_t count) {
  const Program program = program_of(text);
  TracingOptions tracing;
  tracing.seed = 7;
  Series whole(program, {}, tracing, options);
  const std::vector<std::string> expected = take(whole, count);
  for (const std::size_t cut : cuts) {
    CAPTURE(cut);
    Series first(program, {}, tracing, options);
    const std::vector<KnownChoices> earlier = take_choices(first, cut);
    Series second(program, {}, tracing, options);
    const std::vector<Solution> again = second.resume(earlier);
    REQUIRE(again.size() == cut);
    const std::vector<std::string> rest = take(second, count - cut);
    CHECK(rest ==
          std::vector<std::string>(expected.begin() + static_cast<std::ptrdiff_t>(cut), expected.end()));
    CHECK(second.ending() == whole.ending());
  }
}

TEST_CASE("series: an interrupted one goes on with exactly what would have come, wherever it was cut") {
  check_resumed(kRooks, {false, true}, {0, 1, 31, 32, 33, 63, 64, 65, 90}, 100);
}

TEST_CASE("series: the same without solutions that look like others, to the end of all") {
  check_resumed(kRooks, {true, true}, {0, 5, 32, 50, 90}, 1000);  // there are 90
}

TEST_CASE("series: the same with the best first") {
  check_resumed("x = range(0, 9); y = range(0, 9); assert(x != y); minimize(x / 3 + y / 2); return x;",
                {false, true}, {10, 40}, 90);
}

TEST_CASE("series: one without restarts finds the others, in some order") {
  const Program program = program_of("x = range(0, 19); y = range(0, 1); return x;");
  Series first(program, {}, {}, {false, false});
  const std::vector<KnownChoices> earlier = take_choices(first, 13);
  Series second(program, {}, {}, {false, false});
  second.resume(earlier);
  CHECK(take(second, 100).size() == 40 - 13);
  CHECK(second.ending() == Ending::kExhausted);
}

TEST_CASE("series: what is no solution of the program is refused, by its number") {
  const Program program = program_of("x = range(0, 3); y = range(0, 3); assert(x < y); return x;");
  const std::vector<std::vector<KnownChoices>> wrong = {
      {{{"x", ChoiceKind::kInt, 2}, {"y", ChoiceKind::kInt, 1}}},   // its assert fails
      {{{"x", ChoiceKind::kInt, -1}, {"y", ChoiceKind::kInt, 1}}},  // a value out of the range
      {{{"x", ChoiceKind::kInt, 1}}},                               // a choice is missing
      {{{"x", ChoiceKind::kInt, 1}, {"y", ChoiceKind::kInt, 2}, {"z", ChoiceKind::kInt, 2}}},
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
  CHECK(engine.passes() > 2);
  check_that_nothing_is_left(engine);  // though the formula knows the last pass only
}

}  // namespace
}  // namespace solitaire
