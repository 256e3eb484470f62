#include "smt/sat/small_cones.h"

#include <algorithm>

#include "smt/tuning.h"
#include "tracegraph/cone.h"

namespace solitaire {

void SmallCones::meet_new(const IsOrdered& is_ordered) {
  for (auto i = static_cast<std::uint32_t>(cones_.size()); i < graph_.size(); ++i)
    cones_.push_back(cone_of({i}, is_ordered));
}

SmallCones::Cone SmallCones::cone_of(NodeId id, const IsOrdered& is_ordered) const {
  const Graph::Node& node = graph_.node(id);
  Cone cone;
  if (is_choice(node.op)) {
    cone.choices[0] = id;
    cone.number = node.op == Op::kChoice && is_ordered(id) ? 1 : kMany;
    return cone;
  }
  for (const NodeId operand : node.args()) add(cone, cones_[operand.index]);
  if (node.op == Op::kEqInt || node.op == Op::kLtInt || node.op == Op::kLeInt) {
    for (const NodeId operand : node.args()) cone.needs_bits |= !is_ordered(operand);
  }
  return cone;
}

/// Adds what is below an operand.
void SmallCones::add(Cone& cone, const Cone& operand) {
  cone.needs_bits |= operand.needs_bits;
  if (operand.number == kMany) cone.number = kMany;
  for (std::uint8_t i = 0; i < operand.number && cone.number != kMany; ++i) {
    const auto known = std::span(cone.choices).first(cone.number);
    if (std::ranges::find(known, operand.choices[i]) != known.end()) continue;
    if (cone.number == cone.choices.size()) {
      cone.number = kMany;
    } else {
      cone.choices[cone.number++] = operand.choices[i];
    }
  }
}

std::span<const NodeId> SmallCones::tabled(NodeId condition) {
  Cone& cone = cones_[condition.index];
  if (!cone.needs_bits || cone.number == kMany || cone.number == 0) return {};
  if (cone.decided == Cone::Decided::kNot)
    cone.decided = is_worth(condition, cone) ? Cone::Decided::kTable : Cone::Decided::kNoTable;
  if (cone.decided == Cone::Decided::kNoTable) return {};
  return std::span(cone.choices).first(cone.number);
}

bool SmallCones::is_worth(NodeId condition, const Cone& cone) {
  const Graph::Node& node = graph_.node(condition);
  if (node.type() != Type::kBool || node.has_float) return false;
  std::uint64_t size = 1;
  for (std::uint8_t i = 0; i < cone.number; ++i) size *= graph_.variable(cone.choices[i]).domain.size();
  if (size > tuning::kLargestTable) return false;
  const std::uint64_t evaluations = size * nodes_below(graph_, {&condition, 1}).size();
  if (evaluations_ + evaluations > tuning::kMostTableEvaluations) return false;
  evaluations_ += evaluations;
  return true;
}

}  // namespace solitaire
