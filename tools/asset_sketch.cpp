#include "tools/asset_sketch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/gltf/mesh_copy.h"

namespace solitaire {
namespace {

tinygltf::Material to_material(const Surface& surface) {
  tinygltf::Material material;
  material.name = surface.name;
  material.pbrMetallicRoughness.metallicFactor = surface.metallic;
  material.pbrMetallicRoughness.roughnessFactor = surface.roughness;
  if (surface.glow > 0) {
    const Color light = to_linear(surface.color);
    for (const double part : light) material.emissiveFactor.push_back(rounded(part * surface.glow, 6));
  }
  return painted(std::move(material), {"", surface.color, std::nullopt});
}

Vec3 normalized(const Vec3& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vec3 ring_point(double radius, double y, int side, int sides) {
  const double angle = 2 * std::numbers::pi * side / sides;
  return {radius * std::sin(angle), y, radius * std::cos(angle)};
}

/// The outward normal of a turned surface between two rings.
Vec3 ring_normal(const std::array<double, 2>& below, const std::array<double, 2>& above, int side,
                 int sides) {
  const Vec3 out = ring_point(1, 0, side, sides);
  const double rise = above[1] - below[1], narrowing = below[0] - above[0];
  return normalized({out[0] * rise, narrowing, out[2] * rise});
}

Affine moved_to(double x, double z, const Affine& map) {
  return map * to_affine({{x, 0, z}, {0, 0, 0, 1}, {1, 1, 1}});
}

Vec3 turned_normal(const Affine& map, const Vec3& normal) {  // for rotations and translations
  const Vec3 origin = map.apply({0, 0, 0}), end = map.apply(normal);
  return normalized({end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]});
}

}  // namespace

AssetSketch& AssetSketch::of(const Surface& surface) {
  const auto known = std::find_if(parts_.begin(), parts_.end(),
                                  [&](const Part& part) { return part.surface.name == surface.name; });
  current_ = static_cast<std::size_t>(known - parts_.begin());
  if (known == parts_.end()) parts_.push_back({surface, {}});
  return *this;
}

AssetSketch& AssetSketch::keep_proportions() {
  keeps_proportions_ = true;
  return *this;
}

AssetSketch& AssetSketch::role(const std::string& role) {
  role_ = role;
  return *this;
}

AssetSketch& AssetSketch::block(const Vec3& low, const Vec3& high, const Affine& map) {
  mesh().add_box({low, high}, map);
  return *this;
}

AssetSketch& AssetSketch::soft_block(const Vec3& low, const Vec3& high, double bevel, const Affine& map) {
  const Vec3 center{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
  const Vec3 half{(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2};
  // The corner of sign s that lies on the face of axis `face`: drawn in by the bevel along the other two.
  const auto corner = [&](const std::array<int, 3>& s, int face) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = center[axis] + s[axis] * (half[axis] - (axis == face ? 0 : bevel));
    }
    return point;
  };
  const auto add = [&](std::vector<Vec3> corners, bool reverse) {
    if (reverse) std::reverse(corners.begin(), corners.end());
    mesh().face(corners, map);
  };
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const auto sign = [&](int sa, int sb, int sc) {
      std::array<int, 3> s{};
      s[a] = sa, s[b] = sb, s[c] = sc;
      return s;
    };
    for (const int s : {-1, 1}) {
      add({corner(sign(s, -1, -1), a), corner(sign(s, 1, -1), a), corner(sign(s, 1, 1), a),
           corner(sign(s, -1, 1), a)},
          s < 0);
      for (const int t : {-1, 1}) {  // the cut edge along c between the faces of a and b
        add({corner(sign(s, t, -1), a), corner(sign(s, t, -1), b), corner(sign(s, t, 1), b),
             corner(sign(s, t, 1), a)},
            s * t < 0);
      }
    }
  }
  for (int k = 0; k < 8; ++k) {
    const std::array<int, 3> s{k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1};
    add({corner(s, 0), corner(s, 1), corner(s, 2)}, s[0] * s[1] * s[2] < 0);
  }
  return *this;
}

AssetSketch& AssetSketch::post(double x, double z, double y0, double w0, double d0, double y1, double w1,
                               double d1, double dx, double dz) {
  const auto ring = [](double cx, double y, double cz, double w, double d) {
    return std::vector<Vec3>{{cx - w / 2, y, cz + d / 2},
                             {cx + w / 2, y, cz + d / 2},
                             {cx + w / 2, y, cz - d / 2},
                             {cx - w / 2, y, cz - d / 2}};
  };
  const auto below = ring(x, y0, z, w0, d0), above = ring(x + dx, y1, z + dz, w1, d1);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    mesh().face({below[i], below[next], above[next], above[i]});
  }
  mesh().face(above);
  mesh().face({below[3], below[2], below[1], below[0]});
  return *this;
}

