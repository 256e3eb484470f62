#include <cmath>

#include "tests/sample/traced.h"

namespace solitaire {
namespace {

constexpr const char* kRegression =
    "a = normal(0, 10); b = normal(0, 3); s = gamma(2, 1); loose = normal(5, 1);\n"
    "for x, y in [[1, 2.5], [2, 4.1], [4, 8.3]]: observe(Normal(a + b * x, s), y);\n"
    "return a;";

std::vector<double> present(const Kernel& kernel) {
  std::vector<double> values;
  for (const ChoiceNumber each : kernel.program().block.choices) values.push_back(kernel.value(each).f);
  return values;
}

TEST_CASE("block: floats whose density is that of one normal distribution are drawn together") {
  Traced traced(kRegression, 1);
  CHECK(traced.kernel().program().block.choices == std::vector<ChoiceNumber>{0, 1, 3});
}

TEST_CASE("block: floats that multiply each other, or that a condition holds, are drawn by themselves") {
  Traced product("a = normal(0, 1); b = normal(0, 1); observe(Normal(a * b, 1), 2.0); return a;", 1);
  CHECK(product.kernel().program().block.choices == std::vector<ChoiceNumber>{0});
  Traced ruled(
      "a = normal(0, 1); b = normal(0, 1); assert(a > -5); observe(Normal(a + b, 1), 2.0); return a;", 1);
  CHECK(ruled.kernel().program().block.choices == std::vector<ChoiceNumber>{1});
  // Along a alone or b alone the density is normal, and along both it is not.
  Traced crossed(
      "a = normal(0, 1); b = normal(0, 1); c = normal(0, 1); observe(Normal(a + b * c, 1), 2.0); return a;",
      1);
  CHECK(crossed.kernel().program().block.choices == std::vector<ChoiceNumber>{0, 1});
  Traced of_three("a = normal(0, 1); b = normal(0, 1); c = normal(0, 1); factor(0.1 * a * b * c); return a;",
                  1);
  CHECK(of_three.kernel().program().block.choices == std::vector<ChoiceNumber>{0, 1});
}

/// A density over that of the block given the rest is that of the rest, in which the block's floats do not
/// occur.
TEST_CASE("block: what is left of the density without the block does not depend on its floats") {
  for (const char* text :
       {kRegression,
        "m = normal(0, 2); t = gamma(1, 1); xs = [normal(m, precision: t) for i in 0..3];\n"
        "for i in 0..3: observe(Normal(xs[i] - 0.3 * xs[(i + 1) % 4], 0.5), 1.0 * i); return m;"}) {
    CAPTURE(text);
    Traced traced(text, 3);
    Kernel& kernel = traced.kernel();
    REQUIRE(!kernel.program().block.choices.empty());
    REQUIRE(traced.structure.block.look(kernel));
    kernel.refresh();
    const double rest = kernel.log_score() - traced.structure.block.log_density();
    for (int i = 0; i < 20; ++i) {
      REQUIRE(traced.structure.block.look(kernel));
      std::vector<double> values;
      for (const double each : traced.structure.block.draw(traced.stream)) values.push_back(3 * each);
      REQUIRE(kernel.set_block(values));
      CHECK(present(kernel) == values);
      REQUIRE(traced.structure.block.look(kernel));
      kernel.refresh();
      CHECK(kernel.log_score() - traced.structure.block.log_density() == doctest::Approx(rest).epsilon(1e-9));
    }
  }
}

TEST_CASE("block: draws have the mean and the covariance of the regression") {
  Traced traced(
      "a = normal(0, 10); b = normal(0, 3);\n"
      "for x, y in [[1, 2.5], [2, 4.1], [4, 8.3]]: observe(Normal(a + b * x, 1), y);\nreturn a;",
      2);
  // The precision is [[3.01, 7], [7, 21 + 1/9]], and times the mean it is [14.9, 43.9].
  const double determinant = 3.01 * (21 + 1.0 / 9) - 49;
  const double mean_a = (14.9 * (21 + 1.0 / 9) - 7 * 43.9) / determinant,
               variance_a = (21 + 1.0 / 9) / determinant;
  const double covariance = -7 / determinant, mean_b = (3.01 * 43.9 - 7 * 14.9) / determinant;
  constexpr int kDraws = 40'000;
  double sum_a = 0, sum_square = 0, sum_product = 0;
  for (int i = 0; i < kDraws; ++i) {
    REQUIRE(traced.structure.block.look(traced.kernel()));
    const std::span<const double> drawn = traced.structure.block.draw(traced.stream);
    REQUIRE(traced.kernel().set_block(drawn));
    sum_a += drawn[0] - mean_a;
    sum_square += (drawn[0] - mean_a) * (drawn[0] - mean_a);
    sum_product += (drawn[0] - mean_a) * (drawn[1] - mean_b);
  }
  CHECK(std::abs(sum_a / kDraws) < 5 * std::sqrt(variance_a / kDraws));
  CHECK(sum_square / kDraws == doctest::Approx(variance_a).epsilon(0.04));
  CHECK(sum_product / kDraws == doctest::Approx(covariance).epsilon(0.04));
}

}  // namespace
}  // namespace solitaire
