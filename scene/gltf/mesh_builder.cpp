#include "scene/gltf/mesh_builder.h"

#include <cmath>
#include <cstring>

#include "scene/error.h"
#include "scene/gltf/mesh_copy.h"

namespace solitaire {
namespace {

constexpr std::size_t kMostVertices = 65535;  // of 16-bit indices, whose last value restarts strips

Vec3 face_normal(const std::vector<Vec3>& corners) {  // Newell's, so that slivers do no harm
  Vec3 normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % corners.size()];
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      normal[axis] += (a[u] - b[u]) * (a[v] + b[v]);
    }
  }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (double& part : normal) part /= length;
  return normal;
}

template <typename T>
std::vector<unsigned char> bytes_of(const std::vector<T>& numbers) {
  std::vector<unsigned char> bytes(numbers.size() * sizeof(T));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

int add_vectors(tinygltf::Model& to, const std::vector<float>& numbers) {
  tinygltf::Accessor accessor;
  accessor.bufferView = append_view(to, bytes_of(numbers), TINYGLTF_TARGET_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = TINYGLTF_TYPE_VEC3;
  accessor.count = numbers.size() / 3;
  to.accessors.push_back(std::move(accessor));
  return static_cast<int>(to.accessors.size()) - 1;
}

int add_indices(tinygltf::Model& to, const std::vector<std::uint16_t>& indices) {
  tinygltf::Accessor accessor;
  accessor.bufferView = append_view(to, bytes_of(indices), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.count = indices.size();
  to.accessors.push_back(std::move(accessor));
  return static_cast<int>(to.accessors.size()) - 1;
}

}  // namespace

void MeshBuilder::face(const std::vector<Vec3>& corners, const Affine& map) {
  std::vector<Vec3> mapped;
  for (const Vec3& corner : corners) mapped.push_back(map.apply(corner));
  face(mapped, std::vector<Vec3>(mapped.size(), face_normal(mapped)));
}

void MeshBuilder::face(const std::vector<Vec3>& corners, const std::vector<Vec3>& normals) {
  const std::size_t first = positions_.size() / 3;
  if (first + corners.size() > kMostVertices) throw SceneError("a mesh has too many vertices");
  for (const Vec3& corner : corners) {
    for (const double part : corner) positions_.push_back(static_cast<float>(part));
  }
  for (const Vec3& normal : normals) {
    for (const double part : normal) normals_.push_back(static_cast<float>(part));
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    for (const std::size_t corner : {first, first + i - 1, first + i}) {
      indices_.push_back(static_cast<std::uint16_t>(corner));
    }
  }
}

void MeshBuilder::add_box(const Box3& box, const Affine& map) {
  // Corners as Box3::corner numbers them, each face counter-clockwise from outside.
  constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& corners : kFaces) {
    face({box.corner(corners[0]), box.corner(corners[1]), box.corner(corners[2]), box.corner(corners[3])},
         map);
  }
}

Box3 MeshBuilder::box() const {
  Box3 box;
  for (std::size_t i = 0; i < positions_.size(); i += 3) {
    box.include({positions_[i], positions_[i + 1], positions_[i + 2]});
  }
  return box;
}

tinygltf::Primitive MeshBuilder::write(tinygltf::Model& to) const {
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int positions = primitive.attributes["POSITION"] = add_vectors(to, positions_);
  const Box3 bounds = box();
  auto& accessor = to.accessors[static_cast<std::size_t>(positions)];
  accessor.minValues.assign(bounds.low.begin(), bounds.low.end());
  accessor.maxValues.assign(bounds.high.begin(), bounds.high.end());
  primitive.attributes["NORMAL"] = add_vectors(to, normals_);
  primitive.indices = add_indices(to, indices_);
  return primitive;
}

}  // namespace solitaire
