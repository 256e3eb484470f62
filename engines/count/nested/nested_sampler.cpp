#include "engines/count/nested/nested_sampler.h"

#include <algorithm>
#include <cmath>

namespace solitaire {
namespace {

/// What it takes to go to a set, and to copy one, as much as to look at so many of its words.
constexpr std::uint64_t kWorkForSet = 5;
constexpr std::uint64_t kWorkForCopy = 30;

/// Thrown where clusters are so large that bounds are too much work.
struct TooMuchWork {};

}  // namespace

NestedSampler::NestedSampler(ClusterNetwork network) : network_(std::move(network)) {
  const Clusters& clusters = network_.clusters();
  start_.chosen.resize(clusters.size());
  start_.is_chosen.resize(clusters.size());
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    start_.left.emplace_back(clusters[i].size);
    start_.sizes.push_back(clusters[i].size);
  }
}

/// Returns how many solutions there are at most below a case of a cluster.
double NestedSampler::bound_of(const State& state, std::size_t cluster, std::uint32_t number) {
  if (work() > most_work_) throw TooMuchWork{};
  double bound = 1;
  for (std::size_t other = 0; other < state.sizes.size() && bound > 0; ++other) {
    if (state.is_chosen[other] || other == cluster) continue;
    if (!network_.tied(cluster, other)) {
      bound *= static_cast<double>(state.sizes[other]);
      continue;
    }
    const CaseSet& beside = network_.beside(cluster, number, other);
    work_ += kWorkForSet + state.left[other].words();
    bound *= static_cast<double>(state.left[other].size_common(beside));
  }
  return bound;
}

NestedSampler::Place NestedSampler::place(const State& state, std::size_t cluster, const StopSignal& stop) {
  Place place;
  state.left[cluster].for_each([&](std::size_t number) {
    if (stop.stopped()) throw Interrupted{};
    const double bound = bound_of(state, cluster, static_cast<std::uint32_t>(number));
    if (bound > 0) place.cases.push_back({static_cast<std::uint32_t>(number), 0, bound});
    place.total += bound;
  });
  return place;
}

/// Returns about what the total of a place would be at which that cluster is chosen, from some of its cases.
double NestedSampler::estimated_total(const State& state, std::size_t cluster) {
  const std::size_t stride = 1 + state.sizes[cluster] / tuning::kCasesForOrder;
  std::size_t position = 0;
  std::size_t looked_at = 0;
  double total = 0;
  state.left[cluster].for_each([&](std::size_t number) {
    if (position++ % stride != 0) return;
    ++looked_at;
    total += bound_of(state, cluster, static_cast<std::uint32_t>(number));
  });
  return total * static_cast<double>(position) / static_cast<double>(looked_at);
}

void NestedSampler::choose(State& state, std::size_t cluster, std::uint32_t number) {
  state.chosen[cluster] = number;
  state.is_chosen[cluster] = true;
  for (std::size_t other = 0; other < state.sizes.size(); ++other) {
    if (state.is_chosen[other] || !network_.tied(cluster, other)) continue;
    work_ += kWorkForSet + state.left[other].words();
    state.left[other].intersect(network_.beside(cluster, number, other));
    state.sizes[other] = state.left[other].size();
  }
  for (std::size_t i = 0; i < network_.wide(); ++i) {
    const std::vector<std::size_t>& tied = network_.wide_clusters(i);
    if (std::ranges::find(tied, cluster) == tied.end()) continue;
    const auto is_open = [&](std::size_t other) { return !state.is_chosen[other]; };
    if (std::ranges::count_if(tied, is_open) != 1) continue;
    const std::size_t last = *std::ranges::find_if(tied, is_open);
    state.left[last].intersect(network_.fitting(i, last, state.chosen));
    state.sizes[last] = state.left[last].size();
  }
}

/// Returns the position of a case that is drawn with a probability in proportion to its bound.
std::size_t NestedSampler::picked(const Place& place, RandomStream& random) {
  double at = random.uniform() * place.total;
  std::size_t i = 0;
  while (i + 1 < place.cases.size() && at >= place.cases[i].bound) at -= place.cases[i++].bound;
  return i;
}

