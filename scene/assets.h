#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/color.h"
#include "scene/geometry.h"

namespace solitaire {

struct AssetModel;  // scene/gltf/asset_model.h; keeps glTF out of this header

/// A 3D model that placed things share.
struct Asset {
  /// Openings are doors and windows, for which walls are opened.
  enum class Role : std::uint8_t { kThing, kWall, kOpening };

  std::string name;     // "chair"
  std::string set;      // "living", or ""
  Box3 box;             // of all its vertices; glTF axes, metres
  int front_turns = 0;  // quarter turns about +Y that bring its front to +Z
  bool has_front = true;
  bool keeps_proportions = false;  // as a tree does, and a table does not
  Role role = Role::kThing;
  Color color{};         // of its primary material
  std::string left_out;  // what its file has and it does not show: "its lights"; or ""
  std::shared_ptr<const AssetModel> model;
};

/// Returns the size of an asset seen from its front: width, depth, height.
Vec3 natural_size(const Asset& asset);

/// Finds and loads assets, each file once. Only one thread at a time may use it.
class AssetLibrary {
 public:
  /// `bundled` holds NAME.glb files, and so do the folders in `own`, which are looked into before it; paths
  /// that programs write are relative to `script_folder`.
  AssetLibrary(std::filesystem::path bundled, std::filesystem::path script_folder,
               std::vector<std::filesystem::path> own = {});

  /// Returns the names of all assets in these folders, sorted.
  std::vector<std::string> names() const;

  /// Returns an asset of these folders by its name, or the user's own by a path that ends in .glb or .gltf,
  /// which is looked for in `folder`, relative to the script's, and then beside the script. Returns nullptr
  /// if no asset has this name; a scene shows a box then. Throws SceneError for a file that is missing,
  /// broken or not supported. The asset lives as long as the library.
  const Asset* find(const std::string& name, const std::string& folder = "");

  /// Returns an asset that no file has: the one that `make` returned when it was first asked for by this
  /// name. From then on `find` knows the name, too, if no folder is given.
  const Asset& made(const std::string& name, const std::function<Asset()>& make);

  /// Returns what there is to tell of the assets that were looked for so far, a line each: names that no
  /// asset has, and what models have that is not shown.
  std::vector<std::string> notes() const;

 private:
  std::filesystem::path file_of(const std::string& name, const std::string& folder) const;
  std::string boxes_note() const;
  const Asset* load(const std::string& name, const std::filesystem::path& file);

  std::vector<std::filesystem::path> folders_;  // the first that has a name counts
  std::filesystem::path script_folder_;
  std::map<std::pair<std::string, std::string>, const Asset*> by_name_;  // and folder
  std::map<std::filesystem::path, Asset> by_file_;
  std::map<std::string, Asset> made_;
};

}  // namespace solitaire
