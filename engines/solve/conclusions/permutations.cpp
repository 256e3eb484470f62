#include "engines/solve/conclusions/permutations.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engines/tuning.h"
#include "tracegraph/sums.h"

namespace solitaire {
namespace {

/// Larger ints are not added up, so that sums stay within 62 bits.
constexpr std::int64_t kLargestAddedUp = std::int64_t{1} << 30;

/// An int as a node and an offset.
struct ShiftedInt {
  std::int64_t offset = 0;
  std::uint32_t base = 0;
  friend auto operator<=>(const ShiftedInt&, const ShiftedInt&) = default;
};

/// Which ints differ, as conditions say or bounds. Two that come from the same node with different offsets
/// always do.
class Differences {
 public:
  Differences(const Graph& graph, const Separations& separations) : graph_(graph), separations_(separations) {
    for (const Separation& pair : separations.pairs) {
      const AxisSeparation& axis = pair.axes[0];
      if (pair.number != 1 || axis.length != std::array<std::int64_t, 2>{1, 1}) continue;
      const ShiftedInt a = shifted(axis.at[0]), b = shifted(axis.at[1]);
      apart_[a].emplace(b, pair.condition);
      apart_[b].emplace(a, pair.condition);
    }
  }

  bool differ(const ShiftedInt& a, const ShiftedInt& b) const {
    if (a.base == b.base) return a.offset != b.offset;
    const Interval x = values(a), y = values(b);
    return x.hi < y.lo || y.hi < x.lo || apart_.at(a).contains(b);
  }

  /// Returns the values that an int can have.
  Interval values(const ShiftedInt& of) const {
    const Interval base = separations_.bounds_of(graph_, {of.base}).values;
    return {base.lo + of.offset, base.hi + of.offset};
  }

  /// Returns each int with those that differ from it by a condition, and that condition.
  const std::map<ShiftedInt, std::map<ShiftedInt, SignedNode>>& all() const { return apart_; }

 private:
  ShiftedInt shifted(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    if (node.op == Op::kAdd && graph_.node(node.operands[1]).is_constant())
      return {graph_.node(node.operands[1]).interval.lo, node.operands[0].index};
    return {0, id.index};
  }

  const Graph& graph_;
  const Separations& separations_;
  std::map<ShiftedInt, std::map<ShiftedInt, SignedNode>> apart_;
};

/// Ints that pairwise differ.
class Group {
 public:
  const std::vector<ShiftedInt>& members() const { return members_; }

  void add(const ShiftedInt& member, Interval values) {
    members_.push_back(member);
    all_ = all_ ? Interval{std::min(all_->lo, values.lo), std::max(all_->hi, values.hi)} : values;
  }

  /// Returns true if they are as many as their values.
  bool is_permutation() const {
    return members_.size() > 2 && all_->hi - all_->lo + 1 == static_cast<std::int64_t>(members_.size());
  }

  /// Adds two conditions for each value: some member has it, and exactly one does.
  void add_values(Graph& graph, Permutations& to) const {
    const NodeId one = graph.constant(std::int64_t{1});
    for (std::int64_t value = all_->lo; value <= all_->hi; ++value) {
      std::vector<NodeId> equal;
      NodeId any = kFalse;
      for (const ShiftedInt& member : members_) {
        equal.push_back(graph.apply(Op::kEqInt, {{member.base}, graph.constant(value - member.offset)}));
        any = graph.disjunction(any, equal.back());
      }
      to.taken.push_back(any);
      to.values.push_back(graph.apply(Op::kEqInt, {count_of(graph, equal), one}));
    }
  }

  /// Returns the condition that the members add up to what the values do, if they are small enough.
  std::optional<NodeId> sum_of_values(Graph& graph) const {
    const auto is_large = [&](const ShiftedInt& member) {
      const Interval interval = graph.node({member.base}).interval;
      return interval.lo < -kLargestAddedUp || interval.hi > kLargestAddedUp;
    };
    if (std::ranges::any_of(members_, is_large)) return std::nullopt;
    const auto size = static_cast<std::int64_t>(members_.size());
    std::int64_t sum = size * (all_->lo + all_->hi) / 2;
    std::vector<NodeId> terms;
    for (const ShiftedInt& member : members_) terms.push_back({member.base}), sum -= member.offset;
    return graph.apply(Op::kEqInt, {sum_of(graph, std::move(terms)), graph.constant(sum)});
  }

