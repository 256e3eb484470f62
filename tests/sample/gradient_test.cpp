// Slopes of densities against differences, and moves along them against distributions in closed form.
#include "kernel/gradient.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

#include "engines/sample/diagnostics/draw_summary.h"
#include "engines/sample/shred/joint_move.h"
#include "engines/sample/shred/trajectory.h"
#include "kernel/compiler.h"
#include "kernel/machine.h"
#include "tests/sample/traced.h"

namespace solitaire {
namespace {

constexpr const char* kSlopeFactors[] = {
    "x + y - 2 * x * y",
    "x / (y + 3)",
    "-(x - y) + 1.5",
    "min(x, y) * 2 + max(x, 0.1 * y)",
    "sqrt(x + 4) * y",
    "exp(0.3 * x)",
    "log(x * x + y * y + 1)",
    "pow(x + 4, 0.5 * y)",
    "pow(y, 3)",
    "sin(x) * x",
    "cos(x * y)",

    "lgamma(x + 4)",
    "floor(x) + 2 * x",
    "abs(x) * y",
    // What is not selected may be undefined.
    "cond(x > 0, sqrt(max(x, 0)), -x) + y",
    "cond(flip(0.5), log(x * x), y)",
};

constexpr const char* kSlopeModels[] = {
    "m = normal(0, 3); s = gamma(2, 1); for y in [0.5, 1.5, 2.0]: observe(Normal(m, precision: s), y); "
    "return m;",
    "p = dirichlet([1, 2, 0.5]); k = [categorical(p) for i in 1..3]; q = [beta(1, 2) for i in 1..3];"
    "for i in 0..2: observe(Flip(q[k[i]]), i != 1); return p;",
    "r = exponential(2); c = poisson(r + 1); u = uniform(0, r + 1); observe(Poisson(exp(0.1 * u) + c), 4); "
    "return r;",
    "a = gamma(3, 2); b = beta(a, 2); g = gamma(a, b); x = normal(g, 1 / sqrt(g)); return x;",
};

/// The values of all floats, each a little away from what it is.
std::vector<double> nearby(Traced& traced) {
  std::vector<double> values;
  for (const ChoiceNumber each : traced.kernel().floats())
    values.push_back(traced.kernel().value(each).f * (1 + 0.01 * traced.stream.uniform()));
  return values;
}

/// Compares slopes with central differences. Returns how many there were.
int compare_slopes(Traced& traced) {
  Kernel& kernel = traced.kernel();
  std::vector<double> at = nearby(traced);
  if (kernel.propose_floats(at) != Kernel::Outcome::kScored) return 0;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < at.size(); ++i) slopes.push_back(kernel.slope(i));
  int compared = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double x = at[i], step = 1e-6 * std::abs(x);
    const auto difference_at = [&](double there) {
      at[i] = there;
      const bool scored = kernel.propose_floats(at) == Kernel::Outcome::kScored;
      at[i] = x;
      return scored ? kernel.difference() : NAN;
    };
    const double expected = (difference_at(x + step) - difference_at(x - step)) / (2 * step);
    if (std::isnan(expected)) continue;
    CAPTURE(i);
    CHECK(std::abs(slopes[i] - expected) <= 1e-4 * (1 + std::abs(expected)));
    ++compared;
  }
  return compared;
}

TEST_CASE("gradient: slopes are those of differences, of every operation") {
  for (const char* factor : kSlopeFactors) {
    const std::string text =
        std::string("x = normal(0, 1); y = normal(0.5, 1.5); factor(") + factor + "); return x;";
    INFO(text);
    int compared = 0;
    for (std::uint64_t seed = 1; seed < 8; ++seed) {
      Traced traced(text.c_str(), seed);
      compared += compare_slopes(traced);
    }
    CHECK(compared > 8);
  }
}

TEST_CASE("gradient: slopes are those of differences, of models") {
  for (const char* text : kSlopeModels) {
    INFO(text);
    int compared = 0;
    for (std::uint64_t seed = 1; seed < 8; ++seed) {
      Traced traced(text, seed);
      compared += compare_slopes(traced);
    }
    CHECK(compared > 8);
  }
}

/// No program comes to this operation, so its code is written here.
TEST_CASE("gradient: slopes of angles") {
  ScoreProgram program;
  program.types.assign(11, Type::kFloat);
  for (const double number : kSlopeNumbers) {
    program.slope_numbers.push_back(static_cast<Cell>(program.cells.size()));
    program.cells.push_back(Scalar::of(number));
  }
  program.cells.resize(11);
  for (const Cell cell : {8U, 9U})
    program.choices.push_back(
        {cell, AddressId{cell}, true, Form::kUnknown, Distribution::normal(0, 1), {0, 1}, {}});
  program.code.push_back({Op::kAtan2, 10, {8, 9, 0}});
  program.terms = {10};
  Kernel kernel(std::move(program));
  for (const double x : {-2.0, 0.3, 4.0}) {
    for (const double y : {-1.0, 0.5, 3.0}) {
      REQUIRE(kernel.load({Scalar::of(y), Scalar::of(x)}) == Kernel::Outcome::kScored);
      REQUIRE(kernel.propose_floats(std::array{y, x}) == Kernel::Outcome::kScored);
      CHECK(kernel.slope(0) == doctest::Approx(x / (x * x + y * y)));
      CHECK(kernel.slope(1) == doctest::Approx(-y / (x * x + y * y)));
    }
  }
}

