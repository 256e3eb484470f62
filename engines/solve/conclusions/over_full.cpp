#include "engines/solve/conclusions/over_full.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "engines/tuning.h"

namespace solitaire {
namespace {

/// A thing: where it is along one axis or two, and its least length there.
struct Thing {
  std::vector<NodeId> at;
  std::vector<std::int64_t> length;
  std::vector<std::pair<std::size_t, SignedNode>> apart_from;  // numbers of other things, and why; sorted

  const SignedNode* apart(std::size_t other) const {
    const auto found =
        std::ranges::lower_bound(apart_from, other, {}, [](const auto& each) { return each.first; });
    return found != apart_from.end() && found->first == other ? &found->second : nullptr;
  }
};

/// Finds out which ints belong together as the place of one thing.
///
/// Along one axis each int is a thing. A condition that keeps two boxes apart does not tell which of the two
/// places along one axis belongs to which along the other. But a box's own other place is the only one that
/// stands in every condition with the first. Which axis is which follows from what is compared with what.
class Things {
 public:
  explicit Things(const std::vector<Separation>& pairs) {
    for (const Separation& pair : pairs) {
      if (pair.number == 2) note_places(pair);
    }
    for (const Separation& pair : pairs) add(pair);
    for (Thing& thing : things_) {
      std::ranges::stable_sort(thing.apart_from, {}, [](const auto& each) { return each.first; });
    }
  }

  const std::vector<Thing>& all() const { return things_; }

 private:
  void note_places(const Separation& pair) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto& others = pair.axes[1 - axis].at;
      for (const NodeId at : pair.axes[axis].at) {
        const auto [entry, added] = partners_.try_emplace(at, others.begin(), others.end());
        if (added) continue;
        std::erase_if(entry->second,
                      [&](NodeId known) { return std::ranges::find(others, known) == others.end(); });
      }
      axis_of_[find(pair.axes[axis].at[0])] = find(pair.axes[axis].at[1]);
    }
  }

  /// Returns a place that stands for the axis of this one (union-find).
  NodeId find(NodeId at) {
    NodeId root = at;
    while (true) {
      const NodeId next = axis_of_.try_emplace(root, root).first->second;
      if (next == root) break;
      root = next;
    }
    axis_of_[at] = root;
    return root;
  }

  /// Returns the place along the other axis that alone always stands with this one.
  std::optional<NodeId> partner(NodeId at) const {
    const auto& own = partners_.at(at);
    if (own.size() != 1) return std::nullopt;
    const auto& back = partners_.at(own.front());
    if (back.size() != 1 || back.front() != at) return std::nullopt;
    return own.front();
  }

  void add(const Separation& pair) {
    const auto a = number(pair, 0), b = number(pair, 1);
    if (!a || !b || *a == *b) return;
    things_[*a].apart_from.emplace_back(*b, pair.condition);
    things_[*b].apart_from.emplace_back(*a, pair.condition);
  }

  /// Returns the number of one of the two things that a condition keeps apart.
  std::optional<std::size_t> number(const Separation& pair, std::size_t which) {
    const AxisSeparation& first = pair.axes[0];
    if (pair.number == 1) return thing_at({first.at[which]}, {first.length[which]});
    const AxisSeparation& second = pair.axes[1];
    const auto other = partner(first.at[which]);
    if (!other || (*other != second.at[0] && *other != second.at[1])) return std::nullopt;
    const std::int64_t along = second.length[*other == second.at[0] ? 0 : 1];
    const NodeId axis = find(first.at[which]), other_axis = find(*other);
    if (axis == other_axis) return std::nullopt;
    if (axis.index < other_axis.index)
      return thing_at({first.at[which], *other}, {first.length[which], along});
    return thing_at({*other, first.at[which]}, {along, first.length[which]});
  }

  std::size_t thing_at(std::vector<NodeId> at, const std::vector<std::int64_t>& length) {
    const std::pair key(at.front().index, at.back().index);
    const auto [entry, added] = numbers_.try_emplace(key, things_.size());
    if (added) things_.push_back({std::move(at), length, {}});
    Thing& thing = things_[entry->second];
    for (std::size_t i = 0; i < length.size(); ++i) thing.length[i] = std::min(thing.length[i], length[i]);
    return entry->second;
  }

  std::unordered_map<NodeId, std::vector<NodeId>> partners_;
  std::unordered_map<NodeId, NodeId> axis_of_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers_;
  std::vector<Thing> things_;
};

/// Returns groups of things of which each two are kept apart. Each thing is in one group, chosen greedily.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<Thing>& things) {
  std::vector<std::vector<std::size_t>> groups;
  std::vector<bool> taken(things.size(), false);
  for (std::size_t first = 0; first < things.size(); ++first) {
    if (taken[first]) continue;
    std::vector<std::size_t> group{first};
    for (const auto& partner : things[first].apart_from) {
      const std::size_t other = partner.first;
      const bool fits =
          !taken[other] && other != group.back() && std::ranges::all_of(group, [&](std::size_t member) {
            return things[member].apart(other) != nullptr;
          });
      if (fits) group.push_back(other);
    }
    for (const std::size_t member : group) taken[member] = true;
    groups.push_back(std::move(group));
  }
  return groups;
}

