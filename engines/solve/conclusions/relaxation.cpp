#include "engines/solve/conclusions/relaxation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engines/tuning.h"

namespace solitaire {
namespace {

constexpr double kTolerance = 1e-6;

class Relaxation {
 public:
  explicit Relaxation(std::span<const Interval> ranges) : ranges_(ranges) {
    for (const Interval& range : ranges)
      point_.push_back((static_cast<double>(range.lo) + static_cast<double>(range.hi)) / 2);
  }

  /// Moves to where the row holds. Returns false if it held before.
  bool move(const LinearRow& row) {
    double excess = -static_cast<double>(row.most), length = 0, size = 1;
    for (const LinearTerm& term : row.terms) {
      const auto factor = static_cast<double>(term.factor);
      excess += factor * point_[term.unknown];
      size += std::abs(factor * point_[term.unknown]);
      if (can_move(term)) length += factor * factor;
    }
    if (excess <= kTolerance * size) return false;
    for (const LinearTerm& term : row.terms) {
      if (!can_move(term)) continue;
      const auto [lo, hi] = ranges_[term.unknown];
      double& at = point_[term.unknown];
      at = std::clamp(at - static_cast<double>(term.factor) * excess / length, static_cast<double>(lo),
                      static_cast<double>(hi));
    }
    return true;
  }

 private:
  /// Returns true if the unknown is not yet at the end that is best for the row.
  bool can_move(const LinearTerm& term) const {
    const auto [lo, hi] = ranges_[term.unknown];
    return term.factor > 0 ? point_[term.unknown] > static_cast<double>(lo)
                           : point_[term.unknown] < static_cast<double>(hi);
  }

  std::span<const Interval> ranges_;
  std::vector<double> point_;
};

}  // namespace

bool has_point(std::span<const LinearRow> rows, std::span<const Interval> ranges) {
  Relaxation relaxation(ranges);
  for (std::size_t sweep = 0; sweep < tuning::kMostRelaxations; ++sweep) {
    bool moved = false;
    for (const LinearRow& row : rows) moved = relaxation.move(row) || moved;
    if (!moved) return true;
  }
  return false;
}

}  // namespace solitaire
