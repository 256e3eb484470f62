#include "scene/gltf/check.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "scene/error.h"
#include "scene/gltf/accessor_view.h"
#include "scene/gltf/image_bytes.h"
#include "scene/gltf/node_tree.h"

namespace solitaire {
namespace {

constexpr int kDeepestNode = 200;  // far beyond any real asset; keeps recursion over nodes safe

class Checker {
 public:
  explicit Checker(const tinygltf::Model& model) : model_(model) {}

  void check() {
    for (std::size_t i = 0; i < model_.images.size(); ++i) check_image(i);
    for (std::size_t i = 0; i < model_.textures.size(); ++i) check_texture(i);
    for (std::size_t i = 0; i < model_.materials.size(); ++i) check_material(i);
    for (std::size_t i = 0; i < model_.meshes.size(); ++i) check_mesh(i);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) check_node(i);
    check_tree();
  }

 private:
  template <typename... Arguments>
  static void require(bool holds, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    if (!holds) throw SceneError(fmt::format(format, std::forward<Arguments>(arguments)...));
  }

  template <typename T>
  static bool in_range(int index, const std::vector<T>& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
  }

  // -1 stands for "none" in tinygltf.
  template <typename T>
  static bool none_or_in_range(int index, const std::vector<T>& list) {
    return index == -1 || in_range(index, list);
  }

  void check_image(std::size_t i) const {
    const auto& image = model_.images[i];
    if (image.bufferView == -1) {
      require(!image.image.empty(), "image {} ({}) cannot be read", i, image.uri);
    } else {
      require(in_range(image.bufferView, model_.bufferViews), "image {} has no buffer view", i);
      const auto& view = model_.bufferViews[static_cast<std::size_t>(image.bufferView)];
      require(in_range(view.buffer, model_.buffers), "image {} has no buffer", i);
      const std::size_t available = model_.buffers[static_cast<std::size_t>(view.buffer)].data.size();
      require(view.byteOffset <= available && view.byteLength <= available - view.byteOffset,
              "image {} reaches out of its buffer", i);
    }
  }

  void check_texture(std::size_t i) const {
    require(none_or_in_range(model_.textures[i].source, model_.images), "texture {} has no image", i);
    require(none_or_in_range(model_.textures[i].sampler, model_.samplers), "texture {} has no sampler", i);
  }

  void check_material(std::size_t i) const {
    const auto& material = model_.materials[i];
    const auto& pbr = material.pbrMetallicRoughness;
    for (const int texture :
         {pbr.baseColorTexture.index, pbr.metallicRoughnessTexture.index, material.normalTexture.index,
          material.occlusionTexture.index, material.emissiveTexture.index}) {
      require(none_or_in_range(texture, model_.textures), "material {} has no texture {}", i, texture);
    }
    require(pbr.baseColorFactor.size() == 4, "material {} has a broken baseColorFactor", i);
    for (const auto& extension : material.extensions) check_textures_within(extension.second);
  }

  /// Textures that are shown have an image of a kind that can be copied.
  void check_shown_texture(int texture) const {
    if (texture == -1) return;
    const auto& shown = model_.textures[static_cast<std::size_t>(texture)];
    require(shown.source != -1, "texture {} has no image that is PNG or JPEG", texture);
    const std::string kind = image_kind(image_bytes(model_, shown.source));
    require(kind == "PNG" || kind == "JPEG", "image {} is {}, and images have to be PNG or JPEG",
            shown.source, kind);
  }

  void check_shown_material(int index) const {
    if (index == -1) return;
    const auto& material = model_.materials[static_cast<std::size_t>(index)];
    const auto& pbr = material.pbrMetallicRoughness;
    for (const int texture :
         {pbr.baseColorTexture.index, pbr.metallicRoughnessTexture.index, material.normalTexture.index,
          material.occlusionTexture.index, material.emissiveTexture.index})
      check_shown_texture(texture);
  }

  // Material extensions name textures as {"…Texture": {"index": N}}.
  void check_textures_within(const tinygltf::Value& value) const {
    if (!value.IsObject()) return;
    for (const std::string& key : value.Keys()) {
      const tinygltf::Value& member = value.Get(key);
      if (key.ends_with("Texture") && member.Has("index")) {
        const int texture = member.Get("index").GetNumberAsInt();
        require(in_range(texture, model_.textures), "{} has no texture", key);
        check_shown_texture(texture);
      }
      check_textures_within(member);
    }
  }

