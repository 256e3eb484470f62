#include "engines/distinct.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "solitaire/value/plain_value.h"

namespace solitaire {
namespace {

std::string look(const PlacedObject& placement) {
  std::string text =
      fmt::format("{} {} {} {}", json_string(placement.asset), placement.at, placement.size, placement.turn);
  if (placement.angle) text += fmt::format(" angle {}", *placement.angle);
  if (placement.color) text += fmt::format(" color {}", *placement.color);
  return text;
}

}  // namespace

std::vector<std::string> looks_of(const Solution& solution) {
  std::vector<std::string> looks;
  for (const PlacedObject& placement : solution.placements) looks.push_back(look(placement));
  std::sort(looks.begin(), looks.end());
  return looks;
}

std::string DistinctResults::key(const Solution& solution) {
  return fmt::format("{}\n{}", to_json(solution.value), fmt::join(looks_of(solution), "\n"));
}

}  // namespace solitaire
