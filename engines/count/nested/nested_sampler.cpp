#include "engines/count/nested/nested_sampler.h"

#include "engines/count/nested/order_of_clusters.h"
#include "engines/count/nested/tuning.h"

namespace solitaire {

/// Keeps a place that an attempt came to from the last one of its path.
void NestedSampler::keep(const Place& place, const std::vector<Step>& path) {
  places_[path.back().place].cases[path.back().at].place = static_cast<std::uint32_t>(places_.size());
  cases_kept_ += place.cases.size();
  places_.push_back(place);
  tighten(path, place.total);
}

/// The bound of the place at the end of the path is replaced by the total of its cases, which is smaller.
void NestedSampler::tighten(const std::vector<Step>& path, double total) {
  for (std::size_t i = path.size(); i-- > 0;) {
    Place& place = places_[path[i].place];
    place.cases[path[i].at].bound = total;
    total = 0;  // added up anew: what is left of a difference of large numbers would be rounding
    bounds_.count_work(place.cases.size());
    for (const Place::Case& one : place.cases) total += one.bound;
    place.total = total;
  }
}

/// Keeps the first place that was not kept before, if that is asked for.
std::optional<Cases> NestedSampler::attempt(RandomStream& random, const StopSignal& stop, bool keep) {
  if (stop.stopped()) throw Interrupted{};
  PartialChoice choice = bounds_.start();
  std::vector<Step> path;  // of places that are kept
  std::uint32_t kept = 0;  // the place in places_, while it is a kept one
  bool is_kept = true;
  Place fresh;
  double bound = this->bound();
  for (const std::size_t cluster : order_) {
    if (!is_kept) {
      fresh = bounds_.place(choice, cluster, stop);
      if (keep) this->keep(fresh, path);
      keep = false;
    }
    const Place& here = is_kept ? places_[kept] : fresh;
    if (here.cases.empty() || random.uniform() * bound >= here.total) return std::nullopt;
    const std::size_t at = here.draw(random);
    const Place::Case& taken = here.cases[at];
    bound = taken.bound;
    bounds_.choose(choice, cluster, taken.number);
    if (is_kept) {
      path.push_back({kept, at});
      kept = taken.place;
      is_kept = kept != 0;
    }
  }
  return choice.chosen;
}

/// Makes attempts, in rounds of which each takes twice the work of the one before, until what a round costs
/// would draw many solutions. Returns false where that is not in sight.
bool NestedSampler::prepare(RandomStream& random, const StopSignal& stop) {
  for (std::uint64_t most = tuning::kFirstWorkToPrepare;; most *= 2) {
    const std::uint64_t start = bounds_.work();
    const double bound_before = bound();
    std::uint64_t attempts = 0;
    std::uint64_t successes = 0;
    for (; bounds_.work() - start < most; ++attempts) {
      successes += attempt(random, stop, cases_kept_ < most_cases_kept_) ? 1 : 0;
    }
    success_ = static_cast<double>(successes) / static_cast<double>(attempts);
    if (successes >= tuning::kManyDraws) return true;
    const bool bounds_stay = cases_kept_ >= most_cases_kept_;
    if (2 * most > tuning::kMostWorkToPrepare || (bounds_stay && successes > 0))
      return successes > 0 && successes >= most / tuning::kMostWorkToDraw;
    if (bounds_stay && most >= tuning::kWorkWithoutSuccess) return false;
    if (most >= tuning::kWorkBeforeDoubt && successes == 0 && 2 * bound() > bound_before) return false;
  }
}

std::optional<NestedSampler> NestedSampler::prepared(ClusterNetwork network, RandomStream random,
                                                     const StopSignal& stop,
                                                     std::size_t most_cases_kept) try {
  NestedBounds bounds(std::move(network));
  auto order = order_of_clusters(bounds, random, stop);
  if (!order) return std::nullopt;
  Place first = bounds.place(bounds.start(), order->front(), stop);
  NestedSampler sampler(std::move(bounds), std::move(*order), std::move(first), most_cases_kept);
  if (!sampler.prepare(random, stop)) return std::nullopt;
  sampler.bounds_.lift_limit();
  return sampler;
} catch (const NestedBounds::TooMuchWork&) {
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
