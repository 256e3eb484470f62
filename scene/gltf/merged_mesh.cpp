#include "scene/gltf/merged_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/error.h"
#include "scene/gltf/accessor_view.h"
#include "scene/gltf/mesh_copy.h"

namespace solitaire {
namespace {

template <class T>
void append(std::vector<unsigned char>& bytes, const T& value) {
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof(T));
  std::memcpy(bytes.data() + end, &value, sizeof(T));
}

void append(std::vector<unsigned char>& bytes, const Vec3& point) {
  for (const double part : point) append(bytes, static_cast<float>(part));
}

/// How directions that stand upright on a surface are transformed.
Affine of_normals(const Transform& transform) {
  Transform inverse{{}, transform.rotation, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) inverse.scale[axis] = 1 / transform.scale[axis];
  return to_affine(inverse);
}

Vec3 unit(Vec3 direction) {
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  for (double& part : direction) part /= length > 0 ? length : 1;
  return direction;
}

/// Adds an accessor like one of the model, with these elements in place of its own.
int add_accessor(tinygltf::Model& model, int like, const std::vector<unsigned char>& bytes, std::size_t count,
                 int target) {
  tinygltf::Accessor accessor = model.accessors[static_cast<std::size_t>(like)];
  accessor.bufferView = append_view(model, bytes, target);
  accessor.byteOffset = 0;
  accessor.count = count;
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

void set_ends(tinygltf::Accessor& accessor, const Box3& box) {
  for (const bool low : {true, false}) {
    std::vector<double>& ends = low ? accessor.minValues : accessor.maxValues;
    ends.clear();
    for (const double part : low ? box.low : box.high)
      ends.push_back(static_cast<double>(static_cast<float>(part)));
  }
}

int merged_positions(tinygltf::Model& model, int accessor, const std::vector<Transform>& transforms) {
  std::vector<unsigned char> bytes;
  Box3 box;
  const AccessorView view(model, accessor);
  for (const Transform& transform : transforms) {
    const Affine map = to_affine(transform);
    for (std::size_t i = 0; i < view.count(); ++i) {
      const Vec3 point = map.apply(view.point(i));
      append(bytes, point);
      box.include(point);
    }
  }
  const int merged =
      add_accessor(model, accessor, bytes, view.count() * transforms.size(), TINYGLTF_TARGET_ARRAY_BUFFER);
  set_ends(model.accessors[static_cast<std::size_t>(merged)], box);
  return merged;
}

int merged_normals(tinygltf::Model& model, int accessor, const std::vector<Transform>& transforms) {
  std::vector<unsigned char> bytes;
  const AccessorView view(model, accessor);
  for (const Transform& transform : transforms) {
    const Affine map = of_normals(transform);
    for (std::size_t i = 0; i < view.count(); ++i) append(bytes, unit(map.apply(view.point(i))));
  }
  return add_accessor(model, accessor, bytes, view.count() * transforms.size(), TINYGLTF_TARGET_ARRAY_BUFFER);
}

/// Repeats what does not change with the place of a copy, such as colours and places in textures.
int repeated(tinygltf::Model& model, int accessor, std::size_t times) {
  std::vector<unsigned char> bytes;
  const AccessorView view(model, accessor);
  for (std::size_t copy = 0; copy < times; ++copy) {
    for (std::size_t i = 0; i < view.count(); ++i)
      bytes.insert(bytes.end(), view.element(i), view.element(i) + view.element_bytes());
  }
  return add_accessor(model, accessor, bytes, view.count() * times, TINYGLTF_TARGET_ARRAY_BUFFER);
}

int merged_indices(tinygltf::Model& model, const tinygltf::Primitive& primitive, std::size_t times) {
  const auto vertices =
      static_cast<std::uint32_t>(AccessorView(model, primitive.attributes.at("POSITION")).count());
  std::vector<std::uint32_t> once;
  if (primitive.indices == -1) {
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) once.push_back(vertex);
  } else {
    const AccessorView view(model, primitive.indices);
    for (std::size_t i = 0; i < view.count(); ++i) once.push_back(view.index(i));
  }
  std::vector<unsigned char> bytes;
  for (std::uint32_t copy = 0; copy < times; ++copy) {
    for (const std::uint32_t vertex : once) append(bytes, copy * vertices + vertex);
  }
  tinygltf::Accessor accessor;
  accessor.bufferView = append_view(model, bytes, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.count = once.size() * times;
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

tinygltf::Primitive merged(tinygltf::Model& model, const tinygltf::Primitive& primitive,
                           const std::vector<Transform>& transforms) {
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1)
    throw SceneError("a model is no mesh of triangles, and cannot be merged with others");
  tinygltf::Primitive result = primitive;
  result.mode = TINYGLTF_MODE_TRIANGLES;
  result.indices = merged_indices(model, primitive, transforms.size());
  for (auto& [name, accessor] : result.attributes) {
    accessor = name == "POSITION" ? merged_positions(model, accessor, transforms)
               : name == "NORMAL" ? merged_normals(model, accessor, transforms)
                                  : repeated(model, accessor, transforms.size());
  }
  result.attributes.erase("TANGENT");  // what shows a texture's bumps computes them from the rest
  return result;
}

}  // namespace

int merged_mesh(tinygltf::Model& model, int mesh, const std::vector<Transform>& transforms) {
  const tinygltf::Mesh source = model.meshes[static_cast<std::size_t>(mesh)];
  tinygltf::Mesh result;
  result.name = source.name;
  for (const tinygltf::Primitive& primitive : source.primitives)
    result.primitives.push_back(merged(model, primitive, transforms));
  model.meshes.push_back(std::move(result));
  return static_cast<int>(model.meshes.size()) - 1;
}

void remove_unused_meshes(tinygltf::Model& model) {
  std::vector<bool> shown(model.meshes.size());
  for (const tinygltf::Node& node : model.nodes) {
    if (node.mesh != -1) shown[static_cast<std::size_t>(node.mesh)] = true;
  }
  std::vector<int> number(model.meshes.size(), -1);
  std::vector<tinygltf::Mesh> kept;
  for (std::size_t mesh = 0; mesh < shown.size(); ++mesh) {
    if (!shown[mesh]) continue;
    number[mesh] = static_cast<int>(kept.size());
    kept.push_back(std::move(model.meshes[mesh]));
  }
  model.meshes = std::move(kept);
  for (tinygltf::Node& node : model.nodes) {
    if (node.mesh != -1) node.mesh = number[static_cast<std::size_t>(node.mesh)];
  }
}

}  // namespace solitaire
