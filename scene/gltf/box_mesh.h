#pragma once
#include <map>
#include <optional>
#include <string>
#include <tiny_gltf.h>

#include "scene/paint.h"

namespace solitaire {

/// Writes the unit box on the ground around the origin into an output file: its geometry once, and a mesh for
/// each paint.
class BoxMeshes {
 public:
  explicit BoxMeshes(tinygltf::Model& to) : to_(to) {}

  int mesh(const Paint& paint);
  int material(const Paint& paint);

 private:
  void add_geometry();

  tinygltf::Model& to_;
  std::optional<tinygltf::Primitive> geometry_;
  std::map<std::string, int> meshes_;  // by the paint's text
  std::map<std::string, int> materials_;
};

}  // namespace solitaire
