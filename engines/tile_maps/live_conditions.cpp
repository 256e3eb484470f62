#include "engines/tile_maps/live_conditions.h"

#include <algorithm>
#include <array>

#include "tracegraph/cone.h"

namespace solitaire {

LiveConditions::LiveConditions(const Graph& graph, std::vector<NodeId> conditions, Assignment& values)
    : conditions_(std::move(conditions)) {
  std::vector<NodeId> nodes = nodes_below(graph, conditions_);
  std::ranges::sort(nodes, {}, &NodeId::index);  // operands are made before what they are operands of
  users_.resize(nodes.size());
  condition_of_.resize(nodes.size());
  touched_.resize(nodes.size());
  for (Place place = 0; place < nodes.size(); ++place) {
    places_.emplace(nodes[place].index, place);
    values_.push_back(values.value(nodes[place]));
    const Graph::Node& node = graph.node(nodes[place]);
    Part& part = parts_.emplace_back(Part{node.op, {}});
    for (std::size_t operand = 0; operand < node.args().size(); ++operand) {
      part.operands.at(operand) = places_.at(node.args()[operand].index);
      users_[part.operands.at(operand)].push_back(place);
    }
  }
  for (std::size_t condition = 0; condition < conditions_.size(); ++condition) {
    roots_.push_back(places_.at(conditions_[condition].index));
    condition_of_[roots_.back()] = condition;
    broken_ += is_true(roots_.back()) ? 0 : 1;
  }
}

void LiveConditions::set(NodeId variable, Scalar value) {
  const auto found = places_.find(variable.index);
  if (found == places_.end()) return;
  std::optional<Scalar>& now = values_[found->second];
  if (now && now->i == value.i) return;
  now = value;
  touch_users(found->second);
}

void LiveConditions::touch_users(Place place) {
  for (const Place user : users_[place]) {
    if (touched_[user]) continue;
    touched_[user] = true;
    queue_.push(user);
  }
}

void LiveConditions::settle() {
  while (!queue_.empty()) {
    const Place place = queue_.top();
    queue_.pop();
    touched_[place] = false;
    evaluate(place);
  }
}

void LiveConditions::evaluate(Place place) {
  const Part& part = parts_[place];
  const std::size_t count = operation(part.op).arity;
  std::array<std::optional<Scalar>, 3> operands;
  for (std::size_t i = 0; i < count; ++i) operands[i] = values_[part.operands[i]];
  const std::optional<Scalar> value = folded(part.op, {operands.data(), count});
  std::optional<Scalar>& now = values_[place];
  if (now.has_value() == value.has_value() && (!now || now->i == value->i)) return;
  const bool held = is_true(place);
  now = value;
  if (condition_of_[place] && held != is_true(place)) {
    broken_ += held ? 1 : -1;
    if (held) newly_broken_.push_back(*condition_of_[place]);
  }
  touch_users(place);
}

}  // namespace solitaire
