#include "engines/tiles/start/start.h"

#include <algorithm>

#include "engines/tiles/start/collapse.h"

namespace solitaire::tiles {
namespace {

constexpr int kFlatBlock = 20;  // sites along an axis
constexpr int kDeepBlock = 8;   // the same in maps of several layers
constexpr int kCollapses = 2;   // attempts before the solver
constexpr int kFirstMargin = 4;

bool is_whole(const Box& box, const Size& size) { return box.size() == size; }

/// Fills a box of the map, or finds that this cannot be.
Outcome fill(const Problem& problem, const std::vector<TileMask>& domains, const Box& box,
             RandomStream& random, const StopSignal& stop, Grid& map) {
  const Block block(problem, domains, map, box);
  for (int attempt = 0; attempt < kCollapses; ++attempt) {
    Block tried = block;
    const Outcome outcome = collapse(tried, random, stop);
    if (outcome == Outcome::kGaveUp) continue;
    if (outcome == Outcome::kFound) tried.write_to(map);
    return outcome;
  }
  Block solved = block;
  const Outcome outcome = solve_block(solved, random, stop);
  if (outcome == Outcome::kFound) solved.write_to(map);
  return outcome;
}

/// Says again that nothing is known in the part of a box that was filled already; what is beyond it stays.
void forget_tiles(const Box& box, Grid& map) {
  for_each_point(box.size(), [&](const Point& at) {
    map[map.size.site({box.from[0] + at[0], box.from[1] + at[1], box.from[2] + at[2]})] = kHole;
  });
}

Outcome fill_growing(const Problem& problem, const std::vector<TileMask>& domains, const Box& box,
                     RandomStream& random, const StopSignal& stop, Grid& map) {
  Box now = box;
  for (int margin = kFirstMargin;; margin *= 2) {
    const Outcome outcome = fill(problem, domains, now, random, stop, map);
    if (outcome != Outcome::kNone || is_whole(now, problem.size())) return outcome;
    now = grown(box, margin, problem.size());
    forget_tiles(now, map);
  }
}

template <class Visit>
Outcome for_each_block(const Size& size, const StopSignal& stop, Visit visit) {
  const int step = size.depth() > 1 ? kDeepBlock : kFlatBlock;
  const auto blocks = [&](int extent) { return (extent + step - 1) / step; };
  const Size count{{blocks(size.width()), blocks(size.height()), blocks(size.depth())}};
  Outcome outcome = Outcome::kFound;
  for_each_point(count, [&](const Point& at) {
    if (outcome != Outcome::kFound) return;
    if (stop.stopped()) {
      outcome = Outcome::kStopped;
      return;
    }
    Box box;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      box.from[axis] = at[axis] * step;
      box.to[axis] = std::min(box.from[axis] + step, size.extent[axis]);
    }
    outcome = visit(box);
  });
  return outcome;
}

}  // namespace

std::vector<TileMask> consistent_domains(const Problem& problem) {
  std::vector<TileMask> domains;
  domains.reserve(problem.sites());
  for (std::size_t site = 0; site < problem.sites(); ++site) domains.push_back(problem.domain(site));
  Block whole(problem, domains, Grid(problem.size()), whole_box(problem.size()));
  if (!whole.propagate()) return {};
  for (std::size_t site = 0; site < problem.sites(); ++site) domains[site] = whole.domain(site);
  return domains;
}

Outcome make_start(const Problem& problem, const std::vector<TileMask>& domains, RandomStream& random,
                   const StopSignal& stop, Grid& map) {
  map = Grid(problem.size());
  if (domains.empty()) return Outcome::kNone;
  return for_each_block(problem.size(), stop, [&](const Box& box) {
    return fill_growing(problem, domains, box, random, stop, map);
  });
}

Outcome solve_whole(const Problem& problem, const std::vector<TileMask>& domains, RandomStream& random,
                    const StopSignal& stop, Grid& map) {
  map = Grid(problem.size());
  if (domains.empty()) return Outcome::kNone;
  Block block(problem, domains, map, whole_box(problem.size()));
  const Outcome outcome = solve_block(block, random, stop);
  if (outcome == Outcome::kFound) block.write_to(map);
  return outcome;
}

}  // namespace solitaire::tiles
