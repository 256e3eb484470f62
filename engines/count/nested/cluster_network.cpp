#include "engines/count/nested/cluster_network.h"

#include <algorithm>
#include <map>

namespace solitaire {

ClusterNetwork::ClusterNetwork(const Graph& graph, Clusters clusters)
    : clusters_(std::move(clusters)), pairs_(clusters_.size() * clusters_.size()), chosen_(clusters_.size()) {
  for (std::size_t i = 0; i < clusters_.size(); ++i) columns_.emplace_back(graph, clusters_[i]);
  std::map<std::vector<std::size_t>, std::vector<NodeId>> conditions;
  for (const Clusters::Tie& tie : clusters_.ties()) conditions[tie.clusters].push_back(tie.condition);
  const auto filter = [&](const std::vector<NodeId>& tied, std::size_t cluster) {
    return ClusterFilter(graph, clusters_, columns_, tied, cluster);
  };
  for (const auto& [tied, together] : conditions) {
    if (tied.size() == 2) {
      for (const auto& [a, b] : {std::pair(tied[0], tied[1]), std::pair(tied[1], tied[0])}) {
        Pair& pair = pairs_[a * clusters_.size() + b];
        pair.filter.emplace(filter(together, b));
        pair.beside.resize(clusters_[a].size);
        pair.known.resize(clusters_[a].size);
      }
    } else {
      Wide wide{tied, {}};
      for (const std::size_t cluster : tied) wide.filters.push_back(filter(together, cluster));
      wide_.push_back(std::move(wide));
    }
  }
}

const CaseSet& ClusterNetwork::beside(std::size_t other, std::uint32_t number, std::size_t cluster) {
  Pair& pair = pairs_[other * clusters_.size() + cluster];
  if (!pair.known[number]) {
    chosen_[other] = number;
    pair.beside[number] = pair.filter->run(chosen_, scratch_);
    pair.known[number] = true;
    work_ += pair.filter->work();
  }
  return pair.beside[number];
}

CaseSet ClusterNetwork::fitting(std::size_t wide, std::size_t cluster, const Cases& chosen) {
  const Wide& conditions = wide_[wide];
  const auto at = std::ranges::find(conditions.clusters, cluster) - conditions.clusters.begin();
  const ClusterFilter& filter = conditions.filters[static_cast<std::size_t>(at)];
  work_ += filter.work();
  return filter.run(chosen, scratch_);
}

}  // namespace solitaire
