#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace solitaire {

/// A thing that `place` put into the scene, as plain data, in the program's own coordinates and units: x runs
/// right, y into the depth, z up.
struct PlacedItem {
  std::string asset;            // a bundled asset's name, a path to a .glb/.gltf, or "" for a plain box
  std::array<double, 3> at{};   // the lowest corner of the object's box after turning
  std::vector<double> size;     // the box before turning: none (the asset's own), [w, d] or [w, d, h]
  int turn = 0;                 // quarter turns counter-clockwise seen from above, 0..3
  std::optional<double> angle;  // degrees counter-clockwise instead of `turn`
  std::optional<std::array<double, 3>> color;  // red, green, blue, each 0..1
  std::string name;                            // as the program gave it, or ""
  std::string address;                         // of this place call; unique within an execution
  std::vector<std::string> calls;  // the calls that led to it, outermost first: "wing[2]", "room[0]"
  std::vector<std::pair<std::string, std::string>>
      extras;          // further named arguments: name, value as JSON text
  std::string source;  // "file.sol:12:3": the place call, or the program's call of what the library placed
  std::string folder;  // of the file with the place call, relative to the script's; "" if it is the same
};

}  // namespace solitaire
