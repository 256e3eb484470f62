#include "engines/tiles/sample/slice.h"

#include <algorithm>
#include <cmath>

#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/model/uniform.h"

namespace solitaire::tiles {

Slice::Slice(const Problem& problem) : problem_(problem) {
  const auto add = [&](const Size& shape, std::size_t number, bool is_pair) {
    Kind& kind = kinds_.emplace_back(Kind{shape, number, is_pair, {}});
    for_each_point(shape, [&](const Point& at) { kind.offsets.push_back(at); });
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Size pair;
    pair.extent[axis] = 2;
    if (problem.size().extent[axis] > 1 || problem.topology().periodic[axis]) add(pair, axis, true);
  }
  for (std::size_t shape = 0; shape < problem.style().shapes.size(); ++shape) {
    add(problem.style().shapes[shape].patches.shape(), shape, false);
  }
  const std::size_t factors = kinds_.size() * problem.sites();
  required_.resize(factors);
  place_of_.resize(factors);
  seen_at_.resize(factors);
  for (std::size_t factor = 0; factor < factors; ++factor) {
    const Kind& kind = kinds_[factor / problem.sites()];
    required_[factor] = kind.is_pair && is_whole(kind, factor % problem.sites());
  }
}

bool Slice::is_whole(const Kind& kind, std::size_t anchor) const {
  const Point at = problem_.size().point(anchor);
  return std::ranges::all_of(kind.offsets, [&](const Point& offset) {
    return problem_.topology().site(at, offset) != Topology::kNone;
  });
}

bool Slice::is_known(const Grid& map, const Kind& kind, std::size_t anchor) const {
  const SoftShape& soft = problem_.style().shapes[kind.number];
  PatchCode code = 0;
  const Point at = problem_.size().point(anchor);
  if (!patch_at(map, problem_.topology(), kind.shape, at, soft.patches.bits(), code)) return false;
  ZoneSet zones = 0;
  for (const Point& offset : kind.offsets)
    zones |= ZoneSet{1} << problem_.zone(problem_.topology().site(at, offset));
  const std::uint32_t patch = soft.patches.find(code);
  return soft.log_weight(zones, patch) > soft.log_weight(zones, 0);
}

bool Slice::is_met(const Grid& map, const Kind& kind, std::size_t anchor) const {
  if (!kind.is_pair) return is_known(map, kind, anchor);
  const std::size_t next = problem_.topology().neighbor(problem_.size().point(anchor), kind.number, 1);
  return problem_.allowed(kind.number, anchor, map[anchor], next, map[next]);
}

void Slice::draw(const Grid& map, RandomStream& random) {
  for (std::size_t factor = 0; factor < required_.size(); ++factor) {
    const Kind& kind = kinds_[factor / problem_.sites()];
    const std::size_t anchor = factor % problem_.sites();
    if (kind.is_pair || !is_known(map, kind, anchor)) {
      required_[factor] = kind.is_pair && required_[factor];
      continue;
    }
    // The threshold is uniform up to the factor's value; unknown patches are worth 1, known ones 1 + epsilon.
    const auto& weights = problem_.style().shapes[kind.number].log_weights[0];
    const double value = std::exp(*std::ranges::max_element(weights));
    required_[factor] = uniform(random) * value >= 1;
  }
}

void Slice::look_at(const Grid& map) {
  unmet_.clear();
  std::ranges::fill(place_of_, 0);
  for (std::uint32_t factor = 0; factor < required_.size(); ++factor) {
    if (required_[factor]) {
      set_met(factor, is_met(map, kinds_[factor / problem_.sites()], factor % problem_.sites()));
    }
  }
}

void Slice::set_met(std::uint32_t factor, bool met) {
  if (met == (place_of_[factor] == 0)) return;
  if (!met) {
    unmet_.push_back(factor);
    place_of_[factor] = static_cast<std::uint32_t>(unmet_.size());
    return;
  }
  const std::uint32_t place = place_of_[factor] - 1;
  unmet_[place] = unmet_.back();
  place_of_[unmet_[place]] = place + 1;
  unmet_.pop_back();
  place_of_[factor] = 0;
}

/// Calls `visit(factor, kind, anchor)` once for each required factor that sees some of the sites.
template <class Visit>
void Slice::for_each_around(const std::vector<std::uint32_t>& sites, Visit visit) {
  ++visit_;
  for (const std::uint32_t site : sites) {
    const Point at = problem_.size().point(site);
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
      for (const Point& own : kinds_[kind].offsets) {
        const std::size_t anchor = problem_.topology().site(at, {-own[0], -own[1], -own[2]});
        if (anchor == Topology::kNone) continue;
        const std::size_t factor = kind * problem_.sites() + anchor;
        if (!required_[factor] || seen_at_[factor] == visit_) continue;
        seen_at_[factor] = visit_;
        visit(static_cast<std::uint32_t>(factor), kinds_[kind], anchor);
      }
    }
  }
}

void Slice::look_again(const Grid& map, const std::vector<std::uint32_t>& sites) {
  for_each_around(sites, [&](std::uint32_t factor, const Kind& kind, std::size_t anchor) {
    set_met(factor, is_met(map, kind, anchor));
  });
}

std::size_t Slice::unmet_around(const Grid& map, const std::vector<std::uint32_t>& sites) {
  std::size_t count = 0;
  for_each_around(sites, [&](std::uint32_t, const Kind& kind, std::size_t anchor) {
    count += is_met(map, kind, anchor) ? 0 : 1;
  });
  return count;
}

Slice::Scope Slice::random_unmet(RandomStream& random) const {
  const std::uint32_t factor = unmet_[random.below(unmet_.size())];
  return {problem_.size().point(factor % problem_.sites()), kinds_[factor / problem_.sites()].shape};
}

}  // namespace solitaire::tiles
