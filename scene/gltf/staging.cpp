#include "scene/gltf/staging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "scene/camera.h"
#include "scene/gltf/mesh_builder.h"
#include "scene/sun.h"

namespace solitaire {
namespace {

constexpr double kAspect = 4.0 / 3;
/// Most viewers take the number as it is, and not as the lux of its definition.
constexpr double kSunIntensity = 3;

/// Returns the rotation that takes the axes x, y, z to these, which are of length 1 and at right angles
/// (Shepperd, 1978).
std::vector<double> rotation_to(const Vec3& right, const Vec3& up, const Vec3& back) {
  const double trace = right[0] + up[1] + back[2];
  const std::array<double, 4> squares{1 + 2 * right[0] - trace, 1 + 2 * up[1] - trace,
                                      1 + 2 * back[2] - trace, 1 + trace};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const double x = up[2] - back[1], y = back[0] - right[2], z = right[1] - up[0];
  const double xy = right[1] + up[0], yz = up[2] + back[1], zx = back[0] + right[2];
  const double root = std::sqrt(squares[static_cast<std::size_t>(largest)]);
  std::array<double, 4> q{};
  if (largest == 0) q = {root, xy / root, zx / root, x / root};
  if (largest == 1) q = {xy / root, root, yz / root, y / root};
  if (largest == 2) q = {zx / root, yz / root, root, z / root};
  if (largest == 3) q = {x / root, y / root, z / root, root};
  std::vector<double> rotation;
  for (const double part : q) rotation.push_back(rounded(part / 2, 9));
  return rotation;
}

tinygltf::Node camera_node(tinygltf::Model& model, const Scene& scene) {
  const Camera camera = default_camera(scene, kAspect);
  tinygltf::Camera lens;
  lens.type = "perspective";
  lens.perspective.aspectRatio = rounded(camera.aspect, 6);
  lens.perspective.yfov = rounded(2 * std::atan(camera.half_height), 6);
  lens.perspective.znear = std::max(rounded(camera.nearest / 2, 6), 1e-6);
  lens.perspective.zfar = rounded(10 * camera.farthest, 6);
  model.cameras.push_back(std::move(lens));
  tinygltf::Node node;
  node.camera = 0;
  for (const double part : camera.position) node.translation.push_back(rounded(part, 6));
  const Vec3& ahead = camera.forward;
  node.rotation = rotation_to(camera.right, camera.up, {-ahead[0], -ahead[1], -ahead[2]});
  return node;
}

tinygltf::Node sun_node(tinygltf::Model& model) {
  tinygltf::Light light;
  light.type = "directional";
  light.color = {1, 0.95, 0.87};
  light.intensity = kSunIntensity;
  model.lights.push_back(std::move(light));
  tinygltf::Node node;
  const Vec3 back = to_sun();
  const double across = std::hypot(back[0], back[2]);
  const Vec3 right{back[2] / across, 0, -back[0] / across};
  node.rotation =
      rotation_to(right, {-back[1] * back[0] / across, across, -back[1] * back[2] / across}, back);
  node.extensions["KHR_lights_punctual"] =
      tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(0)}});
  return node;
}

/// Returns a plain ground, a little below what stands lowest, that reaches past the scene by half its width.
tinygltf::Node ground_node(tinygltf::Model& model, const Scene& scene) {
  const Box3 all = bounds(scene);
  const Vec3 size = all.size();
  const double margin = std::max(size[0], size[1]) / 2;
  const double height = all.low[2] - 2e-4 * std::hypot(size[0], size[1], size[2]);
  const double left = all.low[0] - margin, right = all.high[0] + margin, front = margin - all.low[1],
               back = -all.high[1] - margin;
  MeshBuilder builder;
  builder.face({{left, height, front}, {right, height, front}, {right, height, back}, {left, height, back}});
  tinygltf::Material material;
  material.name = "ground";
  material.pbrMetallicRoughness.baseColorFactor = {0.62, 0.61, 0.58, 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  tinygltf::Mesh mesh;
  mesh.name = "ground";
  mesh.primitives.push_back(builder.write(model));
  mesh.primitives.back().material = static_cast<int>(model.materials.size());
  model.materials.push_back(std::move(material));
  tinygltf::Node node;
  node.mesh = static_cast<int>(model.meshes.size());
  node.extras = tinygltf::Value(tinygltf::Value::Object{{"role", tinygltf::Value(std::string("ground"))}});
  model.meshes.push_back(std::move(mesh));
  return node;
}

void stand(tinygltf::Model& model, tinygltf::Scene& shown, tinygltf::Node node, const std::string& name) {
  node.name = name;
  shown.nodes.push_back(static_cast<int>(model.nodes.size()));
  model.nodes.push_back(std::move(node));
}

}  // namespace

void add_stage(tinygltf::Model& model, tinygltf::Scene& shown, const Scene& scene, UniqueNames& names) {
  stand(model, shown, camera_node(model, scene), names.take("camera"));
  stand(model, shown, sun_node(model), names.take("sun"));
  if (!scene.objects.empty()) stand(model, shown, ground_node(model, scene), names.take("ground"));
  model.cameras.back().name = "camera";
  model.lights.back().name = "sun";
}

}  // namespace solitaire
