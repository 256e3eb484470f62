// The growth of 30 rats: a line for each, whose ends have a distribution of their own.
#include <array>

#include "bench/sampling/twins/measure.h"

namespace twins {
namespace {

constexpr std::size_t kRats = 30;
constexpr std::size_t kDays = 5;
constexpr double kWeights[kRats][kDays] = {
    {151, 199, 246, 283, 320}, {145, 199, 249, 293, 354}, {147, 214, 263, 312, 328},
    {155, 200, 237, 272, 297}, {135, 188, 230, 280, 323}, {159, 210, 252, 298, 331},
    {141, 189, 231, 275, 305}, {159, 201, 248, 297, 338}, {177, 236, 285, 350, 376},
    {134, 182, 220, 260, 296}, {160, 208, 261, 313, 352}, {143, 188, 220, 273, 314},
    {154, 200, 244, 289, 325}, {171, 221, 270, 326, 358}, {163, 216, 242, 281, 312},
    {160, 207, 248, 288, 324}, {142, 187, 234, 280, 316}, {156, 203, 243, 283, 317},
    {157, 212, 259, 307, 336}, {152, 203, 246, 286, 321}, {154, 205, 253, 298, 334},
    {139, 190, 225, 267, 302}, {146, 191, 229, 272, 302}, {157, 211, 250, 285, 323},
    {132, 185, 237, 286, 331}, {160, 207, 257, 303, 345}, {169, 216, 261, 295, 333},
    {157, 205, 248, 289, 316}, {137, 180, 219, 258, 291}, {153, 200, 244, 286, 324}};

/// Positions of the unknowns: each rat's line, then what is common to all.
constexpr std::size_t kSlopes = kRats;
constexpr std::size_t kMeanAlpha = 2 * kRats, kMeanBeta = kMeanAlpha + 1;
constexpr std::size_t kTau = kMeanAlpha + 2, kTauAlpha = kTau + 1, kTauBeta = kTau + 2;
constexpr std::size_t kUnknowns = kTau + 3;

struct Rats {
  explicit Rats(RandomStream&) {
    for (std::size_t i = 0; i < kRats; ++i) {
      at[i] = 240;
      at[kSlopes + i] = 6;
    }
    at[kMeanAlpha] = 240;
    at[kMeanBeta] = 6;
    at[kTau] = 0.03;
    at[kTauAlpha] = 0.005;
    at[kTauBeta] = 4;
  }

  double squares(std::size_t rat) const {
    double sum = 0;
    for (std::size_t j = 0; j < kDays; ++j) {
      const double error =
          kWeights[rat][j] - at[rat] - at[kSlopes + rat] * (7.0 * static_cast<double>(j) - 14);
      sum += error * error;
    }
    return sum;
  }
  double data_of(std::size_t rat) const {
    return 0.5 * kDays * std::log(at[kTau]) - 0.5 * at[kTau] * squares(rat);
  }
  double alpha_of(std::size_t rat) const { return log_normal(at[rat], at[kMeanAlpha], at[kTauAlpha]); }
  double beta_of(std::size_t rat) const { return log_normal(at[kSlopes + rat], at[kMeanBeta], at[kTauBeta]); }
  double prior_of_mean(std::size_t which) const { return -0.5e-6 * at[which] * at[which]; }
  double prior_of_tau(std::size_t which) const { return -0.999 * std::log(at[which]) - 0.001 * at[which]; }

  /// Moves one unknown; precisions walk on their logarithms. Returns the logarithm of the ratio of the ways.
  double move(std::size_t which, RandomStream& stream) {
    before = at[which];
    if (which >= kTau) {
      const double step = 0.4 * draw_normal(stream);
      at[which] *= std::exp(step);
      return step;
    }
    at[which] += (which < kSlopes || which == kMeanAlpha ? 3.0 : 0.3) * draw_normal(stream);
    return 0;
  }
  double shown() const { return at[kMeanAlpha]; }

  std::array<double, kUnknowns> at{};
  double before = 0;
};

struct RatsRescoring : Rats {
  explicit RatsRescoring(RandomStream& stream) : Rats(stream), present(score()) {}
  double score() const {
    double sum = prior_of_mean(kMeanAlpha) + prior_of_mean(kMeanBeta);
    for (std::size_t which = kTau; which < kUnknowns; ++which) sum += prior_of_tau(which);
    for (std::size_t rat = 0; rat < kRats; ++rat) sum += alpha_of(rat) + beta_of(rat) + data_of(rat);
    return sum;
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(kUnknowns);
    const double ways = move(which, stream);
    const double proposed = score();
    if (accepts(proposed - present + ways, stream)) {
      present = proposed;
    } else {
      at[which] = before;
    }
  }
  double present;
};

struct RatsIncremental : Rats {
  using Rats::Rats;
  /// What of the score depends on an unknown.
  double score(std::size_t which) const {
    if (which < kSlopes) return alpha_of(which) + data_of(which);
    if (which < kMeanAlpha) return beta_of(which - kSlopes) + data_of(which - kSlopes);
    double sum = which >= kTau ? prior_of_tau(which) : prior_of_mean(which);
    for (std::size_t rat = 0; rat < kRats; ++rat) {
      if (which == kTau) {
        sum += data_of(rat);
      } else {
        sum += which == kMeanAlpha || which == kTauAlpha ? alpha_of(rat) : beta_of(rat);
      }
    }
    return sum;
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(kUnknowns);
    const double present = score(which);
    const double ways = move(which, stream);
    if (!accepts(score(which) - present + ways, stream)) at[which] = before;
  }
};

}  // namespace

void measure_rats(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<RatsIncremental>("rats incremental", seed);
  measure.operator()<RatsRescoring>("rats rescoring", seed);
}

}  // namespace twins
