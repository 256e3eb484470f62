#include "library/scene_of.h"

#include <algorithm>
#include <utility>

#include "library/json.h"
#include "scene/build_scene.h"

namespace solitaire::api {
namespace {

constexpr std::array<double, 3> kRed = {0.85, 0.1, 0.1};

PlacedThing to_thing(const Placement& placement) {
  PlacedThing thing{placement.asset,  placement.at,     placement.size,    placement.turn,  placement.angle,
                    placement.color,  placement.name,   placement.address, placement.calls, {},
                    placement.extras, placement.source, placement.folder};
  for (const Choice& choice : placement.choices) thing.choices.push_back({choice.address, choice.value});
  return thing;
}

/// Tells whether something that depends on these choices is about the thing.
bool concerns(const std::vector<std::string>& choices, const Placement& placement) {
  return std::any_of(placement.choices.begin(), placement.choices.end(), [&](const Choice& choice) {
    return std::find(choices.begin(), choices.end(), choice.address) != choices.end();
  });
}

void mark(const Solution& solution, const Placement& placement, PlacedThing& marked) {
  Json broken = Json::array();
  for (const BrokenAssert& each : solution.broken) {
    if (concerns(each.choices, placement)) broken.push_back(to_text(each));
  }
  if (!broken.empty()) {
    marked.color = kRed;
    marked.marked = true;
    marked.extras.emplace_back("broken", json_text(broken));
  }
  Json unmet = Json::array();
  for (const UnmetWish& each : solution.unmet) {
    if (concerns(each.choices, placement)) unmet.push_back(to_text(each));
  }
  if (!unmet.empty()) marked.extras.emplace_back("unmet", json_text(unmet));
}

}  // namespace

Scene scene_of(const Solution& solution, const std::string& title, AssetLibrary& assets) {
  std::vector<PlacedThing> things;
  things.reserve(solution.placements.size());
  for (const Placement& placement : solution.placements) {
    things.push_back(to_thing(placement));
    mark(solution, placement, things.back());
  }
  return build_scene(std::move(things), solution.unit, title, assets);
}

}  // namespace solitaire::api
