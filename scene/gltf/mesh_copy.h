#pragma once
#include <map>
#include <optional>
#include <string>
#include <tiny_gltf.h>
#include <utility>
#include <vector>

#include "scene/gltf/asset_model.h"
#include "scene/paint.h"

namespace solitaire {

/// Appends bytes to the output's only buffer, aligned to 4 bytes, and returns the new buffer view.
int append_view(tinygltf::Model& to, const std::vector<unsigned char>& bytes, int target,
                std::size_t stride = 0);

/// Returns the material with the paint's colour, and with its finish if it has one.
tinygltf::Material painted(tinygltf::Material material, const Paint& paint);

/// Copies meshes of one asset, with the geometry, materials and images that they use, into an output file.
/// Each is copied once, and meshes that differ only in paint share their geometry. Skins and morph targets
/// are not copied.
class MeshCopier {
 public:
  MeshCopier(const AssetModel& from, std::string asset_name, tinygltf::Model& to)
      : source_(from), from_(from.gltf), asset_name_(std::move(asset_name)), to_(to) {}

  /// Returns the output's mesh for the asset's mesh. Its primary material is painted if there is a paint.
  int mesh(int index, const std::optional<Paint>& paint);

  /// Returns the output's material for the asset's primary one, painted if there is a paint.
  int primary_material(const std::optional<Paint>& paint) {
    return material(source_.primary_material, paint);
  }

 private:
  using Variant = std::pair<int, std::string>;  // an index in the asset, a paint's text or ""

  tinygltf::Primitive primitive(const tinygltf::Primitive& source, const std::optional<Paint>& paint);
  int attribute(const std::string& name, int accessor);
  int indices(int accessor);
  int add_accessor(int accessor, int target, std::size_t alignment);
  int material(int index, const std::optional<Paint>& paint);
  tinygltf::Material copied_material(int index);
  tinygltf::Value remapped(const tinygltf::Value& extension);
  int texture(int index);
  int sampler(int index);
  int image(int index);
  void use_extensions(const tinygltf::ExtensionMap& extensions);

  const AssetModel& source_;
  const tinygltf::Model& from_;
  std::string asset_name_;
  tinygltf::Model& to_;
  std::map<Variant, int> meshes_;
  std::map<Variant, int> materials_;
  std::map<int, int> attributes_;
  std::map<int, int> indices_;
  std::map<int, int> textures_;
  std::map<int, int> samplers_;
  std::map<int, int> images_;
};

}  // namespace solitaire
