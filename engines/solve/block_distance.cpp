#include "engines/solve/block_distance.h"

#include <algorithm>
#include <utility>

#include "engines/tuning.h"

namespace solitaire {

void BlockDistance::add(const Solution& solution) {
  if (all_.size() < tuning::kKeptApart) all_.emplace_back(choice_features(solution.choices));
}

void BlockDistance::start_block() {
  others_ = all_.size() < tuning::kKeptApart ? all_.size() : 0;
  aside_.clear();
  in_vain_ = to_skip_ = 0;
}

std::optional<Solution> BlockDistance::next(const Find& find) {
  if (others_ == 0) return find();
  if (to_skip_ > 0) {
    --to_skip_;
    return aside_.empty() ? find() : take_aside();
  }
  for (unsigned i = 0; i <= tuning::kFurtherSearches; ++i) {
    std::optional<Solution> found = find();
    if (!found) return std::nullopt;
    const double far = distance(*found);
    if (far >= near_) {
      in_vain_ = 0;
      return found;
    }
    aside_.push_back({std::move(*found), far});
  }
  ++in_vain_;
  to_skip_ = (1U << std::min(in_vain_, 20U)) - 1;
  return take_aside();
}

std::optional<Solution> BlockDistance::take_aside() {
  const auto farthest = std::ranges::max_element(aside_, {}, &Near::distance);
  if (farthest == aside_.end()) return std::nullopt;
  Solution taken = std::move(farthest->solution);
  aside_.erase(farthest);
  return taken;
}

double BlockDistance::distance(const Solution& solution) const {
  const HashedFeatures features(choice_features(solution.choices));
  double nearest = 1;
  for (std::size_t i = 0; i < others_; ++i)
    nearest = std::min(nearest, overlap_of(features, all_[i]).distance());
  return nearest;
}

}  // namespace solitaire