/// A stretch along each axis; the ends are outside of it.
using Window = std::vector<Interval>;

/// Looks for windows in which the things of one group have too little room.
class Rooms {
 public:
  Rooms(Graph& graph, const Separations& separations, const std::vector<Thing>& things,
        std::vector<std::size_t> group)
      : graph_(graph), separations_(separations), things_(things), group_(std::move(group)) {
    for (const std::size_t number : group_) spans_.push_back(span_of(things_[number]));
  }

  std::optional<OverFull> find() {
    if (spans_.size() < 2) return std::nullopt;
    std::vector<Window> windows{{}};
    for (std::size_t axis = 0; axis < spans_[0].size(); ++axis) windows = with_axis(windows, axis);
    for (const Window& window : windows) {
      if (auto found = over_full(window)) return found;
    }
    return std::nullopt;
  }

 private:
  Window span_of(const Thing& thing) {
    Window span;
    for (std::size_t axis = 0; axis < thing.at.size(); ++axis) {
      const Interval values = separations_.bounds_of(graph_, thing.at[axis]).values;
      span.push_back({values.lo, values.hi + thing.length[axis]});
    }
    return span;
  }

  /// Returns the windows with each stretch of a further axis that begins and ends as things do; or, if these
  /// are very many, with the one that has all things.
  std::vector<Window> with_axis(const std::vector<Window>& windows, std::size_t axis) const {
    std::set<std::int64_t> begins, ends;
    for (const Window& span : spans_) begins.insert(span[axis].lo), ends.insert(span[axis].hi);
    if (windows.size() * begins.size() * ends.size() * spans_.size() > tuning::kMostWindowWork) {
      begins = {*begins.begin()};
      ends = {*ends.rbegin()};
    }
    std::vector<Window> wider;
    for (const Window& window : windows) {
      for (const std::int64_t begin : begins) {
        for (const std::int64_t end : ends) {
          if (end <= begin || end - begin > tuning::kLongestWindow) continue;
          wider.push_back(window);
          wider.back().push_back({begin, end});
        }
      }
    }
    return wider;
  }

  static std::int64_t size(const Window& window) {
    std::int64_t size = 1;
    for (const Interval& stretch : window) size *= stretch.hi - stretch.lo;
    return size;
  }

  /// Takes as many of the things that lie within the window as are too many for it.
  std::optional<OverFull> over_full(const Window& window) {
    OverFull found{
        {}, 0, 0, size(window), window.size() == 2 ? OverFull::Measure::kArea : OverFull::Measure::kLength};
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < group_.size() && found.needed <= found.available; ++i) {
      if (!within(spans_[i], window)) continue;
      std::int64_t least = 1;
      for (const std::int64_t length : things_[group_[i]].length) least *= length;
      found.needed += least;
      members.push_back(group_[i]);
    }
    if (found.needed <= found.available) return std::nullopt;
    found.things = members.size();
    found.conditions = conditions_of(members);
    return found;
  }

  static bool within(const Window& inner, const Window& outer) {
    for (std::size_t axis = 0; axis < outer.size(); ++axis) {
      if (inner[axis].lo < outer[axis].lo || inner[axis].hi > outer[axis].hi) return false;
    }
    return true;
  }

  std::vector<NodeId> conditions_of(const std::vector<std::size_t>& members) {
    std::vector<NodeId> conditions;
    const auto add = [&](SignedNode literal) {
      conditions.push_back(literal.holds ? literal.node : graph_.negation(literal.node));
    };
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) add(*things_[members[i]].apart(members[j]));
      for (const NodeId at : things_[members[i]].at) {
        const IntBounds bounds = separations_.bounds_of(graph_, at);
        if (bounds.low) add(*bounds.low);
        if (bounds.high) add(*bounds.high);
      }
    }
    return conditions;
  }

  Graph& graph_;
  const Separations& separations_;
  const std::vector<Thing>& things_;
  std::vector<std::size_t> group_;
  std::vector<Window> spans_;  // by member of the group: where it lies
};

}  // namespace

std::vector<OverFull> find_over_full(Graph& graph, const std::vector<NodeId>& conditions) {
  return find_over_full(graph, find_separations(graph, conditions));
}

std::vector<OverFull> find_over_full(Graph& graph, const Separations& separations) {
  const Things things(separations.pairs);
  std::vector<OverFull> found;
  for (std::vector<std::size_t>& group : groups_of(things.all())) {
    auto rooms = Rooms(graph, separations, things.all(), std::move(group));
    if (auto over_full = rooms.find()) found.push_back(std::move(*over_full));
  }
  return found;
}

}  // namespace solitaire
