#include "scene/voxel_asset.h"

#include <map>
#include <memory>
#include <set>

#include "scene/gltf/asset_model.h"
#include "scene/gltf/box_mesh.h"
#include "scene/gltf/mesh_builder.h"

namespace solitaire {
namespace {

/// A primitive has no more vertices than its indices can tell apart.
constexpr std::size_t kMostFaces = 16'000;

/// Collects the faces of one colour.
class FaceParts {
 public:
  void add(const std::vector<Vec3>& corners) {
    if (parts_.empty() || faces_ == kMostFaces) {
      parts_.emplace_back();
      faces_ = 0;
    }
    parts_.back().face(corners);
    ++faces_;
  }
  const std::vector<MeshBuilder>& parts() const { return parts_; }

 private:
  std::vector<MeshBuilder> parts_;
  std::size_t faces_ = 0;  // of the last part
};

/// Returns the corners of the face of a cube that looks along an axis, or against it, in glTF's axes:
/// counter-clockwise seen from outside.
std::vector<Vec3> face_of(const std::array<int, 3>& cube, std::size_t axis, bool back, double side) {
  static constexpr std::array<std::array<int, 2>, 4> kAround{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::vector<Vec3> corners;
  for (const auto& [u, v] : kAround) {
    Vec3 corner{};
    for (std::size_t each = 0; each < 3; ++each) corner.at(each) = cube.at(each);
    corner.at(axis) += back ? 0 : 1;
    corner.at((axis + 1) % 3) += back ? v : u;
    corner.at((axis + 2) % 3) += back ? u : v;
    corners.push_back({corner[0] * side, corner[2] * side, -corner[1] * side});
  }
  return corners;
}

std::map<Color, FaceParts> faces_by_color(const std::vector<Voxel>& voxels, double side) {
  std::set<std::array<int, 3>> taken;
  for (const Voxel& voxel : voxels) taken.insert(voxel.at);
  std::map<Color, FaceParts> faces;
  for (const Voxel& voxel : voxels) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool back : {false, true}) {
        std::array<int, 3> beside = voxel.at;
        beside.at(axis) += back ? -1 : 1;
        if (taken.count(beside) == 0) faces[voxel.color].add(face_of(voxel.at, axis, back, side));
      }
    }
  }
  return faces;
}

}  // namespace

Asset voxel_asset(const std::string& name, const std::vector<Voxel>& voxels, double side) {
  auto model = std::make_shared<AssetModel>();
  tinygltf::Model& gltf = model->gltf;
  gltf.buffers.emplace_back();
  Asset asset;
  asset.name = name;
  tinygltf::Mesh mesh;
  BoxMeshes materials(gltf);
  for (const auto& [color, faces] : faces_by_color(voxels, side)) {
    for (const MeshBuilder& part : faces.parts()) {
      mesh.primitives.push_back(part.write(gltf));
      mesh.primitives.back().material = materials.material(Paint{"", color, std::nullopt});
      asset.box.include(part.box().low);
      asset.box.include(part.box().high);
    }
  }
  gltf.meshes.push_back(std::move(mesh));
  gltf.nodes.emplace_back().mesh = 0;
  model->roots = {0};
  model->primary_material = 0;
  asset.color = voxels.front().color;
  asset.model = std::move(model);
  return asset;
}

}  // namespace solitaire
