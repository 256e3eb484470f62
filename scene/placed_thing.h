#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace solitaire {

/// A choice that decided about a thing, and what it came to.
struct DecidingChoice {
  std::string address;
  std::variant<bool, std::int64_t, double> value;
};

/// A thing that a scene shows, in the program's own coordinates and units: x runs right, y into the depth, z
/// up.
struct PlacedThing {
  std::string asset;            // a bundled asset's name, a path to a .glb or .gltf, or "" for a plain box
  std::array<double, 3> at{};   // the lowest corner of its box after turning
  std::vector<double> size;     // its box before turning: none (the asset's own), [w, d] or [w, d, h]
  int turn = 0;                 // quarter turns counter-clockwise seen from above
  std::optional<double> angle;  // degrees counter-clockwise instead of `turn`
  std::optional<std::array<double, 3>> color;  // red, green, blue, each 0..1
  std::string name;                            // as the program gave it, or ""
  std::string address;                         // unique within a scene
  std::vector<std::string> groups;  // the tree nodes above it, outermost first: "wing[2]", "room[0]"
  std::vector<DecidingChoice> choices;
  std::vector<std::pair<std::string, std::string>> extras;  // further facts: name, value as JSON text
  std::string source;                                       // the place in the program: "file.sol:12:3"
  std::string folder;   // of that file, relative to the script's; its models are looked for there first
  bool marked = false;  // has its colour all over, whatever it is made of, so that it is seen
};

}  // namespace solitaire
