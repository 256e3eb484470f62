#pragma once
#include <span>
#include <vector>

namespace solitaire {

/// The draws of one number, a list for each chain. All lists are as long.
using ChainDraws = std::vector<std::vector<double>>;

/// What draws say about the distribution of a number, and how far that can be trusted. After Vehtari, Gelman,
/// Simpson, Carpenter and Buerkner, "Rank-normalization, folding, and localization: an improved R-hat for
/// assessing convergence of MCMC" (2021). What too few draws, or draws that are all alike, do not tell is
/// NaN.
struct DrawSummary {
  double mean = 0;
  double sd = 0;
  double mcse = 0;  // the standard error of the mean that comes from the draws being finitely many
  double q5 = 0, q50 = 0, q95 = 0;
  double ess_bulk = 0;  // as many independent draws would tell as much about the middle
  double ess_tail = 0;  // and about the quantiles of 5 % and 95 %
  double rhat = 0;      // 1 where chains, and both halves of each, agree; larger where they do not
};

DrawSummary summarize(const ChainDraws& chains);

/// The value below which a share of the values lies, with linear interpolation between neighbours. The values
/// are sorted.
double quantile(std::span<const double> sorted, double share);

/// How many independent draws would give a mean as exact: by the sum of autocorrelations up to where pairs of
/// them are no longer positive (Geyer 1992), over all chains. Chains are not split by this.
double effective_size(const ChainDraws& chains);

}  // namespace solitaire
