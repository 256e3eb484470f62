#include "engines/tiles/sample/window_plan.h"

#include <algorithm>

namespace solitaire::tiles {

WindowPlan::WindowPlan(const Problem& problem) : problem_(problem), places_(problem.sites(), kOutside) {
  for (const SoftShape& shape : problem.style().shapes) {
    auto& offsets = offsets_.emplace_back();
    for_each_point(shape.patches.shape(), [&](const Point& at) { offsets.push_back(at); });
  }
}

bool WindowPlan::lay_out(const Grid& map, std::span<const std::uint32_t> sites, Weights& weights) {
  if (steps_.size() < sites.size()) steps_.resize(sites.size());
  used_ = sites.size();
  parts_.clear();
  needed_until_.assign(used_, 0);
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
        need(other, place);
      }
    }
  }
}

void WindowPlan::find_factors(const Grid& map, std::uint32_t place, Weights& weights) {
  const Point at = problem_.size().point(steps_[place].site);
  for (std::size_t shape = 0; shape < offsets_.size(); ++shape) {
    for (std::size_t own = 0; own < offsets_[shape].size(); ++own) {
      const Point& offset = offsets_[shape][own];
      Point anchor = at;
      if (!problem_.topology().move(anchor, {-offset[0], -offset[1], -offset[2]})) continue;
      close_factor(map, place, shape, anchor, own, weights);
    }
  }
}

/// Notes the factor at an anchor, whose place `own` is the site at `place`, if it closes there.
void WindowPlan::close_factor(const Grid& map, std::uint32_t place, std::size_t shape, const Point& anchor,
                              std::size_t own, Weights& weights) {
  const PatchIndex& patches = problem_.style().shapes[shape].patches;
  const auto first = static_cast<std::uint32_t>(parts_.size());
  ClosingFactor factor{
      &patches, patches.table(), nullptr, 0, static_cast<unsigned>(own) * patches.bits(), first, first};
  ZoneSet zones = 0;
  for (std::size_t part = 0; part < offsets_[shape].size(); ++part) {
    const std::size_t site = problem_.topology().site(anchor, offsets_[shape][part]);
    if (site == Topology::kNone) return parts_.resize(first);
    zones |= ZoneSet{1} << problem_.zone(site);
    const unsigned shift = static_cast<unsigned>(part) * patches.bits();
    const std::uint32_t other = place_of(site);
    if (other == kOutside) {
      factor.standing |= PatchCode{map[site]} << shift;
    } else if (other > place) {
      return parts_.resize(first);
    } else if (part != own) {
      parts_.push_back({other, shift});  // the place; assign_slots() knows the slot
    }
  }
  factor.multipliers = weights.of(shape, zones).data();
  PlanStep& step = steps_[place];
  factor.end_part = static_cast<std::uint32_t>(parts_.size());
  if (factor.end_part == first) {
    step.tiles.for_each([&](Tile tile) {
      step.own[tile] *=
          factor.multipliers[patches.find(factor.standing | PatchCode{tile} << factor.own_shift)];
    });
    return;
  }
  for (const ClosingFactor::Part& part : parts(factor)) need(part.slot, place);
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
    step.needed = needed_until_[place] > place;
    for (std::uint32_t slot = 0; slot < slots; ++slot) {
      if (holder[slot] != kOutside && needed_until_[holder[slot]] <= place) holder[slot] = kOutside;
      if (holder[slot] != kOutside) step.kept |= ones << (slot * bits);
    }
    if (!step.needed) continue;
    const auto free = std::ranges::find(holder, kOutside);
    if (free == holder.end()) return false;
    *free = place;
    step.slot = slot_of_[place] = static_cast<unsigned>(free - holder.begin()) * bits;
  }
  return true;
}

}  // namespace solitaire::tiles