TEST_CASE("gradient: compiled slopes are those of the machine, bit for bit") {
  for (const char* text : kSlopeModels) {
    INFO(text);
    Traced traced(text, 3);
    Kernel& compiled = traced.kernel();
    Kernel interpreted(compiled.program(), false);
    std::vector<Scalar> present;
    for (ChoiceNumber i = 0; i < compiled.program().choices.size(); ++i) present.push_back(compiled.value(i));
    REQUIRE(interpreted.load(present) == Kernel::Outcome::kScored);
    for (int round = 0; round < 600; ++round) {
      const std::vector<double> at = nearby(traced);
      const auto outcome = compiled.propose_floats(at);
      REQUIRE(interpreted.propose_floats(at) == outcome);
      if (outcome != Kernel::Outcome::kScored) continue;
      CHECK(compiled.difference() == interpreted.difference());
      for (std::size_t i = 0; i < at.size(); ++i) CHECK(compiled.slope(i) == interpreted.slope(i));
    }
  }
}

/// What the numbers of a program are on the average over moves of all floats together, and nothing else, and
/// where all is drawn from the priors, which is how the floats are first placed.
void check_joint_moves(const char* text, std::size_t draws) {
  INFO(text);
  Traced traced(text, 7);
  Kernel& kernel = traced.kernel();
  const auto numbers = [&] {
    std::vector<double> all;
    for (const double x : kernel.outputs()) all.insert(all.end(), {x, x * x});
    return all;
  };
  std::vector<std::vector<double>> prior(2 * kernel.outputs().size()), moved(prior);
  const auto add = [&](std::vector<std::vector<double>>& columns) {
    const std::vector<double> row = numbers();
    for (std::size_t i = 0; i < row.size(); ++i) columns[i].push_back(row[i]);
  };
  JointMove move(kernel.floats().size(), true);
  for (std::size_t i = 0; i < draws; ++i) {
    const auto draw = [&](ChoiceNumber c) { return kernel.distribution(c).sample(traced.stream).scalar(); };
    REQUIRE(kernel.follow(draw) == Kernel::Outcome::kScored);
    add(prior);
    if (i < 200) move.watch(kernel);
  }
  REQUIRE(move.ready());
  for (int i = 0; i < 200; ++i) move.move(kernel, traced.stream, true);
  move.end_warmup();
  for (std::size_t i = 0; i < draws; ++i) {
    move.move(kernel, traced.stream, false);
    add(moved);
  }
  for (std::size_t i = 0; i < prior.size(); ++i) {
    const DrawSummary expected = summarize({prior[i]}), found = summarize({moved[i]});
    CAPTURE(i);
    CAPTURE(expected.mean);
    CAPTURE(found.mean);
    CHECK(std::abs(found.mean - expected.mean) < 4 * std::hypot(found.mcse, expected.mcse));
    CHECK(found.ess_bulk > 0.05 * static_cast<double>(draws));
  }
}

TEST_CASE("joint moves: floats that move together alone are spread as they should be") {
  check_joint_moves("a = normal(1, 1); b = normal(a, 0.1); c = normal(a + b, 0.5); return a, b - a, c;",
                    4000);
  check_joint_moves(
      "g = gamma(3, 2); h = exponential(g + 1); p = beta(2, 3); u = uniform(0, 4);"
      "return log(g), min(h, 2), p, u;",
      4000);
  check_joint_moves("g = gamma(3, 2); u = uniform(0, g + 1); v = uniform(-1, 2); return log(g), u, v;", 4000);
  // Far more than covariances are learned of.
  check_joint_moves("m = normal(0, 1); x = [normal(0.3 * m, 1) for i in 1..40]; return m, sum(x), x[3];",
                    2000);
}

TEST_CASE("joint moves: a trajectory becomes as long as it may where nothing turns it back") {
  Traced traced("return normal(0, 1000000);", 3);
  Spread spread(1);
  for (int i = 0; i < 60; ++i) spread.watch(std::array{i % 2 == 0 ? -1.0 : 1.0});
  REQUIRE(spread.known());
  FloatSpace space(traced.kernel());
  constexpr double kStep = 0.01;
  constexpr int kRuns = 40;
  double squares = 0;
  for (int i = 0; i < kRuns; ++i) {
    const double before = space.present()[0];
    Trajectory(space, spread, kStep, traced.stream).run();
    squares += std::pow((space.present()[0] - before) / kStep, 2);
  }
  // One of the 512 points that came last is drawn. They lie one after the other, up to 1,023 steps away.
  CHECK(std::sqrt(squares / kRuns) > 250);
}

TEST_CASE("gradient: where a change of all floats makes the density infinite, their values are kept") {
  Traced traced("a = normal(0, 1); b = normal(0, 1); factor(1e308 * max(a + b - 50, 0)); return a;", 1);
  Kernel& kernel = traced.kernel();
  CHECK(kernel.propose_floats(std::array{30.0, 40.0}) == Kernel::Outcome::kImpossible);
  const auto infinite = kernel.take_infinite();
  REQUIRE(infinite);
  CHECK((*infinite)[0].f == 30);
  CHECK((*infinite)[1].f == 40);
}

}  // namespace
}  // namespace solitaire
