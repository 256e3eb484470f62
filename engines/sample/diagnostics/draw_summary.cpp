#include "engines/sample/diagnostics/draw_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engines/sample/diagnostics/autocovariance.h"
#include "engines/sample/diagnostics/normal_quantile.h"

namespace solitaire {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// Halves of chains that are shorter tell nothing.
constexpr std::size_t kLeastDraws = 4;
/// Of longer halves, so many blocks and so many single draws are looked at: their number, and not that of the
/// draws, says how exact the estimates of effective sizes are, and ranks among them are exact enough.
constexpr std::size_t kMostCompared = 8192;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The unbiased estimate; the values are at least two.
double variance_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size() - 1);
}

std::vector<double> joined(const ChainDraws& chains) {
  std::vector<double> all;
  for (const auto& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
  return all;
}

/// Both halves of each chain, without the one in the middle.
ChainDraws split(const ChainDraws& chains) {
  ChainDraws halves;
  for (const auto& chain : chains) {
    const auto half = static_cast<std::ptrdiff_t>(chain.size() / 2);
    halves.emplace_back(chain.begin(), chain.begin() + half);
    halves.emplace_back(chain.end() - half, chain.end());
  }
  return halves;
}

/// Every so many of the draws.
ChainDraws every(const ChainDraws& chains, std::size_t stride) {
  ChainDraws kept(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t i = 0; i < chains[c].size(); i += stride) kept[c].push_back(chains[c][i]);
  return kept;
}

/// Numbers in the place of values: those of a normal distribution with the same ranks, where equal values
/// share a rank (Blom 1958).
class NormalScores {
 public:
  /// The ranks are those among these values.
  explicit NormalScores(const ChainDraws& chains) : sorted_(joined(chains)) {
    std::sort(sorted_.begin(), sorted_.end());
    const auto size = static_cast<double>(sorted_.size());
    for (std::size_t twice = 0; twice <= 2 * sorted_.size(); ++twice)
      scores_.push_back(normal_quantile((0.5 * static_cast<double>(twice + 1) - 0.375) / (size + 0.25)));
  }
  double operator()(double value) const {
    const auto [low, high] = std::equal_range(sorted_.begin(), sorted_.end(), value);
    return scores_[static_cast<std::size_t>((low - sorted_.begin()) + (high - sorted_.begin()))];
  }

 private:
  std::vector<double> sorted_;
  std::vector<double> scores_;  // by how many values are less, and how many are not greater, together
};

template <class Function>
ChainDraws each(const ChainDraws& chains, Function f) {
  ChainDraws result = chains;
  for (auto& chain : result) std::transform(chain.begin(), chain.end(), chain.begin(), f);
  return result;
}

struct Variances {
  double within = 0;
  double total = 0;  // estimated from within and between chains
};

Variances variances(const ChainDraws& chains) {
  const auto length = static_cast<double>(chains.front().size());
  std::vector<double> means;
  double within = 0;
  for (const auto& chain : chains) {
    means.push_back(mean_of(chain));
    within += variance_of(chain) / static_cast<double>(chains.size());
  }
  const double between = chains.size() > 1 ? variance_of(means) : 0;
  return {within, within * (length - 1) / length + between};
}

double plain_rhat(const ChainDraws& chains) {
  const Variances found = variances(chains);
  return std::sqrt(found.total / found.within);
}

double split_rhat(const ChainDraws& halves, double median) {
  const ChainDraws folded = each(halves, [=](double x) { return std::abs(x - median); });
  return std::max(plain_rhat(each(halves, NormalScores(halves))),
                  plain_rhat(each(folded, NormalScores(folded))));
}

/// Means over all chains.
std::vector<double> mean_autocovariances(const ChainDraws& chains) {
  std::vector<double> means(chains.front().size(), 0);
  for (const auto& chain : chains) {
    const std::vector<double> own = autocovariances(chain);
    for (std::size_t i = 0; i < means.size(); ++i) means[i] += own[i] / static_cast<double>(chains.size());
  }
  return means;
}

/// The means of so many draws that follow each other, as many as fit.
ChainDraws block_means(const ChainDraws& chains, std::size_t length) {
  ChainDraws means(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t i = 0; i + length <= chains[c].size(); i += length)
      means[c].push_back(mean_of(std::span(chains[c]).subspan(i, length)));
  return means;
}

/// The effective size of f(draws). It is the ratio of the variance of single draws and of their mean, and
/// means of blocks have the same mean, which is all that long chains need.
template <class Function>
double size_in_blocks(const ChainDraws& halves, std::size_t length, Function f) {
  const ChainDraws values = each(halves, f);
  if (length == 1) return effective_size(values);
  const ChainDraws blocks = block_means(values, length);
  return effective_size(blocks) * variances(values).total / variances(blocks).total;
}

double tail_size(const ChainDraws& halves, std::size_t block, double low, double high) {
  const auto below = [&](double limit) {
    return size_in_blocks(halves, block, [=](double x) { return x <= limit ? 1.0 : 0.0; });
  };
  return std::min(below(low), below(high));
}

}  // namespace

double quantile(std::span<const double> sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double effective_size(const ChainDraws& chains) {
  const std::size_t length = chains.front().size();
  const auto count = static_cast<double>(length * chains.size());
  const Variances found = variances(chains);
  if (!(found.total > 0)) return kUnknown;
  const std::vector<double> covariances = mean_autocovariances(chains);
  const auto correlation = [&](std::size_t lag) {
    if (lag == 0) return 1.0;
    return 1 -
           (found.within - covariances[lag] * static_cast<double>(length) / static_cast<double>(length - 1)) /
               found.total;
  };
  double sum = 0;
  double last_pair = std::numeric_limits<double>::infinity();
  for (std::size_t lag = 0; lag + 1 < length; lag += 2) {
    const double pair = std::min(correlation(lag) + correlation(lag + 1), last_pair);
    if (!(pair > 0)) break;
    sum += pair;
    last_pair = pair;
  }
  const double time = std::max(2 * sum - 1, 1 / std::log10(count));
  return count / time;
}

DrawSummary summarize(const ChainDraws& chains) {
  std::vector<double> sorted = joined(chains);
  std::sort(sorted.begin(), sorted.end());
  DrawSummary made;
  made.mean = mean_of(sorted);
  made.sd = sorted.size() > 1 ? std::sqrt(variance_of(sorted)) : kUnknown;
  made.q5 = quantile(sorted, 0.05);
  made.q50 = quantile(sorted, 0.5);
  made.q95 = quantile(sorted, 0.95);
  made.mcse = made.ess_bulk = made.ess_tail = made.rhat = kUnknown;
  if (sorted.front() == sorted.back()) {  // of which the mean is known, as far as draws can tell
    made.mcse = 0;
    return made;
  }
  if (chains.front().size() / 2 < kLeastDraws) return made;
  const ChainDraws halves = split(chains);
  const std::size_t block = (halves.front().size() + kMostCompared - 1) / kMostCompared;
  const ChainDraws few = every(halves, block);
  made.ess_bulk = size_in_blocks(halves, block, NormalScores(few));
  made.ess_tail = tail_size(halves, block, made.q5, made.q95);
  if (std::isnan(made.ess_tail)) made.ess_tail = made.ess_bulk;  // a value that fills the tail
  made.mcse = made.sd / std::sqrt(size_in_blocks(halves, block, [](double x) { return x; }));
  made.rhat = split_rhat(few, made.q50);
  return made;
}

}  // namespace solitaire
