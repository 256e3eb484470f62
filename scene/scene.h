#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/assets.h"
#include "scene/color.h"
#include "scene/geometry.h"
#include "solitaire/run/execution.h"

namespace solitaire {

/// Where an object stands, in metres along the program's axes: x right, y into the depth, z up.
struct PlacedBox {
  Vec3 center{};     // of its base
  Vec3 size{};       // width, depth, height before turning
  double angle = 0;  // degrees counter-clockwise seen from above

  double top() const { return center[2] + size[2]; }
};

struct SceneObject {
  Placement placement;
  const Asset* asset = nullptr;  // nullptr: a plain box
  PlacedBox box;
  Color color{};             // as a plan shows it
  Transform node_transform;  // of its glTF node: brings the asset, or the unit box, to its place
};

/// A group (one call of the program) or an object.
struct SceneNode {
  std::string name;                   // unique within the scene, and harmless to importers
  std::vector<std::size_t> children;  // indices into Scene::nodes, in the order of the program's run
  std::optional<std::size_t> object;  // index into Scene::objects
};

/// What a solution shows. Refers to assets of the library it was built with.
struct Scene {
  std::string title;
  std::vector<SceneNode> nodes;  // nodes[0] is the root; parents come before their children
  std::vector<SceneObject> objects;
};

/// What the object is called before it is made unique: as the program named it, or after its asset.
std::string plain_name(const SceneObject& object);

/// `unit` is the length of one program unit in metres. Throws SceneError for an asset that cannot be used and
/// for sizes or places that are no finite, sensible numbers, naming the place call.
Scene build_scene(const std::vector<Placement>& placements, double unit, const std::string& title,
                  AssetLibrary& assets);

}  // namespace solitaire
