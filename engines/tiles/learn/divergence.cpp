#include "engines/tiles/learn/divergence.h"

#include <cmath>

#include "engines/tiles/learn/patterns.h"

namespace solitaire::tiles {
namespace {

constexpr double kExtra = 0.5;  // added to every count

void add(const PatchCounts& counts, PatchCounts& sum) {
  for (std::size_t number = 1; number < counts.count.size(); ++number)
    sum.count[number] += counts.count[number];
  sum.total += counts.total;
}

/// Returns the counts as probabilities of patches 1 and on.
std::vector<double> probabilities(const PatchCounts& counts, double total) {
  std::vector<double> result;
  const double all = total + kExtra * static_cast<double>(counts.count.size() - 1);
  for (std::size_t number = 1; number < counts.count.size(); ++number) {
    result.push_back((counts.count[number] * total / counts.total + kExtra) / all);
  }
  return result;
}

double relative_entropy(const std::vector<double>& p, const std::vector<double>& q) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] * std::log(p[i] / q[i]);
  return sum;
}

}  // namespace

Divergence divergence(const Style& style, std::span<const Grid> maps, const Size& shape) {
  PatchIndex patches(shape, style.tileset.size());
  for (const Exemplar& exemplar : style.exemplars) {
    if (!exemplar.negative) collect_patches(exemplar, patches);
  }
  for (const Grid& map : maps) {
    Exemplar as_exemplar;
    as_exemplar.grid = map;
    collect_patches(as_exemplar, patches);
  }
  const std::vector<double> none(patches.size() + 1);
  PatchCounts theirs{none, 0}, ours{none, 0};
  for (std::size_t zone = 0; zone < style.zones; ++zone) add(count_patches(style, zone, patches), theirs);
  for (const Grid& map : maps) add(count_patches(map, {map.size, {}}, patches), ours);
  if (theirs.total == 0 || ours.total == 0) return {};
  const std::vector<double> p = probabilities(ours, theirs.total), q = probabilities(theirs, theirs.total);
  std::vector<double> mean;
  for (std::size_t i = 0; i < p.size(); ++i) mean.push_back((p[i] + q[i]) / 2);
  return {relative_entropy(p, q), (relative_entropy(p, mean) + relative_entropy(q, mean)) / 2};
}

}  // namespace solitaire::tiles
