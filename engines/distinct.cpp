#include "engines/distinct.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/hash.h"
#include "solitaire/value/plain_value.h"

namespace solitaire {
namespace {

constexpr std::array<std::string_view, 6> kLooks = {"material", "tint", "pitch", "roll", "scale", "outline"};

std::string look(const PlacedObject& placement) {
  std::string text =
      fmt::format("{} {} {} {}", json_string(placement.asset), placement.at, placement.size, placement.turn);
  if (placement.angle) text += fmt::format(" angle {}", *placement.angle);
  if (placement.color) text += fmt::format(" color {}", *placement.color);
  for (const std::string_view looks : kLooks) {
    for (const auto& [name, value] : placement.extras) {
      if (name == looks && value != "null") text += fmt::format(" {} {}", name, value);
    }
  }
  return text;
}

/// The names and extras of placed things, in any order.
std::uint64_t hash_of_names(const Solution& solution) {
  std::uint64_t sum = 0;
  for (const PlacedObject& placement : solution.placements) {
    std::uint64_t hash = std::hash<std::string>{}(placement.name);
    for (const auto& [name, value] : placement.extras) {
      if (!is_look(name))
        hash = mix(mix(hash, std::hash<std::string>{}(name)), std::hash<std::string>{}(value));
    }
    sum += hash;
  }
  return sum;
}

}  // namespace

bool is_look(std::string_view extra) { return std::ranges::find(kLooks, extra) != kLooks.end(); }

std::vector<std::string> looks_of(const Solution& solution) {
  std::vector<std::string> looks;
  for (const PlacedObject& placement : solution.placements) looks.push_back(look(placement));
  std::sort(looks.begin(), looks.end());
  return looks;
}

bool DistinctResults::add(const Solution& solution) {
  const std::uint64_t names = hash_of_names(solution);
  const auto [known, is_new] = seen_.try_emplace(key(solution, apart_), names);
  if (known->second != names) names_differed_ = true;
  return is_new;
}

std::string DistinctResults::key(const Solution& solution, Apart apart) {
  if (apart == Apart::kValue) return text_of_equal(solution.before_output.value_or(solution.value));
  return fmt::format("{}\n{}", text_of_equal(solution.value), fmt::join(looks_of(solution), "\n"));
}

}  // namespace solitaire
