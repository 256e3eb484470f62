#pragma once
#include <map>
#include <optional>
#include <string>
#include <tiny_gltf.h>

#include "scene/color.h"

namespace solitaire {

/// Writes the unit box on the ground around the origin into an output file: its geometry once, and a mesh for
/// each colour.
class BoxMeshes {
 public:
  explicit BoxMeshes(tinygltf::Model& to) : to_(to) {}

  int mesh(const Color& color);
  int material(const Color& color);

 private:
  void add_geometry();

  tinygltf::Model& to_;
  std::optional<tinygltf::Primitive> geometry_;
  std::map<std::string, int> meshes_;  // by the colour's text
  std::map<std::string, int> materials_;
};

}  // namespace solitaire
