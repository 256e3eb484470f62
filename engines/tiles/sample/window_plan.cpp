#include "engines/tiles/sample/window_plan.h"

#include <algorithm>

namespace solitaire::tiles {

WindowPlan::WindowPlan(const Problem& problem)
    : problem_(problem), places_(problem.sites(), kOutside), classes_(problem.style()) {
  for (std::size_t shape = 0; shape < problem.style().shapes.size(); ++shape) add_placements(shape);
}

void WindowPlan::add_placements(std::size_t shape) {
  const PatchIndex& patches = problem_.style().shapes[shape].patches;
  const Size& size = problem_.size();
  const std::ptrdiff_t strides[] = {1, size.width(), std::ptrdiff_t{size.width()} * size.height()};
  std::vector<Point> offsets;
  for_each_point(patches.shape(), [&](const Point& at) { offsets.push_back(at); });
  for (std::size_t own = 0; own < offsets.size(); ++own) {
    Placement& placement = placements_.emplace_back();
    placement.shape = shape;
    placement.own = own;
    for (std::size_t axis = 0; axis < kAxes; ++axis) placement.first[axis] = -offsets[own][axis];
    for (std::size_t part = 0; part < offsets.size(); ++part) {
      if (part == own) continue;
      Point offset{};
      std::ptrdiff_t distance = 0;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        offset[axis] = offsets[part][axis] - offsets[own][axis];
        distance += offset[axis] * strides[axis];
      }
      placement.offsets.push_back(offset);
      placement.distances.push_back(distance);
      placement.shifts.push_back(static_cast<unsigned>(part) * patches.bits());
    }
  }
}

bool WindowPlan::lay_out(const Grid& map, std::span<const std::uint32_t> sites, Weights& weights) {
  if (steps_.size() < sites.size()) steps_.resize(sites.size());
  used_ = sites.size();
  parts_.clear();
  needed_until_.assign(used_, 0);
  told_apart_until_.assign(used_, 0);
  neighbor_chosen_.assign(used_, {});
  slot_of_.resize(used_);
  for (std::uint32_t place = 0; place < used_; ++place) {
    PlanStep& step = steps_[place];
    step.site = sites[place];
    places_[step.site] = place;
    step.tiles = problem_.domain(step.site);
    step.own.assign(problem_.style().tileset.size(), 1.0);
    step.pairs.clear();
    step.factors.clear();
    needed_until_[place] = place;
  }
  for (std::uint32_t place = 0; place < used_; ++place) {
    find_pairs(map, place);
    find_factors(map, place, weights);
  }
  return assign_slots();
}

void WindowPlan::need(std::uint32_t place, std::uint32_t until) {
  needed_until_[place] = std::max(needed_until_[place], until);
}

void WindowPlan::find_pairs(const Grid& map, std::uint32_t place) {
  PlanStep& step = steps_[place];
  const Point at = problem_.size().point(step.site);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int direction : {1, -1}) {
      const std::size_t site = problem_.topology().neighbor(at, axis, direction);
      if (site == Topology::kNone) continue;
      const std::uint32_t other = place_of(site);
      if (other != kOutside && other > place) continue;
      const PairRules& rules = problem_.pairs(problem_.zone(step.site), problem_.zone(site));
      if (other == kOutside) {
        step.tiles &= rules.beside(map[site], axis, -direction);
      } else if (other == place) {  // a ring of one site
        TileMask tiles;
        step.tiles.for_each([&](Tile tile) {
          if (rules.allowed(axis, tile, tile)) tiles.insert(tile);
        });
        step.tiles = tiles;
      } else {
        step.pairs.push_back({&rules, axis, -direction, other});  // the place; assign_slots() knows the slot
        neighbor_chosen_[other][side_number(axis, -direction)] = place;
        need(other, place);
      }
    }
  }
}

void WindowPlan::find_factors(const Grid& map, std::uint32_t place, Weights& weights) {
  const std::size_t site = steps_[place].site;
  const Point at = problem_.size().point(site);
  for (const Placement& placement : placements_) {
    if (find_sites(placement, at, site)) close_factor(map, place, placement, weights);
  }
}

/// Returns whether the shape lies in the grid without going round a ring.
bool WindowPlan::is_inside(const Placement& placement, const Point& at) const {
  const Size& shape = problem_.style().shapes[placement.shape].patches.shape();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const int from = at[axis] + placement.first[axis];
    if (from < 0 || from + shape.extent[axis] > problem_.size().extent[axis]) return false;
  }
  return true;
}

