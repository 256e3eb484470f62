#include "engines/count/nested/cluster_filter.h"

#include <algorithm>

#include "tracegraph/cone.h"

namespace solitaire {
namespace {

constexpr std::size_t kNone = SIZE_MAX;         // a node that depends on no cluster
constexpr std::size_t kSeveral = SIZE_MAX - 1;  // on more than one
constexpr std::size_t kSpread = 3;              // the columns of scratch that hold single numbers

}  // namespace

ClusterFilter::ClusterFilter(const Graph& graph, const Clusters& clusters,
                             std::vector<ClusterColumns>& columns, const std::vector<NodeId>& conditions,
                             std::size_t cluster)
    : graph_(&graph), cluster_(cluster), size_(clusters[cluster].size) {
  std::vector<NodeId> nodes = nodes_below(graph, conditions);
  std::ranges::sort(nodes, {}, &NodeId::index);  // operands are older than what uses them
  std::unordered_map<std::uint32_t, std::size_t> depends;
  std::unordered_map<std::uint32_t, std::size_t> step_of;
  for (const NodeId node : nodes) {
    const Graph::Node& data = graph.node(node);
    std::size_t on = is_choice(data.op) ? clusters.cluster_of(data.payload) : kNone;
    for (const NodeId operand : data.args()) {
      const std::size_t other = depends.at(operand.index);
      if (other == kNone || other == on) continue;
      on = on == kNone ? other : kSeveral;
    }
    depends[node.index] = on;
    if (on != kSeveral) continue;
    step_of[node.index] = steps_.size();
    Step step{node, {}};
    for (const NodeId operand : data.args()) {
      const std::size_t other = depends.at(operand.index);
      if (other == kSeveral)
        step.operands.push_back({nullptr, 0, step_of.at(operand.index)});
      else
        step.operands.push_back(
            {&columns[other == kNone ? cluster : other].of(operand), other == kNone ? cluster : other, 0});
    }
    steps_.push_back(std::move(step));
  }
  for (const NodeId condition : conditions) conditions_.push_back(step_of.at(condition.index));
}

const std::int32_t* ClusterFilter::values(const Operand& operand, const Cases& chosen, Column& spread,
                                          const Scratch& scratch) const {
  if (operand.column == nullptr) return scratch[kSpread + operand.step].data();
  if (operand.cluster == cluster_) return operand.column->data();
  std::fill_n(spread.begin(), size_, (*operand.column)[chosen[operand.cluster]]);
  return spread.data();
}

CaseSet ClusterFilter::run(const Cases& chosen, Scratch& scratch) const {
  if (scratch.size() < kSpread + steps_.size()) scratch.resize(kSpread + steps_.size());
  for (Column& column : scratch) column.resize(std::max(column.size(), size_));
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    std::array<const std::int32_t*, 3> operands{};
    for (std::size_t k = 0; k < steps_[i].operands.size(); ++k)
      operands[k] = values(steps_[i].operands[k], chosen, scratch[k], scratch);
    compute_column(*graph_, steps_[i].node, operands, size_, scratch[kSpread + i].data());
  }
  CaseSet fits(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    if (std::ranges::all_of(conditions_, [&](std::size_t step) { return scratch[kSpread + step][i] != 0; }))
      fits.insert(i);
  }
  return fits;
}

}  // namespace solitaire
