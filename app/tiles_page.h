#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "engines/tiles/job/job.h"
#include "scene/gltf/instances.h"
#include "scene/page/page_files.h"

namespace solitaire::app {

/// How a map looks: as a picture (.png), and as a scene where that was asked for or it has models or layers.
struct MapLook {
  std::string name;  // of its files, without ending
  std::vector<tiles::ShownTile> tiles;
  std::string png;
  std::optional<Scene> scene;
  Nodes nodes = Nodes::kOneEach;  // of the scene's .glb
  std::string glb = "";           // its bytes, once its file is written
};

/// The page of a run's maps. It shows each as a picture, and in 3D those that have models or layers, and
/// takes the tile of a place for a choice: maps are filtered, compared and sorted by distance so.
class TilesPage {
 public:
  /// `stem` is the name of the maps' files without number and ending.
  TilesPage(const Options& options, std::string stem);

  /// Puts a map onto the page, with the files that it has in `options.output`.
  void add(std::uint64_t number, const MapLook& look);
  /// Writes the page. Does nothing if there is no map.
  void close() const;

 private:
  bool has_format(const std::string& format) const;
  std::string file_of(const std::string& name, const std::string& format) const;
  std::size_t position_of(const std::string& address);
  void add_row(const std::vector<tiles::ShownTile>& tiles);

  const Options& options_;
  std::string stem_;
  PageFiles page_;
  std::vector<GalleryEntry> entries_;
  std::vector<std::string> addresses_;  // of the places, in the order in which they were met
  std::map<std::string, std::size_t> positions_;
  std::string rows_;  // the maps' tiles, as choices.js has them
};

}  // namespace solitaire::app