AssetSketch& AssetSketch::turned(double x, double z, const std::vector<std::array<double, 2>>& rings,
                                 int sides, const Affine& map) {
  const Affine place = moved_to(x, z, map);
  const auto at = [&](std::size_t ring, int side) {
    return place.apply(ring_point(rings[ring][0], rings[ring][1], side, sides));
  };
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    const auto &below = rings[i], &above = rings[i + 1];
    for (int side = 0; side < sides; ++side) {
      std::vector<Vec3> corners, normals;
      const auto add = [&](std::size_t ring, int s) {
        corners.push_back(at(ring, s));
        normals.push_back(turned_normal(place, ring_normal(below, above, s, sides)));
      };
      add(i, side);
      if (below[0] > 0) add(i, side + 1);
      add(i + 1, side + 1);
      if (above[0] > 0) add(i + 1, side);
      mesh().face(corners, normals);
    }
  }
  std::vector<Vec3> bottom, top;
  for (int side = 0; side < sides; ++side) {
    bottom.push_back(at(0, sides - 1 - side));
    top.push_back(at(rings.size() - 1, side));
  }
  if (rings.front()[0] > 0) mesh().face(bottom);
  if (rings.back()[0] > 0) mesh().face(top);
  return *this;
}

AssetSketch& AssetSketch::extruded(const std::vector<std::array<double, 2>>& outline, double z0, double z1,
                                   const Affine& map) {
  std::vector<Vec3> front, back;
  for (const auto& [x, y] : outline) {
    front.push_back({x, y, z1});
    back.push_back({x, y, z0});
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    mesh().face({front[i], back[i], back[next], front[next]}, map);
  }
  mesh().face(front, map);
  mesh().face({back.rbegin(), back.rend()}, map);
  return *this;
}

AssetSketch& AssetSketch::leaf(const Vec3& root, const Vec3& middle, const Vec3& tip, double width) {
  const Vec3 along{tip[0] - root[0], 0, tip[2] - root[2]};
  const Vec3 side = normalized({along[2], 0, -along[0]});
  const Vec3 left{middle[0] + side[0] * width / 2, middle[1], middle[2] + side[2] * width / 2};
  const Vec3 right{middle[0] - side[0] * width / 2, middle[1], middle[2] - side[2] * width / 2};
  for (const auto& half : {std::vector<Vec3>{root, right, left}, std::vector<Vec3>{right, tip, left}}) {
    mesh().face(half);
    mesh().face({half.rbegin(), half.rend()});
  }
  return *this;
}

Box3 AssetSketch::box() const {
  Box3 box;
  for (const Part& part : parts_) {
    box.include(part.mesh.box().low);
    box.include(part.mesh.box().high);
  }
  return box;
}

void AssetSketch::center() {
  const Box3 all = box();
  const Vec3 by{-(all.low[0] + all.high[0]) / 2, -all.low[1], -(all.low[2] + all.high[2]) / 2};
  for (Part& part : parts_) part.mesh.move(by);
}

void AssetSketch::write(const std::filesystem::path& file) {
  center();
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "Solitaire";
  model.buffers.emplace_back();
  tinygltf::Mesh mesh;
  mesh.name = name_;
  for (const Part& part : parts_) {
    mesh.primitives.push_back(part.mesh.write(model));
    mesh.primitives.back().material = static_cast<int>(model.materials.size());
    model.materials.push_back(to_material(part.surface));
  }
  model.meshes.push_back(std::move(mesh));

  const Vec3 size = box().size();
  const auto length = [](double metres) { return tinygltf::Value(rounded(metres, 4)); };
  tinygltf::Node node;
  node.name = name_;
  node.mesh = 0;
  tinygltf::Value::Object extras = {
      {"footprint", tinygltf::Value(tinygltf::Value::Array{length(size[0]), length(size[2])})},
      {"height", length(size[1])},
      {"front", tinygltf::Value(front_)}};
  if (keeps_proportions_) extras["keeps_proportions"] = tinygltf::Value(true);
  if (!role_.empty()) extras["role"] = tinygltf::Value(role_);
  node.extras = tinygltf::Value(std::move(extras));
  model.nodes.push_back(std::move(node));
  model.scenes.emplace_back();
  model.scenes.back().nodes = {0};
  model.defaultScene = 0;

  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, stream, false, true)) throw SceneError("cannot write " + name_);
  write_file_atomically(file, std::move(stream).str());
}

}  // namespace solitaire
