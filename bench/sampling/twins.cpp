// Models of examples/sampling/ as one would write them by hand: single-site Metropolis-Hastings in C++, once
// computing the whole density for each step ("rescoring") and once only what changes ("incremental"). Prints
// a line for each, with its steps in a second: best of five runs.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "base/random.h"
#include "tracegraph/drawing.h"

namespace {

using solitaire::draw_normal;
using solitaire::Purpose;
using solitaire::RandomStream;

constexpr double kSeconds = 0.4;
constexpr int kRounds = 5;

template <class Model>
void measure(const char* name) {
  double best = 0;
  double shown = 0;
  for (int round = 0; round < kRounds; ++round) {
    RandomStream stream(1, Purpose::kSample, static_cast<std::uint64_t>(round));
    Model model(stream);
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    std::size_t steps = 0;
    while (seconds() < kSeconds) {
      for (int i = 0; i < 1000; ++i) model.step(stream);
      steps += 1000;
    }
    best = std::max(best, static_cast<double>(steps) / seconds());
    shown = model.shown();
  }
  std::printf("%s %.0f %g\n", name, best, shown);
}

bool accepts(double log_ratio, RandomStream& stream) { return std::log(stream.uniform()) < log_ratio; }

// ---- the Ising line

constexpr std::size_t kSpins = 100;

struct IsingIncremental {
  explicit IsingIncremental(RandomStream&) : spin(kSpins, 0) {}
  void step(RandomStream& stream) {
    const std::size_t i = stream.below(kSpins);
    double difference = 0;
    if (i > 0) difference += spin[i] == spin[i - 1] ? -10 : 10;
    if (i + 1 < kSpins) difference += spin[i] == spin[i + 1] ? -10 : 10;
    if (accepts(difference, stream)) spin[i] ^= 1;
  }
  double shown() const { return std::accumulate(spin.begin(), spin.end(), 0.0); }
  std::vector<int> spin;
};

struct IsingRescoring {
  explicit IsingRescoring(RandomStream&) : spin(kSpins, 0) {}
  double score() const {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < kSpins; ++i) sum += spin[i] == spin[i + 1] ? 0 : -10;
    return sum;
  }
  void step(RandomStream& stream) {
    const std::size_t i = stream.below(kSpins);
    spin[i] ^= 1;
    const double proposed = score();
    if (accepts(proposed - present, stream)) {
      present = proposed;
    } else {
      spin[i] ^= 1;
    }
  }
  double shown() const { return present; }
  std::vector<int> spin;
  double present = 0;
};

// ---- the regression line

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

int main() {
  measure<IsingIncremental>("ising incremental");
  measure<IsingRescoring>("ising rescoring");
  measure<RegressionIncremental>("regression incremental");
  measure<RegressionRescoring>("regression rescoring");
}
