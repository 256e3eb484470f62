#pragma once
#include <cstdint>
#include <vector>

#include "engines/solve/conclusions/separations.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Things that need more room than there is.
struct OverFull {
  enum class Measure : std::uint8_t {
    kLength,
    kArea,
    kSum,  // sums ask for so much, and allow so much, see sum_conflict.h
  };
  std::vector<NodeId> conditions;  // that cannot hold together, for this reason
  std::size_t things = 0;          // so many need the room
  std::int64_t needed = 0;         // the sum of their lengths, or of their areas
  std::int64_t available = 0;      // the length or area within which all of them lie
  Measure measure = Measure::kLength;
};

/// Looks in conditions for things that pairwise do not overlap, and returns groups of them that need more
/// room than there is: 11 different ints from 1 to 10, or 17 tables of 2 x 2 in a room of 8 x 8.
///
/// A thing is an int with a length, or two ints with a width and a depth. That two of them do not overlap is
/// a condition that they differ (then their length is 1), or that one is before the other along one or two
/// axes: a + w <= b or b + v <= a. Bounds of the ints come from their intervals and from conditions such as a
/// <= 6. A group of which each two are kept apart is over-full if in some window its members' lengths or
/// areas sum up to more than the window has. Search by cases needs time that grows exponentially with the
/// number of things to see that (Haken 1985), as each case counts anew.
///
/// Conditions are taken apart into conjuncts. What comes back is a fact about ints, whatever else holds. The
/// time is linear in the conditions' nodes, but for things of which many are kept apart from many: there it
/// is by the number of pairs, and that of windows, of which only some are tried where there are very many.
std::vector<OverFull> find_over_full(Graph& graph, const std::vector<NodeId>& conditions);
std::vector<OverFull> find_over_full(Graph& graph, const Separations& separations);

}  // namespace solitaire
