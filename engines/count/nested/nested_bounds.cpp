#include "engines/count/nested/nested_bounds.h"

#include <algorithm>
#include <utility>

namespace solitaire {
namespace {

/// What it takes to go to a set, and to copy one, as much as to look at so many of its words.
constexpr std::uint64_t kWorkForSet = 5;
constexpr std::uint64_t kWorkForCopy = 30;

}  // namespace

std::size_t Place::draw(RandomStream& random) const {
  double at = random.uniform() * total;
  std::size_t i = 0;
  while (i + 1 < cases.size() && at >= cases[i].bound) at -= cases[i++].bound;
  return i;
}

NestedBounds::NestedBounds(ClusterNetwork network) : network_(std::move(network)) {
  start_.chosen.resize(clusters().size());
  start_.is_chosen.resize(clusters().size());
  for (std::size_t i = 0; i < clusters().size(); ++i) {
    start_.left.emplace_back(clusters()[i].size);
    start_.sizes.push_back(clusters()[i].size);
  }
}

PartialChoice NestedBounds::start() {
  work_ += kWorkForCopy * start_.left.size();
  return start_;
}

double NestedBounds::bound_of(const PartialChoice& choice, std::size_t cluster, std::uint32_t number) {
  if (work() > most_work_) throw TooMuchWork{};
  double bound = 1;
  for (std::size_t other = 0; other < choice.sizes.size() && bound > 0; ++other) {
    if (choice.is_chosen[other] || other == cluster) continue;
    if (!network_.tied(cluster, other)) {
      bound *= static_cast<double>(choice.sizes[other]);
      continue;
    }
    const CaseSet& beside = network_.beside(cluster, number, other);
    work_ += kWorkForSet + choice.left[other].words();
    bound *= static_cast<double>(choice.left[other].size_common(beside));
  }
  return bound;
}

Place NestedBounds::place(const PartialChoice& choice, std::size_t cluster, const StopSignal& stop) {
  Place place;
  choice.left[cluster].for_each([&](std::size_t number) {
    if (stop.stopped()) throw Interrupted{};
    const double bound = bound_of(choice, cluster, static_cast<std::uint32_t>(number));
    if (bound > 0) place.cases.push_back({static_cast<std::uint32_t>(number), 0, bound});
    place.total += bound;
  });
  return place;
}

double NestedBounds::estimated_total(const PartialChoice& choice, std::size_t cluster) {
  const std::size_t stride = 1 + choice.sizes[cluster] / tuning::kCasesForOrder;
  std::size_t position = 0;
  std::size_t looked_at = 0;
  double total = 0;
  choice.left[cluster].for_each([&](std::size_t number) {
    if (position++ % stride != 0) return;
    ++looked_at;
    total += bound_of(choice, cluster, static_cast<std::uint32_t>(number));
  });
  return total * static_cast<double>(position) / static_cast<double>(looked_at);
}

void NestedBounds::choose(PartialChoice& choice, std::size_t cluster, std::uint32_t number) {
  choice.chosen[cluster] = number;
  choice.is_chosen[cluster] = true;
  for (std::size_t other = 0; other < choice.sizes.size(); ++other) {
    if (choice.is_chosen[other] || !network_.tied(cluster, other)) continue;
    work_ += kWorkForSet + choice.left[other].words();
    choice.left[other].intersect(network_.beside(cluster, number, other));
    choice.sizes[other] = choice.left[other].size();
  }
  for (std::size_t i = 0; i < network_.wide(); ++i) {
    if (std::ranges::count(network_.wide_clusters(i), cluster) > 0) restrict_last(choice, i);
  }
}

/// Where a condition on several clusters has a single one left that is not chosen, takes away what does not
/// fit the others.
void NestedBounds::restrict_last(PartialChoice& choice, std::size_t wide) {
  const std::vector<std::size_t>& tied = network_.wide_clusters(wide);
  const auto is_open = [&](std::size_t cluster) { return !choice.is_chosen[cluster]; };
  if (std::ranges::count_if(tied, is_open) != 1) return;
  const std::size_t last = *std::ranges::find_if(tied, is_open);
  choice.left[last].intersect(network_.fitting(wide, last, choice.chosen));
  choice.sizes[last] = choice.left[last].size();
}

}  // namespace solitaire
