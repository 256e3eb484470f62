#pragma once
#include <optional>
#include <unordered_map>

#include "engines/count/nested/columns.h"

namespace solitaire {

/// The value of each choice variable of a graph, by its number.
using VariableValues = std::vector<std::int64_t>;

/// What each of some clusters is, by its number among all that it can be.
using Cases = std::vector<std::uint32_t>;

/// Choices that are taken together, as the place of a thing along both axes and its turn, with all that they
/// can be together as far as the conditions on them alone say.
struct Cluster {
  std::vector<std::size_t> variables;
  std::vector<Column> values;  // by variable
  std::size_t size = 0;        // of each column
};

/// The values of nodes that depend on the choices of one cluster alone, in all that it can be. They are kept.
class ClusterColumns {
 public:
  /// The cluster must not change meanwhile.
  ClusterColumns(const Graph& graph, const Cluster& cluster);

  const Column& of(NodeId node);

 private:
  void fill(NodeId node, Column& column) const;

  const Graph* graph_;
  std::size_t size_;
  std::unordered_map<std::uint32_t, Column> columns_;
};

/// Puts choices into clusters, so that few conditions tie more than two of these: again and again those two
/// become one that have the most conditions in common, as long as they can be few things together. Conditions
/// that depend on one cluster alone are looked at for what it can be; the others are left.
class Clusters {
 public:
  /// Returns nothing where there are too many choices or values of one, a number is too large for a column,
  /// or a condition depends on other choices, too.
  static std::optional<Clusters> of(const Graph& graph, const std::vector<std::size_t>& variables,
                                    const std::vector<NodeId>& conditions, std::size_t most_in_cluster);

  std::size_t size() const { return clusters_.size(); }
  const Cluster& operator[](std::size_t number) const { return clusters_[number]; }
  /// Returns the cluster that has the choice.
  std::size_t cluster_of(std::size_t variable) const { return cluster_of_.at(variable); }
  /// The values of the choices where the clusters are these cases.
  void decode(const Cases& cases, VariableValues& values) const;

  /// A condition that depends on several clusters.
  struct Tie {
    NodeId condition;
    std::vector<std::size_t> clusters;  // in ascending order
  };
  const std::vector<Tie>& ties() const { return ties_; }

 private:
  friend class Clustering;
  std::vector<Cluster> clusters_;
  std::unordered_map<std::size_t, std::size_t> cluster_of_;  // by variable
  std::vector<Tie> ties_;
};

}  // namespace solitaire
