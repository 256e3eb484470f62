#include "scene/gltf/box_mesh.h"

#include "scene/gltf/mesh_builder.h"
#include "scene/gltf/mesh_copy.h"

namespace solitaire {

int BoxMeshes::mesh(const Paint& paint) {
  const auto [place, is_new] = meshes_.try_emplace(paint.text(), 0);
  if (!is_new) return place->second;
  if (!geometry_) add_geometry();
  tinygltf::Mesh mesh;
  mesh.name = "box " + place->first;
  mesh.primitives.push_back(*geometry_);
  mesh.primitives.front().material = material(paint);
  to_.meshes.push_back(std::move(mesh));
  return place->second = static_cast<int>(to_.meshes.size()) - 1;
}

int BoxMeshes::material(const Paint& paint) {
  const auto [place, is_new] = materials_.try_emplace(paint.text(), 0);
  if (!is_new) return place->second;
  tinygltf::Material material;
  material.name = "box " + place->first;
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.8;
  to_.materials.push_back(painted(std::move(material), paint));
  return place->second = static_cast<int>(to_.materials.size()) - 1;
}

void BoxMeshes::add_geometry() {
  MeshBuilder builder;
  builder.add_box({{-0.5, 0, -0.5}, {0.5, 1, 0.5}});
  geometry_ = builder.write(to_);
}

}  // namespace solitaire
