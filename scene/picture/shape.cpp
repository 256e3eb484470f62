#include "scene/picture/shape.h"

#include <algorithm>
#include <tiny_gltf.h>

#include "scene/gltf/accessor_view.h"
#include "scene/gltf/asset_model.h"
#include "scene/picture/normal_map.h"
#include "scene/scene.h"

namespace solitaire {
namespace {

const Finish kCutFinish{{0.11F, 0.105F, 0.10F}, {}, 0, 1, 1, false};

Vec3 to_vec3(const Vector& v) { return {v.x, v.y, v.z}; }

Finish finish_of(const AssetModel& model, int material) {
  Finish finish;
  finish.is_primary = material == model.primary_material;
  if (material == -1) return finish;
  const auto& source = model.gltf.materials[static_cast<std::size_t>(material)];
  const auto& pbr = source.pbrMetallicRoughness;
  finish.color = to_vector({pbr.baseColorFactor[0], pbr.baseColorFactor[1], pbr.baseColorFactor[2]});
  finish.metallic = static_cast<float>(pbr.metallicFactor);
  finish.roughness = static_cast<float>(pbr.roughnessFactor);
  if (source.alphaMode == "BLEND") finish.opacity = static_cast<float>(pbr.baseColorFactor[3]);
  if (const auto& glow = source.emissiveFactor; glow.size() == 3)
    finish.glow = to_vector({glow[0], glow[1], glow[2]});
  return finish;
}

/// Returns the corners of a primitive's triangles, three after three, as indices of its vertices.
std::vector<std::uint32_t> corners_of(const AssetModel& model, const tinygltf::Primitive& primitive,
                                      std::size_t vertices) {
  std::vector<std::uint32_t> order;
  if (primitive.indices != -1) {
    const AccessorView indices(model.gltf, primitive.indices);
    for (std::size_t i = 0; i < indices.count(); ++i) order.push_back(indices.index(i));
  } else {
    for (std::size_t i = 0; i < vertices; ++i) order.push_back(static_cast<std::uint32_t>(i));
  }
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
    order.resize(order.size() / 3 * 3);
    return order;
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 2; i < order.size(); ++i) {
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      corners.insert(corners.end(), {order[0], order[i - 1], order[i]});
    } else if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      const std::size_t odd = i % 2;
      corners.insert(corners.end(), {order[i - 2], order[i - 1 + odd], order[i - odd]});
    }
  }
  return corners;
}

Finish box_finish() {
  Finish finish;
  finish.roughness = 0.8F;
  return finish;
}

/// Collects what the meshes of an asset consist of.
class ShapeBuilder {
 public:
  explicit ShapeBuilder(const AssetModel& model) : model_(model) {}

  void add(const tinygltf::Primitive& primitive, const Affine& map) {
    const AccessorView positions(model_.gltf, primitive.attributes.at("POSITION"));
    const auto corners = corners_of(model_, primitive, positions.count());
    const auto finish = static_cast<std::uint32_t>(shape_.finishes.size());
    shape_.finishes.push_back(finish_of(model_, primitive.material));
    const auto point = [&](std::uint32_t i) { return to_vector(map.apply(positions.point(i))); };
    const auto normals = primitive.attributes.find("NORMAL");
    const bool smooth = normals != primitive.attributes.end() && holds_vectors(normals->second);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const std::array<Vector, 3> points{point(corners[i]), point(corners[i + 1]), point(corners[i + 2])};
      const Vector flat = normalized(cross(points[1] - points[0], points[2] - points[0]));
      std::array<Vector, 3> around{flat, flat, flat};
      if (smooth) {
        const AccessorView view(model_.gltf, normals->second);
        const NormalMap turned(map);
        for (std::size_t k = 0; k < 3; ++k) around[k] = turned.apply(to_vector(view.point(corners[i + k])));
      }
      add_triangle(points, around, finish);
    }
  }

  Shape take() { return std::move(shape_); }

 private:
  bool holds_vectors(int accessor) const {
    const auto& source = model_.gltf.accessors[static_cast<std::size_t>(accessor)];
    return source.type == TINYGLTF_TYPE_VEC3 && source.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  }

  void add_triangle(const std::array<Vector, 3>& points, const std::array<Vector, 3>& normals,
                    std::uint32_t finish) {
    const auto first = static_cast<std::uint32_t>(shape_.points.size());
    shape_.points.insert(shape_.points.end(), points.begin(), points.end());
    shape_.normals.insert(shape_.normals.end(), normals.begin(), normals.end());
    shape_.triangles.push_back({{first, first + 1, first + 2}, finish});
  }

  const AssetModel& model_;
  Shape shape_;
};

