#pragma once
#include "engines/count/nested/case_set.h"
#include "engines/count/nested/clusters.h"

namespace solitaire {

/// Says what one cluster can be by some conditions, once it is known what the others are that they tie it to.
class ClusterFilter {
 public:
  /// Columns that are used again and again for what is computed.
  using Scratch = std::vector<Column>;

  /// `columns` has those of all clusters.
  ClusterFilter(const Graph& graph, const Clusters& clusters, std::vector<ClusterColumns>& columns,
                const std::vector<NodeId>& conditions, std::size_t cluster);

  CaseSet run(const Cases& chosen, Scratch& scratch) const;
  /// Returns how much a run computes, in numbers.
  std::uint64_t work() const { return steps_.size() * size_; }

 private:
  /// A column of the cluster itself, of another one, of which the case that was chosen counts, or of a step.
  struct Operand {
    const Column* column = nullptr;
    std::size_t cluster = 0;
    std::size_t step = 0;
  };
  struct Step {
    NodeId node;
    std::vector<Operand> operands;
  };
  const std::int32_t* values(const Operand& operand, const Cases& chosen, Column& spread,
                             const Scratch& scratch) const;

  const Graph* graph_;
  std::size_t cluster_;
  std::size_t size_;
  std::vector<Step> steps_;
  std::vector<std::size_t> conditions_;  // the steps that compute them
};

}  // namespace solitaire