/// Finds the other sites of a shape. Returns false if some of them do not exist.
bool WindowPlan::find_sites(const Placement& placement, const Point& at, std::size_t site) {
  sites_.clear();
  if (is_inside(placement, at)) {
    for (const std::ptrdiff_t distance : placement.distances) {
      sites_.push_back(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(site) + distance));
    }
    return true;
  }
  for (const Point& offset : placement.offsets) {
    sites_.push_back(problem_.topology().site(at, offset));
    if (sites_.back() == Topology::kNone) return false;
  }
  return true;
}

/// Notes the factor of a placement, if it closes at the place: if no later place sees it.
void WindowPlan::close_factor(const Grid& map, std::uint32_t place, const Placement& placement,
                              Weights& weights) {
  PlanStep& step = steps_[place];
  const auto first = static_cast<std::uint32_t>(parts_.size());
  ClosingFactor factor{nullptr, 0, first, first};
  ZoneSet zones = ZoneSet{1} << problem_.zone(step.site);
  for (std::size_t part = 0; part < sites_.size(); ++part) {
    const std::size_t site = sites_[part];
    const std::uint32_t other = place_of(site);
    if (other == kOutside) {
      factor.standing |= PatchCode{map[site]} << placement.shifts[part];
    } else if (other > place) {
      return parts_.resize(first);
    } else {
      parts_.push_back({other, placement.shifts[part]});  // the place; assign_slots() knows the slot
    }
    zones |= ZoneSet{1} << problem_.zone(site);
  }
  factor.rows = &weights.rows(placement.shape, zones, placement.own);
  factor.end_part = static_cast<std::uint32_t>(parts_.size());
  if (factor.end_part == first) {
    const double* const row = factor.rows->row(factor.standing);
    for (std::size_t tile = 0; tile < step.own.size(); ++tile) step.own[tile] *= row[tile];
    return;
  }
  for (const ClosingFactor::Part& part : parts(factor)) {
    need(part.slot, place);
    told_apart_until_[part.slot] = std::max(told_apart_until_[part.slot], place);
  }
  step.factors.push_back(factor);
}

/// Gives each tile that later steps need a slot of the key, for as long as they do.
bool WindowPlan::assign_slots() {
  const unsigned bits = PatchIndex::bits_for(problem_.style().tileset.size());
  const unsigned slots = 128 / bits;
  const FrontierKey ones = (FrontierKey{1} << bits) - 1;
  std::vector<std::uint32_t> holder(slots, kOutside);  // by slot: the place whose tile it has
  for (std::uint32_t place = 0; place < used_; ++place) {
    PlanStep& step = steps_[place];
    for (ClosingPair& pair : step.pairs) pair.slot = slot_of_[pair.slot];
    for (const ClosingFactor& factor : step.factors) {
      for (std::uint32_t part = factor.first_part; part < factor.end_part; ++part) {
        parts_[part].slot = slot_of_[parts_[part].slot];
      }
    }
    step.kept = 0;
    step.narrowed.clear();
    step.needed = needed_until_[place] > place;
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
      if (holder[slot] != kOutside && needed_until_[holder[slot]] <= place) holder[slot] = kOutside;
      if (holder[slot] == kOutside) continue;
      step.kept |= ones << (slot * bits);
      narrow(place, holder[slot]);
    }
    if (!step.needed) continue;
    const auto free = std::ranges::find(holder, kOutside);
    if (free == holder.end()) return false;
    *free = place;
    step.slot = slot_of_[place] = static_cast<unsigned>(free - holder.begin()) * bits;
    step.classes = classes_after(place, place);
  }
  return true;
}

/// Notes what less has to be known of an earlier tile once the site at the place has its own.
void WindowPlan::narrow(std::uint32_t place, std::uint32_t of) {
  const Tile* const classes = classes_after(place, of);
  if (classes != nullptr && classes != classes_after(place - 1, of))
    steps_[place].narrowed.push_back({slot_of_[of], classes});
}

/// Returns the classes of tiles that steps after the place tell apart, of the site at place `of`; null where
/// they tell all tiles apart.
const Tile* WindowPlan::classes_after(std::uint32_t place, std::uint32_t of) {
  if (told_apart_until_[of] > place) return nullptr;
  Sides sides = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int step : {1, -1}) {
      if (neighbor_chosen_[of][side_number(axis, step)] > place) sides |= side(axis, step);
    }
  }
  return classes_.of(sides);
}

}  // namespace solitaire::tiles