  void check_mesh(std::size_t i) const {
    require(!model_.meshes[i].primitives.empty(), "mesh {} has no primitives", i);
    for (const auto& primitive : model_.meshes[i].primitives) check_primitive(i, primitive);
  }

  void check_primitive(std::size_t mesh, const tinygltf::Primitive& primitive) const {
    require(none_or_in_range(primitive.material, model_.materials), "mesh {} has no material {}", mesh,
            primitive.material);
    check_shown_material(primitive.material);
    require(primitive.mode >= TINYGLTF_MODE_POINTS && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN,
            "mesh {} has primitives of an unknown mode", mesh);
    const auto position = primitive.attributes.find("POSITION");
    require(position != primitive.attributes.end(), "mesh {} has no POSITION", mesh);
    for (const auto& [name, accessor] : primitive.attributes) check_attribute(name, accessor);
    const auto& positions = model_.accessors[static_cast<std::size_t>(position->second)];
    require(positions.type == TINYGLTF_TYPE_VEC3 && positions.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT,
            "mesh {} has a POSITION that is not of three floats", mesh);
    for (const auto& attribute : primitive.attributes) {
      require(model_.accessors[static_cast<std::size_t>(attribute.second)].count == positions.count,
              "mesh {} has attributes of different lengths", mesh);
    }
    if (primitive.indices != -1) check_indices(mesh, primitive.indices, positions.count);
  }

  void check_attribute(const std::string& name, int accessor) const {
    check_accessor(model_, accessor);
    const auto& source = model_.accessors[static_cast<std::size_t>(accessor)];
    if (source.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) return;
    const AccessorView view(model_, accessor);
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
    for (std::size_t i = 0; i < view.count(); ++i) {
      for (int k = 0; k < components; ++k) {
        require(std::isfinite(view.real(i, k)), "{} has a number that is not finite", name);
      }
    }
  }

  void check_indices(std::size_t mesh, int accessor, std::size_t vertices) const {
    check_accessor(model_, accessor);
    const auto& source = model_.accessors[static_cast<std::size_t>(accessor)];
    const bool is_unsigned = source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                             source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                             source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    require(source.type == TINYGLTF_TYPE_SCALAR && is_unsigned, "mesh {} has indices of a wrong type", mesh);
    const AccessorView view(model_, accessor);
    for (std::size_t i = 0; i < view.count(); ++i) {
      require(view.index(i) < vertices, "mesh {} has an index without a vertex", mesh);
    }
  }

  void check_node(std::size_t i) const {
    const auto& node = model_.nodes[i];
    require(none_or_in_range(node.mesh, model_.meshes), "node {} has no mesh {}", i, node.mesh);
    const auto check_numbers = [&](const std::vector<double>& numbers, std::size_t wanted) {
      const bool finite =
          std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
      require(finite && (numbers.empty() || numbers.size() == wanted), "node {} has a broken transform", i);
    };
    check_numbers(node.translation, 3);
    check_numbers(node.rotation, 4);
    check_numbers(node.scale, 3);
    check_numbers(node.matrix, 16);
  }

  void check_tree() {
    seen_.assign(model_.nodes.size(), false);
    require(model_.defaultScene == -1 || in_range(model_.defaultScene, model_.scenes),
            "its scene {} does not exist", model_.defaultScene);
    for (const auto& scene : model_.scenes) {
      for (const int root : scene.nodes) {
        require(in_range(root, model_.nodes), "a scene has no node {}", root);
      }
    }
    for (const auto& node : model_.nodes) {
      for (const int child : node.children) {
        require(in_range(child, model_.nodes), "a node has no child {}", child);
      }
    }
    for (const int root : root_nodes(model_)) visit(root, 0);
  }

  void visit(int index, int depth) {
    const auto i = static_cast<std::size_t>(index);
    require(!seen_[i], "node {} stands in the tree twice", index);
    require(depth < kDeepestNode, "its nodes are nested more than {} deep", kDeepestNode);
    seen_[i] = true;
    for (const int child : model_.nodes[i].children) visit(child, depth + 1);
  }

  const tinygltf::Model& model_;
  std::vector<bool> seen_;
};

}  // namespace

void check_model(const tinygltf::Model& model) { Checker(model).check(); }

}  // namespace solitaire