/// A corner of a polygon that is being cut.
struct Corner {
  Vector point, normal;
};

Corner between(const Corner& a, const Corner& b, float share) {
  return {mixed(a.point, b.point, share), mixed(a.normal, b.normal, share)};
}

/// Cuts a polygon at a height: one step of the clipping of Sutherland and Hodgman (1974).
std::vector<Corner> below(const std::vector<Corner>& polygon, float height) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const bool from_below = from.point.y <= height, to_below = to.point.y <= height;
    if (from_below) kept.push_back(from);
    if (from_below != to_below)
      kept.push_back(between(from, to, (height - from.point.y) / (to.point.y - from.point.y)));
  }
  return kept;
}

void add_polygon(Shape& shape, const std::vector<Corner>& corners, std::uint32_t finish) {
  const auto first = static_cast<std::uint32_t>(shape.points.size());
  for (const Corner& corner : corners) {
    shape.points.push_back(corner.point);
    shape.normals.push_back(normalized(corner.normal));
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i)
    shape.triangles.push_back({{first, first + i - 1, first + i}, finish});
}

void add_box(Shape& shape, const Box3& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (const int side : {0, 1}) {
      const int at = side << axis;
      Vec3 normal{};
      normal[static_cast<std::size_t>(axis)] = side == 1 ? 1 : -1;
      std::vector<Corner> corners;
      for (const int corner : {at, at | u, at | u | v, at | v})
        corners.push_back({to_vector(box.corner(corner)), to_vector(normal)});
      if (side == 0) std::reverse(corners.begin(), corners.end());
      add_polygon(shape, corners, 0);
    }
  }
}

/// Puts a lid on a box that was cut. The map turns it about the up axis only.
void close(Shape& cut, const Box3& box, const Affine& map, double height) {
  const Box3 mapped = transformed(map, box);
  if (mapped.low[1] >= height || mapped.high[1] <= height) return;
  std::vector<Corner> lid;
  for (const int corner : {0, 4, 5, 1}) {
    Vector point = to_vector(map.apply(box.corner(corner)));
    point.y = static_cast<float>(height);
    lid.push_back({point, {0, 1, 0}});
  }
  add_polygon(cut, lid, static_cast<std::uint32_t>(cut.finishes.size()) - 1);
}

}  // namespace

Shape shape_of(const Asset& asset) {
  ShapeBuilder builder(*asset.model);
  for_each_mesh(*asset.model, asset.model->roots, Affine{},
                [&](const tinygltf::Mesh& mesh, const Affine& map) {
                  for (const auto& primitive : mesh.primitives) builder.add(primitive, map);
                });
  return builder.take();
}

Shape box_shape() { return blocks({unit_box()}, box_finish()); }

Shape body_over(const Outline& outline) {
  Shape shape = blocks({}, box_finish());
  for (const std::vector<Vec3>& face : faces_over(outline)) {
    std::vector<Corner> corners;
    for (const Vec3& point : face) corners.push_back({to_vector(point), {}});
    const Vector normal =
        normalized(cross(corners[1].point - corners[0].point, corners[2].point - corners[0].point));
    for (Corner& corner : corners) corner.normal = normal;
    add_polygon(shape, corners, 0);
  }
  return shape;
}

Shape blocks(const std::vector<Box3>& boxes, const Finish& finish) {
  Shape shape;
  shape.finishes.push_back(finish);
  shape.finishes.back().is_primary = true;
  for (const Box3& box : boxes) add_box(shape, box);
  return shape;
}

Shape cut_below(const Shape& shape, const std::vector<Box3>& boxes, const Affine& map, double height) {
  Shape cut;
  cut.finishes = shape.finishes;
  cut.finishes.push_back(kCutFinish);
  const NormalMap turned(map);
  for (const Shape::Triangle& triangle : shape.triangles) {
    std::vector<Corner> polygon;
    for (const std::uint32_t i : triangle.corners)
      polygon.push_back({to_vector(map.apply(to_vec3(shape.points[i]))), turned.apply(shape.normals[i])});
    add_polygon(cut, below(polygon, static_cast<float>(height)), triangle.finish);
  }
  for (const Box3& box : boxes) close(cut, box, map, height);
  return cut;
}

}  // namespace solitaire
