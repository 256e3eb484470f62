// The two models of which the choices change with others: a sum or a product, and a polynomial of which the
// degree is unknown, by reversible jumps. Both have so few terms that there is nothing to leave out of
// rescoring.
#include <array>

#include "bench/sampling/twins/measure.h"

namespace twins {
namespace {

struct SumOrProduct {
  explicit SumOrProduct(RandomStream&) : present(score()) {}
  double score() const {
    const double made = added ? value[0] + value[1] : value[0] * value[1];
    return log_normal(value[0], 0, 1) + log_normal(value[1], 0, 1) + log_normal(2, made, 4);
  }
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(3);
    const SumOrProduct before = *this;
    if (which == 2) {
      added = !added;
    } else {
      value[which] += 0.8 * draw_normal(stream);
    }
    const double proposed = score();
    if (accepts(proposed - before.present, stream)) {
      present = proposed;
    } else {
      *this = before;
    }
  }
  double shown() const { return added ? 1 : 0; }
  std::array<double, 2> value{0.5, 0.5};
  bool added = true;
  double present;
};

struct Polynomial {
  static constexpr std::size_t kPoints = 9, kMostDegree = 4;
  static constexpr double kY[kPoints] = {3.3, 2.4, 1.9, 0.9, 0.5, 0.4, 0.5, 0.9, 1.6};
  static constexpr double kPrecision = 1 / 0.09;

  explicit Polynomial(RandomStream&) : present(likelihood()) {}
  double likelihood() const {
    double sum = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double x = -1 + 0.25 * static_cast<double>(i);
      double p = 0;
      for (std::size_t k = degree + 1; k-- > 0;) p = p * x + c[k];
      sum -= 0.5 * kPrecision * (kY[i] - p) * (kY[i] - p);
    }
    return sum;
  }
  /// Coefficients that come are drawn from their prior, so that priors cancel; the pick is one of degree + 2.
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(degree + 2);
    const Polynomial before = *this;
    double ratio = 0;
    if (which == degree + 1) {
      degree = 1 + stream.below(kMostDegree);
      for (std::size_t k = before.degree + 1; k <= degree; ++k) c[k] = 3 * draw_normal(stream);
      ratio = std::log(static_cast<double>(before.degree + 2) / static_cast<double>(degree + 2));
    } else {
      c[which] += 0.3 * draw_normal(stream);
      ratio = (before.c[which] * before.c[which] - c[which] * c[which]) / 18;
    }
    const double proposed = likelihood();
    if (accepts(proposed - present + ratio, stream)) {
      present = proposed;
    } else {
      *this = before;
    }
  }
  double shown() const { return degree == 2 ? 1 : 0; }
  std::size_t degree = 2;
  std::array<double, kMostDegree + 1> c{};
  double present;
};

}  // namespace

void measure_open(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<SumOrProduct>("sum_or_product rescoring", seed);
  measure.operator()<Polynomial>("polynomial rescoring", seed);
}

}  // namespace twins
