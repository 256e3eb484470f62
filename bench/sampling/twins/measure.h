#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "base/random.h"
#include "tracegraph/drawing.h"

// Models of examples/sampling/ as one would write them by hand: single-site Metropolis-Hastings in C++, once
// computing the whole density for each step ("rescoring") and once only what changes ("incremental"). A model
// is made with a stream of random numbers and has `step(stream)` and `shown()`, a number that depends on its
// state, so that the compiler leaves nothing out.

namespace twins {

using solitaire::draw_normal;
using solitaire::RandomStream;

inline bool accepts(double log_ratio, RandomStream& stream) { return std::log(stream.uniform()) < log_ratio; }

/// log density of a normal distribution with a precision, without its constant.
inline double log_normal(double x, double mean, double precision) {
  return 0.5 * std::log(precision) - 0.5 * precision * (x - mean) * (x - mean);
}

/// Measures what was asked for and prints a line for it: model, kind, steps a second, the mean of shown().
class Measurement {
 public:
  /// The name of a model and a kind, such as "rats incremental", or "" for all.
  Measurement(std::string only, double seconds) : only_(std::move(only)), seconds_(seconds) {}

  template <class Model>
  void operator()(const std::string& name, std::uint64_t seed) const {
    if (!only_.empty() && only_ != name) return;
    RandomStream stream(seed, solitaire::Purpose::kSample, 1);
    Model model(stream);
    const std::clock_t start = std::clock();  // of the processor, whatever else it does
    const auto elapsed = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
    std::uint64_t steps = 0, reads = 0;
    double sum = 0;
    while (elapsed() < seconds_) {
      for (int i = 0; i < 1000; ++i) model.step(stream);
      steps += 1000;
      sum += model.shown();
      ++reads;
    }
    std::printf("%s %.0f %g\n", name.c_str(), static_cast<double>(steps) / elapsed(),
                sum / static_cast<double>(reads));
  }

 private:
  std::string only_;
  double seconds_;
};

// One function for each file.
void measure_ising(const Measurement& measure, std::uint64_t seed);
void measure_regression(const Measurement& measure, std::uint64_t seed);
void measure_rats(const Measurement& measure, std::uint64_t seed);
void measure_mixtures(const Measurement& measure, std::uint64_t seed);
void measure_topics(const Measurement& measure, std::uint64_t seed);
void measure_citations(const Measurement& measure, std::uint64_t seed);
void measure_open(const Measurement& measure, std::uint64_t seed);
void measure_layouts(const Measurement& measure, std::uint64_t seed);

}  // namespace twins
