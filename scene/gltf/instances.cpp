#include "scene/gltf/instances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "scene/error.h"
#include "scene/gltf/accessor_view.h"
#include "scene/gltf/asset_model.h"
#include "scene/gltf/extension_names.h"
#include "scene/gltf/extras.h"
#include "scene/gltf/mesh_copy.h"

namespace solitaire {
namespace {

/// What objects have in common that share a mesh.
using Look = std::pair<const Asset*, std::string>;

/// The number of a square of kChunk metres along each axis.
using Square = std::array<double, 2>;

Square square_of(const SceneObject& object) {
  return {std::floor(object.box.center[0] / kChunk), std::floor(object.box.center[1] / kChunk)};
}

bool has_shared_mesh(const SceneObject& object) {
  return !has_own_mesh(object) && (object.asset == nullptr || object.asset->model->is_single_mesh());
}

template <std::size_t N>
void append(std::vector<float>& numbers, const std::array<double, N>& values) {
  for (const double value : values) numbers.push_back(static_cast<float>(value));
}

int add_accessor(tinygltf::Model& model, const std::vector<float>& numbers, int type, std::size_t parts) {
  std::vector<unsigned char> bytes(numbers.size() * sizeof(float));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  tinygltf::Accessor accessor;
  accessor.bufferView = append_view(model, bytes, 0);
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  accessor.type = type;
  accessor.count = numbers.size() / parts;
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

void use_instancing(tinygltf::Model& model) {
  for (auto* names : {&model.extensionsUsed, &model.extensionsRequired}) {
    if (std::find(names->begin(), names->end(), kInstancing) == names->end())
      names->emplace_back(kInstancing);
  }
}

std::optional<AccessorView> attribute(const tinygltf::Model& model, const tinygltf::Node& node,
                                      const char* name) {
  const auto extension = node.extensions.find(kInstancing);
  if (extension == node.extensions.end()) throw SceneError("a node has no instances");
  const tinygltf::Value& attributes = extension->second.Get("attributes");
  if (!attributes.Has(name)) return std::nullopt;
  const int accessor = attributes.Get(name).GetNumberAsInt();
  check_accessor(model, accessor);
  return AccessorView(model, accessor);
}

/// Returns true if all transforms are the same in what `part` gives, which a file then need not say.
template <std::size_t N>
bool all_are(const std::vector<float>& numbers, const std::array<double, N>& value) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != static_cast<float>(value.at(i % N))) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<std::size_t>> parts_of(const Scene& scene, const SceneNode& node, Nodes nodes) {
  std::vector<std::vector<std::size_t>> parts;
  std::map<std::pair<Look, Square>, std::size_t> known;  // looked up only: its order never shows
  for (const std::size_t child : node.children) {
    const auto index = scene.nodes[child].object;
    if (nodes == Nodes::kOneEach || !index || !has_shared_mesh(scene.objects[*index])) {
      parts.push_back({child});
      continue;
    }
    const SceneObject& object = scene.objects[*index];
    const auto [part, is_new] = known.try_emplace({{object.asset, object.paint ? object.paint->text() : ""},
                                                   nodes == Nodes::kChunks ? square_of(object) : Square{}},
                                                  parts.size());
    if (is_new) parts.emplace_back();
    parts[part->second].push_back(child);
  }
  return parts;
}

void make_instances(tinygltf::Model& model, tinygltf::Node& node, const Scene& scene,
                    const std::vector<std::size_t>& instances, Nodes nodes) {
  std::vector<float> translations, rotations, scales;
  std::string facts = "[";
  for (const std::size_t index : instances) {
    const SceneObject& object = scene.objects[*scene.nodes[index].object];
    append(translations, object.node_transform.translation);
    append(rotations, object.node_transform.rotation);
    append(scales, object.node_transform.scale);
    if (nodes == Nodes::kPlainInstances) continue;
    if (facts.size() > 1) facts += ',';
    facts += facts_text(object.thing, scene.nodes[index].name);
  }
  const auto attribute = [](int accessor) { return tinygltf::Value(accessor); };
  tinygltf::Value::Object attributes{
      {"TRANSLATION", attribute(add_accessor(model, translations, TINYGLTF_TYPE_VEC3, 3))}};
  const Transform none;
  if (!all_are(rotations, none.rotation))
    attributes.emplace("ROTATION", attribute(add_accessor(model, rotations, TINYGLTF_TYPE_VEC4, 4)));
  if (!all_are(scales, none.scale))
    attributes.emplace("SCALE", attribute(add_accessor(model, scales, TINYGLTF_TYPE_VEC3, 3)));
  node.extensions[kInstancing] =
      tinygltf::Value(tinygltf::Value::Object{{"attributes", tinygltf::Value(std::move(attributes))}});
  node.extras = {};
  if (nodes != Nodes::kPlainInstances) {
    node.extras =
        tinygltf::Value(tinygltf::Value::Object{{"instances", tinygltf::Value(std::move(facts) + "]")}});
  }
  use_instancing(model);
}

std::vector<Transform> instance_transforms(const tinygltf::Model& model, const tinygltf::Node& node) {
  const auto translations = attribute(model, node, "TRANSLATION"),
             rotations = attribute(model, node, "ROTATION"), scales = attribute(model, node, "SCALE");
  if (!translations) throw SceneError("instances have no places");
  std::vector<Transform> transforms(translations->count());
  for (const auto* other : {&rotations, &scales}) {
    if (*other && (*other)->count() != transforms.size())
      throw SceneError("the attributes of instances differ in number");
  }
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    transforms[i].translation = translations->point(i);
    if (scales) transforms[i].scale = scales->point(i);
    for (int part = 0; part < 4 && rotations; ++part)
      transforms[i].rotation[static_cast<std::size_t>(part)] = rotations->real(i, part);
  }
  return transforms;
}

}  // namespace solitaire
