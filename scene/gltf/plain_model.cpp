#include "scene/gltf/plain_model.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/error.h"
#include "scene/gltf/accessor_view.h"
#include "scene/gltf/extension_names.h"

namespace solitaire {
namespace {

constexpr std::size_t kLargestAccessor = std::size_t{1} << 30;  // bytes
constexpr std::size_t kMostInstances = 100'000;

bool exists(const tinygltf::Model& model, int accessor) {
  return accessor >= 0 && static_cast<std::size_t>(accessor) < model.accessors.size();
}

tinygltf::Accessor& at(tinygltf::Model& model, int accessor) {
  return model.accessors[static_cast<std::size_t>(accessor)];
}

bool is_unsigned(int component_type) {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

template <typename T>
double real(const unsigned char* bytes, bool normalized) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  const auto number = static_cast<double>(value);
  return normalized ? std::max(number / std::numeric_limits<T>::max(), -1.0) : number;
}

/// Returns the number that a component means, by the table of the specification.
double component(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return real<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return real<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return real<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return real<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return real<std::uint32_t>(bytes, false);
    default:
      return real<float>(bytes, false);
  }
}

/// Rewrites accessors of one model.
class Accessors {
 public:
  explicit Accessors(tinygltf::Model& model) : model_(model) {}

  /// Makes an accessor of a mesh one that is not sparse, and of floats where `floats`.
  void plain(int accessor, bool floats) {
    if (!exists(model_, accessor) || !done_.insert(accessor).second) return;
    tinygltf::Accessor& source = at(model_, accessor);
    const bool convert = floats && source.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT;
    if (!source.sparse.isSparse && !convert) return;
    std::vector<unsigned char> bytes = elements(accessor);
    if (convert) bytes = as_floats(accessor, bytes);
    store(at(model_, accessor), std::move(bytes), convert);
  }

  /// Returns the numbers of an accessor, one element after the other.
  std::vector<double> numbers(int accessor) {
    std::vector<double> made;
    const std::vector<unsigned char> bytes = elements(accessor);
    const tinygltf::Accessor& source = at(model_, accessor);
    const std::size_t size = component_bytes(source);
    for (std::size_t i = 0; i + size <= bytes.size(); i += size)
      made.push_back(component(bytes.data() + i, source.componentType, source.normalized));
    return made;
  }

 private:
  static std::size_t component_bytes(const tinygltf::Accessor& accessor) {
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    return static_cast<std::size_t>(std::max(size, 0));
  }

  static std::size_t element_bytes(const tinygltf::Accessor& accessor) {
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    return component_bytes(accessor) * static_cast<std::size_t>(std::max(components, 0));
  }

  /// The elements without gaps, the sparse ones in their places.
  std::vector<unsigned char> elements(int accessor) {
    const tinygltf::Accessor source = at(model_, accessor);
    const std::size_t size = element_bytes(source);
    if (size == 0 || source.count == 0 || source.count > kLargestAccessor / size)
      throw SceneError(fmt::format("accessor {} is empty, too large or of an unknown type", accessor));
    std::vector<unsigned char> bytes(source.count * size);
    if (source.bufferView != -1) {
      tinygltf::Accessor base = source;
      base.sparse.isSparse = false;
      copy_elements(base, accessor, bytes);
    } else if (!source.sparse.isSparse) {
      throw SceneError(fmt::format("accessor {} has no buffer view", accessor));
    }
    if (source.sparse.isSparse) replace_sparse(source, accessor, bytes);
    return bytes;
  }

  void copy_elements(const tinygltf::Accessor& source, int number, std::vector<unsigned char>& bytes) {
    with_view(source, number, [&](const AccessorView& view) {
      for (std::size_t i = 0; i < view.count(); ++i)
        std::memcpy(bytes.data() + i * view.element_bytes(), view.element(i), view.element_bytes());
    });
  }

  void replace_sparse(const tinygltf::Accessor& source, int number, std::vector<unsigned char>& bytes) {
    const auto& sparse = source.sparse;
    tinygltf::Accessor indices, values;
    indices.bufferView = sparse.indices.bufferView;
    indices.byteOffset = static_cast<std::size_t>(std::max(sparse.indices.byteOffset, 0));
    indices.componentType = sparse.indices.componentType;
    indices.type = TINYGLTF_TYPE_SCALAR;
    values = source;
    values.sparse.isSparse = false;
    values.bufferView = sparse.values.bufferView;
    values.byteOffset = static_cast<std::size_t>(std::max(sparse.values.byteOffset, 0));
    indices.count = values.count = static_cast<std::size_t>(std::max(sparse.count, 0));
    if (!is_unsigned(indices.componentType))
      throw SceneError(fmt::format("accessor {} has sparse indices of a wrong type", number));
    std::vector<std::uint32_t> places;
    with_view(indices, number, [&](const AccessorView& view) {
      for (std::size_t i = 0; i < view.count(); ++i) places.push_back(view.index(i));
    });
    if (std::ranges::any_of(places, [&](std::uint32_t place) { return place >= source.count; }))
      throw SceneError(fmt::format("accessor {} replaces an element that it does not have", number));
    with_view(values, number, [&](const AccessorView& view) {
      for (std::size_t i = 0; i < view.count(); ++i)
        std::memcpy(bytes.data() + places[i] * view.element_bytes(), view.element(i), view.element_bytes());
    });
  }

  /// Calls visit with a view of an accessor that need not be in the model, once it is known to be whole.
  template <typename Visit>
  void with_view(const tinygltf::Accessor& accessor, int number, const Visit& visit) {
    const tinygltf::Accessor own = std::exchange(at(model_, number), accessor);
    try {
      check_accessor(model_, number);
      visit(AccessorView(model_, number));
    } catch (...) {
      at(model_, number) = own;
      throw;
    }
    at(model_, number) = own;
  }

