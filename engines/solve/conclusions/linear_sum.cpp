#include "engines/solve/conclusions/linear_sum.h"

#include <utility>

#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Numbers beyond this are not counted with, so that nothing here leaves 64 bits.
constexpr std::int64_t kLargest = std::int64_t{1} << 30;

bool is_small(std::int64_t number) { return -kLargest <= number && number <= kLargest; }

bool is_small(Interval range) { return is_small(range.lo) && is_small(range.hi); }

}  // namespace

bool LinearSum::add(NodeId node, std::int64_t factor) {
  std::vector<std::pair<NodeId, std::int64_t>> pending{{node, factor}};
  for (std::size_t steps = 0; !pending.empty(); ++steps) {
    const auto [id, times] = pending.back();
    pending.pop_back();
    const Graph::Node& at = graph_.node(id);
    if (steps > tuning::kMostLinearTerms || !is_small(times) || !is_small(at.interval)) return false;
    const auto value = [&](std::size_t i) { return graph_.node(at.operands[i]).interval; };
    if (at.is_constant()) {
      if (!is_small(constant_ += times * at.interval.lo)) return false;
    } else if (at.op == Op::kAdd || at.op == Op::kSub) {
      pending.emplace_back(at.operands[1], at.op == Op::kAdd ? times : -times);
      pending.emplace_back(at.operands[0], times);
    } else if (at.op == Op::kNeg) {
      pending.emplace_back(at.operands[0], -times);
    } else if (at.op == Op::kMul && (value(0).single() || value(1).single())) {
      const std::size_t constant = value(0).single() ? 0 : 1;
      if (!is_small(value(constant).lo)) return false;
      pending.emplace_back(at.operands[1 - constant], times * value(constant).lo);
    } else if (at.op == Op::kIteInt && value(1).single() && value(2).single()) {
      if (!is_small(times * value(1).lo) || !is_small(times * value(2).lo)) return false;
      constant_ += times * value(2).lo;
      add_term(at.operands[0], {0, 1}, times * (value(1).lo - value(2).lo));
    } else {
      add_term(id, at.interval, times);
    }
  }
  return is_small(constant_);
}

void LinearSum::add_term(NodeId node, Interval range, std::int64_t factor) {
  const auto [entry, added] = places_.try_emplace(node, terms_.size());
  if (added) terms_.push_back({node, range, 0});
  terms_[entry->second].factor += factor;
}

}  // namespace solitaire
