#include "bench/sampling/twins/measure.h"

namespace twins {
namespace {

struct Line {
  explicit Line(RandomStream& stream) {
    for (int i = 0; i < 100; ++i) {
      x.push_back(-5 + 0.1 * i);
      y.push_back(1 + 2 * x.back() + draw_normal(stream));
    }
  }
  std::vector<double> x, y;
  double value[2] = {0, 0};  // intercept and slope
};

struct RegressionRescoring : Line {
  explicit RegressionRescoring(RandomStream& stream) : Line(stream), present(score()) {}
  double score() const {
    double sum = -0.005 * (value[0] * value[0] + value[1] * value[1]);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double error = y[i] - value[0] - value[1] * x[i];
      sum -= 0.5 * error * error;
    }
    return sum;
  }
  void step(RandomStream& stream) {
    double& changed = value[stream.below(2)];
    const double before = changed;
    changed += 0.2 * draw_normal(stream);
    const double proposed = score();
    if (accepts(proposed - present, stream)) {
      present = proposed;
    } else {
      changed = before;
    }
  }
  double shown() const { return value[1]; }
  double present;
};

/// The data as sums, so that a step takes as long for any number of points.
struct RegressionIncremental : Line {
  explicit RegressionIncremental(RandomStream& stream) : Line(stream) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      sx += x[i];
      sy += y[i];
      sxx += x[i] * x[i];
      sxy += x[i] * y[i];
    }
  }
  double score(double a, double b) const {
    const auto n = static_cast<double>(x.size());
    return -0.005 * (a * a + b * b) + a * sy + b * sxy - 0.5 * (n * a * a + 2 * a * b * sx + b * b * sxx);
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(2);
    double proposed[2] = {value[0], value[1]};
    proposed[which] += 0.2 * draw_normal(stream);
    if (accepts(score(proposed[0], proposed[1]) - score(value[0], value[1]), stream))
      value[which] = proposed[which];
  }
  double shown() const { return value[1]; }
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
};

}  // namespace

void measure_regression(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<RegressionIncremental>("regression incremental", seed);
  measure.operator()<RegressionRescoring>("regression rescoring", seed);
}

}  // namespace twins
