#include "engines/solve/series_distance.h"

#include <algorithm>
#include <utility>

#include "engines/tuning.h"

namespace solitaire {

void SeriesDistance::add(const Solution& solution) {
  if (all_.size() >= tuning::kKeptApart) return;
  HashedFeatures features(choice_features(solution.choices));
  if (distance(features) < near_) near_ /= 2;
  for (Near& each : aside_)
    each.distance = std::min(each.distance, overlap_of(each.features, features).distance());
  all_.push_back(std::move(features));
}

std::optional<Solution> SeriesDistance::next(const Find& find) {
  if (all_.size() >= tuning::kKeptApart) return aside_.empty() ? find() : take_aside();
  if (std::optional<Solution> far = take_aside(near_)) return far;
  while (aside_.size() <= most_aside_) {
    std::optional<Solution> found = find();
    if (!found) return std::nullopt;
    HashedFeatures features(choice_features(found->choices));
    const double far = distance(features);
    if (far >= near_) return found;
    aside_.push_back({std::move(*found), std::move(features), far});
  }
  return take_aside();
}

/// Returns the farthest of the solutions that were put aside, if it is far enough.
std::optional<Solution> SeriesDistance::take_aside(double least) {
  const auto farthest = std::ranges::max_element(aside_, {}, &Near::distance);
  if (farthest == aside_.end() || farthest->distance < least) return std::nullopt;
  Solution taken = std::move(farthest->solution);
  aside_.erase(farthest);
  return taken;
}

/// Returns how far it is from the nearest solution of those before.
double SeriesDistance::distance(const HashedFeatures& features) const {
  double nearest = 1;
  for (const HashedFeatures& each : all_) nearest = std::min(nearest, overlap_of(features, each).distance());
  return nearest;
}

}  // namespace solitaire
