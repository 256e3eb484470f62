#include "base/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace solitaire {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> previous(b.size() + 1);
  std::iota(previous.begin(), previous.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::size_t> row{i + 1};
    for (std::size_t j = 0; j < b.size(); ++j) {
      row.push_back(std::min({previous[j + 1] + 1, row[j] + 1, previous[j] + (a[i] == b[j] ? 0U : 1U)}));
    }
    previous = std::move(row);
  }
  return previous.back();
}

bool same_letters(std::string a, std::string b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

/// Returns the candidate that is nearest, if one is nearer than the distance.
std::string nearer_than(std::size_t best_distance, std::string_view name,
                        const std::vector<std::string>& candidates) {
  std::string best;
  for (const std::string& candidate : candidates) {
    const auto [shorter, longer] = std::minmax({name.size(), candidate.size()});
    if (longer - shorter >= best_distance) continue;
    std::size_t distance = edit_distance(name, candidate);
    if (distance == 2 && same_letters(std::string(name), candidate)) distance = 1;  // two letters swapped
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  // Of a short name, two letters are most of it.
  return nearer_than(name.size() <= 5 ? 2 : 3, name, candidates);
}

std::string misspelled_name(std::string_view name, const std::vector<std::string>& candidates) {
  return nearer_than(2, name, candidates);
}

std::vector<std::string> nearest_names(std::string_view name, std::vector<std::string> candidates,
                                       std::size_t count) {
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(std::string(name), candidate);
    ranked.emplace_back(distance, std::move(candidate));
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) nearest.push_back(ranked[i].second);
  return nearest;
}

}  // namespace solitaire
