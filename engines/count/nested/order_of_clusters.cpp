#include "engines/count/nested/order_of_clusters.h"

#include <cmath>

#include "engines/count/nested/tuning.h"

namespace solitaire {
namespace {

std::size_t cluster_of_least_total(NestedBounds& bounds, const PartialChoice& choice) {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t cluster = 0; cluster < choice.sizes.size(); ++cluster) {
    if (choice.is_chosen[cluster]) continue;
    const double total = bounds.estimated_total(choice, cluster);
    if (best && total >= least) continue;
    best = cluster;
    least = total;
  }
  return *best;
}

/// Returns the clusters that one attempt chooses, until nothing is left of one.
std::vector<std::size_t> order_of_attempt(NestedBounds& bounds, RandomStream& random,
                                          const StopSignal& stop) {
  PartialChoice choice = bounds.start();
  std::vector<std::size_t> order;
  while (order.size() < choice.sizes.size()) {
    if (stop.stopped()) throw Interrupted{};
    const std::size_t cluster = cluster_of_least_total(bounds, choice);
    const Place here = bounds.place(choice, cluster, stop);
    if (here.cases.empty() || !std::isfinite(here.total)) break;
    order.push_back(cluster);
    bounds.choose(choice, cluster, here.cases[here.draw(random)].number);
  }
  return order;
}

}  // namespace

std::optional<std::vector<std::size_t>> order_of_clusters(NestedBounds& bounds, RandomStream& random,
                                                          const StopSignal& stop) {
  for (std::size_t trial = 0; trial < tuning::kTrialsForOrder; ++trial) {
    std::vector<std::size_t> order = order_of_attempt(bounds, random, stop);
    if (order.size() == bounds.clusters().size()) return order;
  }
  return std::nullopt;
}

}  // namespace solitaire
