#pragma once
#include <memory>

#include "engines/count/nested/cluster_filter.h"

namespace solitaire {

/// Clusters and what goes together, found out when it is asked for.
class ClusterNetwork {
 public:
  ClusterNetwork(const Graph& graph, Clusters clusters);

  const Clusters& clusters() const { return clusters_; }
  /// Returns true if conditions depend on these two clusters and no others.
  bool tied(std::size_t a, std::size_t b) const {
    return pairs_[a * clusters_.size() + b].filter.has_value();
  }
  /// Returns what the cluster can be beside the other one if that is the case `number`. They must be tied.
  const CaseSet& beside(std::size_t other, std::uint32_t number, std::size_t cluster);

  /// Conditions that tie more than two clusters.
  struct Wide {
    std::vector<std::size_t> clusters;
    std::vector<ClusterFilter> filters;  // by cluster
  };
  std::size_t wide() const { return wide_.size(); }
  const std::vector<std::size_t>& wide_clusters(std::size_t number) const { return wide_[number].clusters; }
  /// Returns what the cluster can be by these conditions, where all others that they tie are `chosen`.
  CaseSet fitting(std::size_t wide, std::size_t cluster, const Cases& chosen);

  /// Returns how much was computed so far, in steps of about a nanosecond.
  std::uint64_t work() const { return work_; }

 private:
  struct Pair {
    std::optional<ClusterFilter> filter;  // says what the second is
    std::vector<CaseSet> beside;          // by the case of the first
    std::vector<bool> known;
  };

  Clusters clusters_;
  std::vector<ClusterColumns> columns_;
  std::vector<Pair> pairs_;  // by two clusters
  std::vector<Wide> wide_;
  ClusterFilter::Scratch scratch_;
  Cases chosen_;
  std::uint64_t work_ = 0;
};

}  // namespace solitaire
