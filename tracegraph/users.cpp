#include "tracegraph/users.h"

#include <numeric>

namespace solitaire {
namespace {

template <class Visit>
void for_each_use(const Graph& graph, Visit visit) {
  for (std::uint32_t at = 0; at < graph.size(); ++at) {
    for (const NodeId operand : graph.node({at}).args()) visit(operand, NodeId{at});
  }
}

}  // namespace

Users::Users(const Graph& graph) : first_(graph.size() + 1) {
  for_each_use(graph, [this](NodeId operand, NodeId) { ++first_[operand.index]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  users_.resize(first_.back());
  for_each_use(graph, [this](NodeId operand, NodeId user) { users_[--first_[operand.index]] = user; });
}

}  // namespace solitaire