/// Finds an order in which bounds fall fast: at each place of an attempt, the cluster comes next that makes
/// the total the smallest.
bool NestedSampler::find_order(RandomStream& random, const StopSignal& stop) {
  for (std::size_t trial = 0; trial < tuning::kTrialsForOrder; ++trial) {
    State state = start_;
    order_.clear();
    while (order_.size() < state.sizes.size()) {
      if (stop.stopped()) throw Interrupted{};
      std::optional<std::size_t> best;
      double least = 0;
      for (std::size_t cluster = 0; cluster < state.sizes.size(); ++cluster) {
        if (state.is_chosen[cluster]) continue;
        const double total = estimated_total(state, cluster);
        if (best && total >= least) continue;
        best = cluster;
        least = total;
      }
      const Place here = place(state, *best, stop);
      if (here.cases.empty() || !std::isfinite(here.total)) break;
      order_.push_back(*best);
      choose(state, *best, here.cases[picked(here, random)].number);
    }
    if (order_.size() == state.sizes.size()) return true;
  }
  return false;
}

/// The bound of the place at the end of the path is replaced by the total of its cases, which is smaller.
void NestedSampler::tighten(const std::vector<std::pair<std::uint32_t, std::size_t>>& path, double total) {
  for (std::size_t i = path.size(); i-- > 0;) {
    Place& place = places_[path[i].first];
    place.cases[path[i].second].bound = total;
    total = 0;  // added up anew: what is left of a difference of large numbers would be rounding
    work_ += place.cases.size();
    for (const Case& one : place.cases) total += one.bound;
    place.total = total;
  }
}

std::optional<Cases> NestedSampler::attempt(RandomStream& random, const StopSignal& stop, bool keep) {
  if (stop.stopped()) throw Interrupted{};
  State state = start_;
  work_ += kWorkForCopy * state.left.size();
  std::vector<std::pair<std::uint32_t, std::size_t>> path;  // of places that are kept, with the cases taken
  std::uint32_t kept = 0;                                   // the place in places_, while it is a kept one
  bool is_kept = true;
  Place fresh;
  double bound = places_.front().total;
  for (const std::size_t cluster : order_) {
    if (!is_kept) {
      fresh = place(state, cluster, stop);
      if (keep) {
        Case& from = places_[path.back().first].cases[path.back().second];
        from.place = static_cast<std::uint32_t>(places_.size());
        cases_kept_ += fresh.cases.size();
        places_.push_back(fresh);
        tighten(path, fresh.total);
        keep = false;
      }
    }
    const Place& here = is_kept ? places_[kept] : fresh;
    if (here.cases.empty() || random.uniform() * bound >= here.total) return std::nullopt;
    const std::size_t at = picked(here, random);
    const Case& taken = here.cases[at];
    bound = taken.bound;
    choose(state, cluster, taken.number);
    if (is_kept) {
      path.emplace_back(kept, at);
      kept = taken.place;
      is_kept = kept != 0;
    }
  }
  return state.chosen;
}

/// Makes attempts, in rounds of which each takes twice the work of the one before, until what a round costs
/// would draw many solutions. Returns false where that is not in sight.
bool NestedSampler::prepare(RandomStream& random, const StopSignal& stop) {
  for (std::uint64_t most = tuning::kFirstWorkToPrepare;; most *= 2) {
    const std::uint64_t start = work();
    const double bound_before = bound();
    std::uint64_t attempts = 0;
    std::uint64_t successes = 0;
    for (; work() - start < most; ++attempts) {
      successes += attempt(random, stop, cases_kept_ < tuning::kMostCasesKept) ? 1 : 0;
    }
    success_ = static_cast<double>(successes) / static_cast<double>(attempts);
    if (successes >= tuning::kManyDraws) return true;
    const bool bounds_stay = cases_kept_ >= tuning::kMostCasesKept;
    if (2 * most > tuning::kMostWorkToPrepare || (bounds_stay && successes > 0))
      return successes > 0 && successes >= most / tuning::kMostWorkToDraw;
    if (bounds_stay && most >= tuning::kWorkWithoutSuccess) return false;
    if (most >= tuning::kWorkBeforeDoubt && successes == 0 && 2 * bound() > bound_before) return false;
  }
}

std::optional<NestedSampler> NestedSampler::prepared(ClusterNetwork network, RandomStream random,
                                                     const StopSignal& stop) try {
  NestedSampler sampler(std::move(network));
  if (!sampler.find_order(random, stop)) return std::nullopt;
  sampler.places_.push_back(sampler.place(sampler.start_, sampler.order_.front(), stop));
  if (!sampler.prepare(random, stop)) return std::nullopt;
  sampler.most_work_ = UINT64_MAX;
  return sampler;
} catch (const TooMuchWork&) {
  return std::nullopt;
}

Cases NestedSampler::draw(RandomStream& random, const StopSignal& stop) {
  while (true) {
    if (auto cases = attempt(random, stop, false)) return std::move(*cases);
  }
}

bool NestedSampler::succeeds(RandomStream& random, const StopSignal& stop) {
  return attempt(random, stop, false).has_value();
}

}  // namespace solitaire
