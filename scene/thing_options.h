#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/outline.h"
#include "scene/placed_thing.h"

namespace solitaire {

/// What a scene takes from the further named arguments of a thing.
struct ThingOptions {
  std::optional<std::string> material;  // as JSON text
  bool tint = false;           // the colour tints all surfaces instead of replacing that of the first
  double pitch = 0, roll = 0;  // degrees: its front is raised; its right, seen from its front, is lowered
  double scale = 1;            // of its own size
  std::string label;           // what a drawing writes on it in place of its name
  Outline outline;             // in units, as it is given
  double extrude = 1;          // how high what stands on the outline is, in units
  std::vector<std::string> parents;  // the tree nodes above it in place of the program's calls
};

/// Reads "material", "tint", "pitch", "roll", "scale", "label", "outline" ([[0, 0], [4, 0], [2, 3]]),
/// "extrude" and "parent" ("level 1/kitchen"). Throws SceneError, which names the place call, for one that
/// has another type than it should.
ThingOptions read_options(const PlacedThing& thing);

/// Throws the ThingError that says what is wrong with a thing.
[[noreturn]] void refuse(const PlacedThing& thing, const std::string& what);

}  // namespace solitaire
