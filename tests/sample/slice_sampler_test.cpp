// Slice sampling of one choice, all else being fixed, against distributions that are known or integrated
// numerically.
#include "engines/sample/shred/slice_sampler.h"

#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <numeric>

#include "engines/sample/diagnostics/draw_summary.h"
#include "tests/sample/traced.h"

namespace solitaire {
namespace {

using Density = std::function<double(double)>;

struct Line {
  const char* text;  // its first choice is what moves
  Density log_density;
  double low, high, step;  // where the choice is, and how finely it is integrated: by 1 for an int
  bool learns = true;      // the width of the first interval
};

const Line kLines[] = {
    {"s = exponential(1); for y in [0.7, -2, 1.1]: observe(Normal(0, s), y); return s;",
     [](double s) { return -s - 3 * std::log(s) - (0.49 + 4 + 1.21) / (2 * s * s); }, 0.05, 20, 0.002},
    {"p = beta(2, 3); observe(Flip(0.2 + 0.5 * p), true); observe(Flip(p * p), false); return p;",
     [](double p) {
       return std::log(p) + 2 * std::log(1 - p) + std::log(0.2 + 0.5 * p) + std::log(1 - p * p);
     },
     0.0005, 1, 0.001},
    {"u = uniform(-1, 3); factor(-pow(u - 2.5, 2)); return u;",
     [](double u) { return -(u - 2.5) * (u - 2.5); }, -1, 3, 0.001},
    // Two modes, with next to nothing between them for a walk to stand on.
    {"m = normal(0, 3); observe(Normal(m * m, 1.5), 4); return m;",
     [](double m) { return -m * m / 18 - (m * m - 4) * (m * m - 4) / 4.5; }, -8, 8, 0.002},
    {"n = poisson(4); observe(Normal(n, 2), 7); return n;",
     [](double n) { return n * std::log(4) - std::lgamma(n + 1) - (n - 7) * (n - 7) / 8; }, 0, 60, 1},
    {"g = geometric(0.3); factor(0.2 * g - 0.01 * g * g); return g;",
     [](double g) { return g * std::log(0.7) + 0.2 * g - 0.01 * g * g; }, 0, 200, 1},
    // A gap that an interval of the usual width, 5, steps over now and then, from either side as often.
    {"u = normal(4.5, 5); factor(cond(abs(u - 4.5) > 4.5, -1000, 0) + cond(abs(u - 2.5) < 1.5, -1000, "
     "0)); return u;",
     [](double u) {
       return ((u >= 0 && u <= 1) || (u >= 4 && u <= 9) ? 0.0 : -1000.0) - (u - 4.5) * (u - 4.5) / 50;
     },
     0.0005, 9, 0.001, false},
};

/// The integral of f times the density.
double integral(const Line& line, const Density& f) {
  double sum = 0;
  for (double x = line.low; x <= line.high; x += line.step) sum += f(x) * std::exp(line.log_density(x));
  return sum;
}

void check_mean(const Line& line, const std::vector<double>& draws, const Density& f) {
  std::vector<double> values;
  for (const double draw : draws) values.push_back(f(draw));
  const DrawSummary found = summarize({values});
  const double exact = integral(line, f) / integral(line, [](double) { return 1.0; });
  CAPTURE(line.text);
  CAPTURE(found.mean);
  CAPTURE(exact);
  CAPTURE(found.mcse);
  CHECK(std::abs(found.mean - exact) < 4 * found.mcse);
  CHECK(found.ess_bulk > 500);
}

TEST_CASE("slice sampling: draws have the moments of the density along a choice") {
  for (const Line& line : kLines) {
    Traced traced(line.text, 3);
    Kernel& kernel = traced.kernel();
    SliceSampler sampler(traced.stream);
    std::vector<double> draws;
    const bool is_float = kernel.domain(0).type() == Type::kFloat;
    for (int i = 0; i < 11'000; ++i) {
      const Scalar value = sampler.draw(kernel, 0, line.learns && i < 1000);
      if (bits_of(value) != bits_of(kernel.value(0))) {
        REQUIRE(kernel.propose(0, value) == Kernel::Outcome::kScored);
        kernel.accept();
      }
      if (i >= 1000) draws.push_back(is_float ? value.f : static_cast<double>(value.i));
    }
    const double center =
        std::accumulate(draws.begin(), draws.end(), 0.0) / static_cast<double>(draws.size());
    check_mean(line, draws, [](double x) { return x; });
    check_mean(line, draws, [=](double x) { return (x - center) * (x - center); });
    check_mean(line, draws, [=](double x) { return x < center ? 1.0 : 0.0; });
  }
}

}  // namespace
}  // namespace solitaire
