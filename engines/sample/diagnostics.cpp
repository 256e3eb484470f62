#include "engines/sample/diagnostics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engines/sample/autocovariance.h"
#include "engines/sample/normal_quantile.h"

namespace solitaire {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// Halves of chains that are shorter tell nothing.
constexpr std::size_t kLeastDraws = 4;

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

/// Numbers in the place of values: those of a normal distribution with the same ranks, where equal values
/// share a rank (Blom 1958).
ChainDraws rank_normalized(const ChainDraws& chains) {
  const std::vector<double> all = joined(chains);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a] < all[b]; });
  std::vector<double> normal(all.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && all[order[end]] == all[order[begin]]) ++end;
    const double rank = 0.5 * static_cast<double>(begin + 1 + end);
    const double share = (rank - 0.375) / (static_cast<double>(all.size()) + 0.25);
    for (; begin < end; ++begin) normal[order[begin]] = normal_quantile(share);
  }
  ChainDraws result = chains;
  auto next = normal.begin();
  for (auto& chain : result) {
    std::copy_n(next, chain.size(), chain.begin());
    next += static_cast<std::ptrdiff_t>(chain.size());
  }
  return result;
}

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
  return std::max(plain_rhat(rank_normalized(halves)), plain_rhat(rank_normalized(folded)));
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

double tail_size(const ChainDraws& halves, double low, double high) {
  const auto below = [&](double limit) {
    return effective_size(each(halves, [=](double x) { return x <= limit ? 1.0 : 0.0; }));
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
  made.ess_bulk = effective_size(rank_normalized(halves));
  made.ess_tail = tail_size(halves, made.q5, made.q95);
  if (std::isnan(made.ess_tail)) made.ess_tail = made.ess_bulk;  // a value that fills the tail
  made.mcse = made.sd / std::sqrt(effective_size(halves));
  made.rhat = split_rhat(halves, made.q50);
  return made;
}

}  // namespace solitaire
