#include "engines/count/nested/clusters.h"

#include <algorithm>
#include <map>

#include "engines/count/nested/tuning.h"
#include "tracegraph/cone.h"

namespace solitaire {

ClusterColumns::ClusterColumns(const Graph& graph, const Cluster& cluster)
    : graph_(&graph), size_(cluster.size) {
  for (std::size_t i = 0; i < cluster.variables.size(); ++i)
    columns_.emplace(graph.variable_node(cluster.variables[i]).index, cluster.values[i]);
}

const Column& ClusterColumns::of(NodeId root) {
  const auto known = columns_.find(root.index);
  if (known != columns_.end()) return known->second;
  std::vector<NodeId> nodes = nodes_below(*graph_, {&root, 1});
  std::ranges::sort(nodes, {}, &NodeId::index);  // operands are older than what uses them
  for (const NodeId node : nodes) {
    const auto [at, is_new] = columns_.try_emplace(node.index, size_);
    if (is_new) fill(node, at->second);
  }
  return columns_.at(root.index);
}

void ClusterColumns::fill(NodeId node, Column& column) const {
  const Graph::Node& data = graph_->node(node);
  if (data.is_constant()) {
    if (data.op != Op::kConstTable)
      std::ranges::fill(column, static_cast<std::int32_t>(graph_->scalar(node).i));
    return;
  }
  std::array<const std::int32_t*, 3> operands{};
  for (std::size_t i = 0; i < data.args().size(); ++i)
    operands[i] = columns_.at(data.operands[i].index).data();
  compute_column(*graph_, node, operands, column.size(), column.data());
}

/// Merges clusters until none are worth it.
class Clustering {
 public:
  Clustering(const Graph& graph, const std::vector<std::size_t>& variables,
             const std::vector<NodeId>& conditions, std::size_t most_in_cluster)
      : graph_(graph), most_in_cluster_(most_in_cluster) {
    for (const std::size_t variable : variables) {
      result_.cluster_of_[variable] = result_.clusters_.size();
      result_.clusters_.push_back(single(variable));
    }
    for (const NodeId condition : conditions) {
      Clusters::Tie tie{condition, {}};
      for (const std::size_t variable : variables_below(graph, {&condition, 1}))
        tie.clusters.push_back(result_.cluster_of(variable));
      std::ranges::sort(tie.clusters);
      result_.ties_.push_back(std::move(tie));
    }
  }

  Clusters run() {
    for (std::size_t i = 0; i < result_.clusters_.size(); ++i) settle(i);
    while (merge_best()) {
    }
    drop_empty();
    return std::move(result_);
  }

 private:
  Cluster single(std::size_t variable) const {
    const Distribution& domain = graph_.variables()[variable].domain;
    Cluster cluster{{variable}, {{}}, static_cast<std::size_t>(domain.size())};
    for (std::size_t i = 0; i < cluster.size; ++i)
      cluster.values[0].push_back(static_cast<std::int32_t>(domain.value(i)));
    return cluster;
  }