 private:
  std::vector<ShiftedInt> members_;
  std::optional<Interval> all_;  // the values that members can have
};

/// Puts ints that pairwise differ into groups, such that each two without offsets of which a condition says
/// so are in one.
class Grouping {
 public:
  Grouping(const Graph& graph, const Separations& separations) : differences_(graph, separations) {}

  const Differences& differences() const { return differences_; }

  /// Calls `visit` with each group that is a permutation.
  template <class Visit>
  void for_each_permutation(Visit visit) {
    for (const auto& [first, others] : differences_.all()) {
      for (const auto& [second, condition] : others) {
        if (work_ == 0) return;
        spend();
        if (first.offset != 0 || second.offset != 0 || second < first || grouped_.contains({first, second}))
          continue;
        const Group group = group_of(first, second);
        if (group.is_permutation()) visit(group);
      }
    }
  }

 private:
  /// Returns a group with both ints: of those that differ from one member each is added that differs from
  /// all.
  Group group_of(const ShiftedInt& first, const ShiftedInt& second) {
    Group group;
    std::set<ShiftedInt> met{first, second};
    join(group, first);
    for (std::set<ShiftedInt> open{second}; !open.empty() && work_ > 0 && !group.is_permutation();) {
      const ShiftedInt next = open.extract(open.begin()).value();
      if (!differs_from_all(group, next)) continue;
      join(group, next);
      for (const auto& [other, condition] : differences_.all().at(next)) {
        if (met.insert(other).second) open.insert(other);
        spend();
      }
    }
    return group;
  }

  void join(Group& group, const ShiftedInt& next) {
    for (const ShiftedInt& member : group.members())
      grouped_.insert({std::min(member, next), std::max(member, next)});
    group.add(next, differences_.values(next));
  }

  bool differs_from_all(const Group& group, const ShiftedInt& candidate) {
    return std::ranges::all_of(group.members(), [&](const ShiftedInt& member) {
      spend();
      return differences_.differ(member, candidate);
    });
  }

  void spend() { work_ -= work_ > 0 ? 1 : 0; }

  Differences differences_;
  std::set<std::pair<ShiftedInt, ShiftedInt>> grouped_;
  std::size_t work_ = tuning::kMostPermutationWork;
};

/// Returns true if each is one of several ints, as an element of a list is. That it is one of its values is a
/// condition on the index, while to compare two of them takes gates for each value of each element.
bool are_looked_up(const Graph& graph, const Group& group) {
  return std::ranges::all_of(
      group.members(), [&](const ShiftedInt& member) { return graph.node({member.base}).op == Op::kIteInt; });
}

/// Adds the equations of two of the group.
void add_equations(const Differences& differences, const Group& group, std::unordered_set<NodeId>& to) {
  for (const ShiftedInt& member : group.members()) {
    const auto others = differences.all().find(member);
    if (others == differences.all().end()) continue;
    for (const ShiftedInt& other : group.members()) {
      const auto found = others->second.find(other);
      if (found != others->second.end() && !found->second.holds) to.insert(found->second.node);
    }
  }
}

}  // namespace

Permutations find_permutations(Graph& graph, const Separations& separations) {
  Permutations found;
  if (separations.pairs.size() > tuning::kMostPermutationPairs) return found;
  std::size_t equations = tuning::kMostPermutationEquations;
  Grouping grouping(graph, separations);
  grouping.for_each_permutation([&](const Group& group) {
    const std::size_t size = group.members().size() * group.members().size();
    if (size > equations) return;
    equations -= size;
    group.add_values(graph, found);
    if (const auto sum = group.sum_of_values(graph)) found.sums.push_back(*sum);
    if (are_looked_up(graph, group)) add_equations(grouping.differences(), group, found.ruled_out);
  });
  return found;
}

}  // namespace solitaire