  std::vector<unsigned char> as_floats(int accessor, const std::vector<unsigned char>& bytes) {
    const tinygltf::Accessor& source = at(model_, accessor);
    const std::size_t size = component_bytes(source);
    std::vector<unsigned char> made(bytes.size() / size * sizeof(float));
    for (std::size_t i = 0; i * size < bytes.size(); ++i) {
      const auto number =
          static_cast<float>(component(bytes.data() + i * size, source.componentType, source.normalized));
      std::memcpy(made.data() + i * sizeof number, &number, sizeof number);
    }
    return made;
  }

  void store(tinygltf::Accessor& accessor, std::vector<unsigned char> bytes, bool floats) {
    tinygltf::BufferView view;
    view.buffer = static_cast<int>(model_.buffers.size());
    view.byteLength = bytes.size();
    model_.buffers.emplace_back().data = std::move(bytes);
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    model_.bufferViews.push_back(std::move(view));
    accessor.byteOffset = 0;
    accessor.sparse.isSparse = false;
    if (!floats) return;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.normalized = false;
  }

  tinygltf::Model& model_;
  std::set<int> done_;
};

/// Attributes that can be quantized. Texture coordinates of unsigned shares are plain glTF.
bool becomes_floats(std::string_view attribute, const tinygltf::Accessor& accessor) {
  const int type = accessor.componentType;
  const bool is_signed = type == TINYGLTF_COMPONENT_TYPE_BYTE || type == TINYGLTF_COMPONENT_TYPE_SHORT;
  const bool is_unsigned_one =
      type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  if (!is_signed && !is_unsigned_one) return false;
  if (attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT") return true;
  return attribute.starts_with("TEXCOORD_") && !(is_unsigned_one && accessor.normalized);
}

void make_meshes_plain(tinygltf::Model& model, Accessors& accessors) {
  for (const auto& mesh : model.meshes) {
    for (const auto& primitive : mesh.primitives) {
      for (const auto& [name, accessor] : primitive.attributes)
        accessors.plain(accessor, exists(model, accessor) && becomes_floats(name, at(model, accessor)));
      accessors.plain(primitive.indices, false);
    }
  }
}

// ---- instances

/// One number list of a node's instances, by its name; empty if there is none.
std::vector<double> instance_numbers(const tinygltf::Model& model, Accessors& accessors,
                                     const tinygltf::Value& attributes, const char* name, int type) {
  if (!attributes.Has(name)) return {};
  const int accessor = attributes.Get(name).GetNumberAsInt();
  if (!exists(model, accessor) || model.accessors[static_cast<std::size_t>(accessor)].type != type)
    throw SceneError(fmt::format("the {} of its instances is missing or of another type", name));
  return accessors.numbers(accessor);
}

std::vector<double> part(const std::vector<double>& numbers, std::size_t i, std::size_t width) {
  if (numbers.empty()) return {};
  const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(i * width);
  return {begin, begin + static_cast<std::ptrdiff_t>(width)};
}

/// Returns nodes that stand below the instanced one, in its frame.
std::vector<tinygltf::Node> instances_of(const tinygltf::Model& model, Accessors& accessors,
                                         const tinygltf::Node& node) {
  const tinygltf::Value& extension = node.extensions.at(kInstancing);
  if (!extension.Has("attributes")) throw SceneError("its instances have no attributes");
  const tinygltf::Value& attributes = extension.Get("attributes");
  const auto moved = instance_numbers(model, accessors, attributes, "TRANSLATION", TINYGLTF_TYPE_VEC3);
  const auto turned = instance_numbers(model, accessors, attributes, "ROTATION", TINYGLTF_TYPE_VEC4);
  const auto scaled = instance_numbers(model, accessors, attributes, "SCALE", TINYGLTF_TYPE_VEC3);
  const std::size_t count = std::max({moved.size() / 3, turned.size() / 4, scaled.size() / 3});
  const auto fits = [count](std::size_t size, std::size_t width) {
    return size == 0 || size == count * width;
  };
  if (!fits(moved.size(), 3) || !fits(turned.size(), 4) || !fits(scaled.size(), 3))
    throw SceneError("the attributes of its instances have different lengths");
  if (count > kMostInstances) throw SceneError(fmt::format("it has more than {} instances", kMostInstances));
  std::vector<tinygltf::Node> nodes(count);
  for (std::size_t i = 0; i < count; ++i) {
    nodes[i].name = node.name;
    nodes[i].mesh = node.mesh;
    nodes[i].translation = part(moved, i, 3);
    nodes[i].rotation = part(turned, i, 4);
    nodes[i].scale = part(scaled, i, 3);
  }
  return nodes;
}

void make_instances_plain(tinygltf::Model& model, Accessors& accessors) {
  const std::size_t nodes = model.nodes.size();
  for (std::size_t i = 0; i < nodes; ++i) {
    if (model.nodes[i].mesh == -1 || !model.nodes[i].extensions.contains(kInstancing)) continue;
    for (tinygltf::Node& instance : instances_of(model, accessors, model.nodes[i])) {
      model.nodes[i].children.push_back(static_cast<int>(model.nodes.size()));
      model.nodes.push_back(std::move(instance));
    }
    model.nodes[i].mesh = -1;
    model.nodes[i].extensions.erase(kInstancing);
  }
}

}  // namespace

void make_plain(tinygltf::Model& model) {
  Accessors accessors(model);
  make_meshes_plain(model, accessors);
  make_instances_plain(model, accessors);
}

}  // namespace solitaire
