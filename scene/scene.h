#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/assets.h"
#include "scene/color.h"
#include "scene/geometry.h"
#include "scene/opening.h"
#include "scene/outline.h"
#include "scene/paint.h"
#include "scene/placed_thing.h"

namespace solitaire {

/// The box that an object fills, in metres along the program's axes: x right, y into the depth, z up.
struct PlacedBox {
  Vec3 center{};               // of its base
  Vec3 size{};                 // width, depth, height before turning
  double angle = 0;            // degrees counter-clockwise seen from above
  double pitch = 0, roll = 0;  // before that; see ThingOptions. The middle of its base stays where it is.

  double top() const { return center[2] + size[2]; }
};

struct SceneObject {
  PlacedThing thing;
  const Asset* asset = nullptr;  // nullptr: a plain box
  PlacedBox box;
  std::optional<Paint> paint;        // always of a plain box
  Color color{};                     // as a plan shows it
  std::vector<std::string> parents;  // the names of the tree nodes above it, outermost first
  Transform node_transform;          // of its glTF node: brings the asset, or the unit box, to its place
  std::vector<Opening> openings;     // of a wall
  Outline outline;                   // that a box stands on in place of a rectangle, in the unit square
  std::string label;                 // what drawings write on it
};

/// A node of the scene's tree: an object, or a group for one call of the program.
struct SceneNode {
  std::string name;                   // unique within the scene, and harmless to importers
  std::vector<std::size_t> children;  // indices into Scene::nodes, in the order of the program's run
  std::optional<std::size_t> object;  // index into Scene::objects
};

/// What a solution shows. It refers to assets of the library that it was built with.
struct Scene {
  std::string title;
  std::vector<SceneNode> nodes;  // nodes[0] is the root; parents come before their children
  std::vector<SceneObject> objects;
};

/// Returns the box that a thing without an asset is drawn as, in its own frame: it stands on the ground
/// around the origin, as bundled assets do.
Box3 unit_box();

/// Returns the rotation of a box, in glTF's axes, which comes after a turn of its content by `turn` degrees.
Quaternion orientation(const PlacedBox& box, double turn = 0);

/// Returns the least box along the program's axes that holds this one.
Box3 bounds(const PlacedBox& box);
/// Returns that of all objects together; empty without any.
Box3 bounds(const Scene& scene);

/// Returns true for an object whose mesh no other one can have: a wall with openings, or an outline.
bool has_own_mesh(const SceneObject& object);

/// Returns true for a wall, which doors and windows open: an asset that says so, or a plain box that has
/// "wall" as a word of its name.
bool is_wall(const SceneObject& object);

/// Returns the object's name before it is made unique: the program's name for it, or that of its asset.
std::string plain_name(const SceneObject& object);

/// Returns what a drawing writes on the object: its label, or else its plain name.
std::string text_on(const SceneObject& object);

}  // namespace solitaire