  /// Takes the conditions on the cluster alone for what it can be.
  void settle(std::size_t number) {
    Cluster& cluster = result_.clusters_[number];
    std::vector<bool> fits(cluster.size, true);
    ClusterColumns columns(graph_, cluster);
    const auto is_settled = [&](const Clusters::Tie& tie) {
      if (tie.clusters != std::vector{number}) return false;
      const Column& column = columns.of(tie.condition);
      for (std::size_t i = 0; i < cluster.size; ++i) fits[i] = fits[i] && column[i] != 0;
      return true;
    };
    std::erase_if(result_.ties_, is_settled);
    for (Column& column : cluster.values) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < cluster.size; ++i) {
        if (fits[i]) column[kept++] = column[i];
      }
      column.resize(kept);
    }
    cluster.size = cluster.values.front().size();
  }

  /// Merges the two clusters that have the most conditions in common, and of these the smallest.
  bool merge_best() {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> common;
    for (const Clusters::Tie& tie : result_.ties_) {
      if (tie.clusters.size() > tuning::kMostClustersTied) continue;
      for (std::size_t i = 0; i < tie.clusters.size(); ++i) {
        for (std::size_t j = i + 1; j < tie.clusters.size(); ++j)
          ++common[{tie.clusters[i], tie.clusters[j]}];
      }
    }
    std::pair<std::size_t, std::size_t> best;
    std::size_t most = 0;
    std::size_t size = most_in_cluster_ + 1;
    for (const auto& [pair, count] : common) {
      const std::size_t product = result_.clusters_[pair.first].size * result_.clusters_[pair.second].size;
      if (product > most_in_cluster_) continue;
      if (count < most || (count == most && product >= size)) continue;
      best = pair;
      most = count;
      size = product;
    }
    if (most == 0) return false;
    merge(best.first, best.second);
    return true;
  }

  void merge(std::size_t into, std::size_t other) {
    Cluster& a = result_.clusters_[into];
    Cluster& b = result_.clusters_[other];
    Cluster both{a.variables, {}, a.size * b.size};
    both.variables.insert(both.variables.end(), b.variables.begin(), b.variables.end());
    both.values.resize(both.variables.size());
    for (std::size_t i = 0; i < a.size; ++i) {
      for (std::size_t j = 0; j < b.size; ++j) {
        std::size_t position = 0;
        for (const Column& column : a.values) both.values[position++].push_back(column[i]);
        for (const Column& column : b.values) both.values[position++].push_back(column[j]);
      }
    }
    a = std::move(both);
    b = {};
    for (Clusters::Tie& tie : result_.ties_) {
      const auto at = std::ranges::find(tie.clusters, other);
      if (at == tie.clusters.end()) continue;
      tie.clusters.erase(at);
      if (std::ranges::find(tie.clusters, into) == tie.clusters.end()) tie.clusters.push_back(into);
      std::ranges::sort(tie.clusters);
    }
    settle(into);
  }

  /// Leaves out the clusters that became part of others.
  void drop_empty() {
    std::vector<std::size_t> numbers;
    std::vector<Cluster> kept;
    for (Cluster& cluster : result_.clusters_) {
      numbers.push_back(kept.size());
      if (!cluster.variables.empty()) kept.push_back(std::move(cluster));
    }
    result_.clusters_ = std::move(kept);
    for (Clusters::Tie& tie : result_.ties_) {
      for (std::size_t& cluster : tie.clusters) cluster = numbers[cluster];
    }
    for (std::size_t i = 0; i < result_.clusters_.size(); ++i) {
      for (const std::size_t variable : result_.clusters_[i].variables) result_.cluster_of_[variable] = i;
    }
  }

  const Graph& graph_;
  std::size_t most_in_cluster_;
  Clusters result_;
};

std::optional<Clusters> Clusters::of(const Graph& graph, const std::vector<std::size_t>& variables,
                                     const std::vector<NodeId>& conditions, std::size_t most_in_cluster) {
  if (variables.size() > tuning::kMostChoicesInClusters) return std::nullopt;
  for (const std::size_t variable : variables) {
    const Distribution& domain = graph.variables()[variable].domain;
    if (!domain.is_finite() || domain.size() > tuning::kMostInCluster) return std::nullopt;
  }
  for (const NodeId node : nodes_below(graph, conditions)) {
    if (!fits_column(graph, node)) return std::nullopt;
    const Graph::Node& data = graph.node(node);
    if (is_choice(data.op) && std::ranges::find(variables, data.payload) == variables.end())
      return std::nullopt;
  }
  return Clustering(graph, variables, conditions, most_in_cluster).run();
}

void Clusters::decode(const Cases& cases, VariableValues& values) const {
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    for (std::size_t k = 0; k < clusters_[i].variables.size(); ++k)
      values[clusters_[i].variables[k]] = clusters_[i].values[k][cases[i]];
  }
}

}  // namespace solitaire
