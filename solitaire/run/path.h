#pragma once
#include <vector>

#include "solitaire/run/path_intervals.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// The current path of an evaluation: under which condition it is where it is.
///
/// The condition is kept in regions, one for each running call and loop. A region starts with the local guard
/// `true`; what joins inside a region merges under guards that are local to it, and so stay small. The whole
/// guard is the conjunction of all regions' locals since the last detached region.
class Path {
 public:
  /// Without a graph, everything is on one path.
  explicit Path(Graph* graph) : facts(graph), graph_(graph), regions_{{kTrue, kTrue, false}} {}

  /// Goes back to the start of the program.
  void reset() {
    regions_.assign(1, {kTrue, kTrue, false});
    facts.drop_from(0);
    facts.show_from(0);
    losses = {};
    levels = 0;
    steps = guarded_steps = 0;
  }

  /// The guard of what is there where both guards hold. A concrete execution has no other than kTrue, and no
  /// graph.
  NodeId conjunction(NodeId a, NodeId b) const {
    if (a == kTrue) return b;
    if (b == kTrue) return a;
    return graph_->conjunction(a, b);
  }
  /// The whole guard, relative to the innermost detached region.
  NodeId guard() const { return conjunction(regions_.back().entry, regions_.back().local); }
  NodeId local() const { return regions_.back().local; }
  void set_local(NodeId local) { regions_.back().local = local; }
  void narrow(NodeId condition) { set_local(conjunction(local(), condition)); }

  /// Returns true if only some executions come here.
  bool guarded() const { return regions_.back().guarded || local() != kTrue; }

  std::size_t region() const { return regions_.size() - 1; }
  /// The guard relative to the start of an enclosing region.
  NodeId guard_since(std::size_t region) const {
    NodeId guard = kTrue;
    for (std::size_t i = region; i < regions_.size(); ++i) guard = conjunction(guard, regions_[i].local);
    return guard;
  }

  void enter_region() { regions_.push_back({guard(), kTrue, guarded()}); }
  /// Starts a region that does not know how it was reached: a segment of the trace.
  void enter_detached() { regions_.push_back({kTrue, kTrue, true}); }
  void leave_regions_above(std::size_t region) { regions_.resize(region + 1); }

  /// Counts the paths that did not come out of a construct. Where a counter did not change from before a
  /// construct to behind it, nothing was lost, and the guard behind it is the one before it.
  struct Losses {
    std::uint64_t ends = 0, returns = 0, breaks = 0, continues = 0;
    friend bool operator==(const Losses&, const Losses&) = default;
  };
  Losses losses;

  PathIntervals facts;

  std::uint32_t levels = 0;         // of undecided branches that may still be opened below
  std::uint64_t steps = 0;          // of the longest path that comes here, see Limits::least_steps
  std::uint64_t guarded_steps = 0;  // those of them that only some executions make

 private:
  struct Region {
    NodeId entry, local;
    bool guarded = false;  // at its start
  };

  Graph* graph_;
  std::vector<Region> regions_;
};

/// Thrown where a path ends: at an assert that cannot hold, a closed branch side, or an error of the program.
/// Caught where paths join.
struct PathEnd {};

}  // namespace solitaire
