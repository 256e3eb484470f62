#include "scene/gltf/mesh_copy.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "scene/gltf/accessor_view.h"
#include "scene/gltf/image_bytes.h"
#include "scene/names.h"

namespace solitaire {
namespace {

template <typename T>
const T& at(const std::vector<T>& list, int index) {
  return list[static_cast<std::size_t>(index)];
}

template <typename T>
int append(std::vector<T>& list, T element) {
  list.push_back(std::move(element));
  return static_cast<int>(list.size()) - 1;
}

std::size_t round_up(std::size_t value, std::size_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

bool is_copied(std::string_view attribute) {
  return !attribute.starts_with("JOINTS_") && !attribute.starts_with("WEIGHTS_");
}

std::string variant_of(const std::optional<Paint>& paint) { return paint ? paint->text() : ""; }

std::string variant_name(const std::string& base, const std::string& variant) {
  return harmless_name(variant.empty() ? base : base + " " + variant);
}

void set_bounds(tinygltf::Accessor& accessor, const AccessorView& view) {
  Box3 box;
  for (std::size_t i = 0; i < view.count(); ++i) box.include(view.point(i));
  accessor.minValues.assign(box.low.begin(), box.low.end());
  accessor.maxValues.assign(box.high.begin(), box.high.end());
}

}  // namespace

int append_view(tinygltf::Model& to, const std::vector<unsigned char>& bytes, int target,
                std::size_t stride) {
  auto& data = to.buffers.front().data;
  data.resize(round_up(data.size(), 4));
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = bytes.size();
  view.byteStride = stride;
  view.target = target;
  data.insert(data.end(), bytes.begin(), bytes.end());
  return append(to.bufferViews, std::move(view));
}

tinygltf::Material painted(tinygltf::Material material, const Paint& paint) {
  const Color paint_color = to_linear(paint.color);
  auto& pbr = material.pbrMetallicRoughness;
  for (std::size_t i = 0; i < 3; ++i)  // alpha stays
    pbr.baseColorFactor[i] = paint.tints ? pbr.baseColorFactor[i] * paint_color[i] : paint_color[i];
  if (paint.covers) pbr.baseColorTexture.index = -1;
  if (paint.finish) {
    pbr.roughnessFactor = paint.finish->roughness;
    pbr.metallicFactor = paint.finish->metallic;
    pbr.baseColorFactor[3] = paint.finish->opacity;
    material.alphaMode = paint.finish->opacity < 1 ? "BLEND" : "OPAQUE";
  }
  return material;
}

int MeshCopier::mesh(int index, const std::optional<Paint>& paint) {
  const auto [place, is_new] = meshes_.try_emplace({index, variant_of(paint)}, 0);
  if (!is_new) return place->second;
  const auto& source = at(from_.meshes, index);
  tinygltf::Mesh copy;
  const std::string base = from_.meshes.size() == 1 || source.name.empty() ? asset_name_ : source.name;
  copy.name = variant_name(base, variant_of(paint));
  for (const auto& each : source.primitives) copy.primitives.push_back(primitive(each, paint));
  return place->second = append(to_.meshes, std::move(copy));
}

tinygltf::Primitive MeshCopier::primitive(const tinygltf::Primitive& source,
                                          const std::optional<Paint>& paint) {
  tinygltf::Primitive copy;
  copy.mode = source.mode;
  for (const auto& [name, accessor] : source.attributes) {
    if (is_copied(name)) copy.attributes[name] = attribute(name, accessor);
  }
  if (source.indices != -1) copy.indices = indices(source.indices);
  const bool is_primary = source.material == source_.primary_material;
  const bool is_painted = is_primary || (paint && paint->is_everywhere());
  copy.material = material(source.material, is_painted ? paint : std::nullopt);
  return copy;
}

int MeshCopier::attribute(const std::string& name, int accessor) {
  const auto [place, is_new] = attributes_.try_emplace(accessor, 0);
  if (!is_new) return place->second;
  place->second = add_accessor(accessor, TINYGLTF_TARGET_ARRAY_BUFFER, 4);
  if (name == "POSITION") {
    set_bounds(to_.accessors[static_cast<std::size_t>(place->second)], AccessorView(from_, accessor));
  }
  return place->second;
}

int MeshCopier::indices(int accessor) {
  const auto [place, is_new] = indices_.try_emplace(accessor, 0);
  if (is_new) place->second = add_accessor(accessor, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 1);
  return place->second;
}

// Vertex attributes must start at multiples of 4 bytes, each vertex; indices are packed.
int MeshCopier::add_accessor(int accessor, int target, std::size_t alignment) {
  const auto& source = at(from_.accessors, accessor);
  const AccessorView view(from_, accessor);
  const std::size_t stride = round_up(view.element_bytes(), alignment);
  std::vector<unsigned char> bytes(view.count() * stride);
  for (std::size_t i = 0; i < view.count(); ++i) {
    std::copy_n(view.element(i), view.element_bytes(),
                bytes.begin() + static_cast<std::ptrdiff_t>(i * stride));
  }
  tinygltf::Accessor copy;
  copy.bufferView = append_view(to_, bytes, target, stride == view.element_bytes() ? 0 : stride);
  copy.componentType = source.componentType;
  copy.type = source.type;
  copy.count = source.count;
  copy.normalized = source.normalized;
  return append(to_.accessors, std::move(copy));
}

int MeshCopier::material(int index, const std::optional<Paint>& paint) {
  if (index == -1 && !paint) return -1;
  const auto [place, is_new] = materials_.try_emplace({index, variant_of(paint)}, 0);
  if (!is_new) return place->second;
  tinygltf::Material copy = index == -1 ? tinygltf::Material() : copied_material(index);
  copy.name = variant_name(copy.name.empty() ? asset_name_ : copy.name, variant_of(paint));
  if (paint) copy = painted(std::move(copy), *paint);
  return place->second = append(to_.materials, std::move(copy));
}

tinygltf::Material MeshCopier::copied_material(int index) {
  tinygltf::Material copy = at(from_.materials, index);
  auto& pbr = copy.pbrMetallicRoughness;
  const auto bring = [&](auto& info) {
    if (info.index != -1) info.index = texture(info.index);
    use_extensions(info.extensions);
  };
  bring(pbr.baseColorTexture);
  bring(pbr.metallicRoughnessTexture);
  bring(copy.normalTexture);
  bring(copy.occlusionTexture);
  bring(copy.emissiveTexture);
  use_extensions(copy.extensions);
  for (auto& extension : copy.extensions) extension.second = remapped(extension.second);
  return copy;
}

// Textures within material extensions: {"…Texture": {"index": N}}, as check_model found them.
tinygltf::Value MeshCopier::remapped(const tinygltf::Value& extension) {
  if (!extension.IsObject()) return extension;
  tinygltf::Value::Object copy;
  for (const std::string& key : extension.Keys()) {
    tinygltf::Value member = remapped(extension.Get(key));
    if (key.ends_with("Texture") && member.Has("index")) {
      const int index = texture(member.Get("index").GetNumberAsInt());
      member.Get<tinygltf::Value::Object>()["index"] = tinygltf::Value(index);
    }
    copy.emplace(key, std::move(member));
  }
  return tinygltf::Value(std::move(copy));
}

int MeshCopier::texture(int index) {
  const auto [place, is_new] = textures_.try_emplace(index, 0);
  if (!is_new) return place->second;
  const auto& source = at(from_.textures, index);
  tinygltf::Texture copy;
  copy.name = source.name;
  copy.source = image(source.source);
  if (source.sampler != -1) copy.sampler = sampler(source.sampler);
  return place->second = append(to_.textures, std::move(copy));
}

int MeshCopier::sampler(int index) {
  const auto [place, is_new] = samplers_.try_emplace(index, 0);
  if (is_new) place->second = append(to_.samplers, at(from_.samplers, index));
  return place->second;
}

int MeshCopier::image(int index) {
  const auto [place, is_new] = images_.try_emplace(index, 0);
  if (!is_new) return place->second;
  const auto& source = at(from_.images, index);
  const std::span<const unsigned char> bytes = image_bytes(from_, index);
  tinygltf::Image copy;
  copy.name = source.name;
  copy.mimeType = image_kind(bytes) == "PNG" ? "image/png" : "image/jpeg";
  copy.bufferView = append_view(to_, {bytes.begin(), bytes.end()}, 0);
  return place->second = append(to_.images, std::move(copy));
}

void MeshCopier::use_extensions(const tinygltf::ExtensionMap& extensions) {
  for (const auto& extension : extensions) {
    auto& used = to_.extensionsUsed;
    if (std::find(used.begin(), used.end(), extension.first) == used.end()) used.push_back(extension.first);
  }
}

}  // namespace solitaire
