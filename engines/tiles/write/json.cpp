#include "engines/tiles/write/json.h"

#include <nlohmann/json.hpp>

namespace solitaire::tiles {

std::string write_json(const Grid& map, const Tileset& tileset, const nlohmann::ordered_json& about) {
  nlohmann::ordered_json file = about;
  file["size"] = map.size.extent;
  file["tiles"] = tileset.names();
  std::string text = file.dump(1);
  text.resize(text.size() - 2);  // without the last line's end and brace
  text += ",\n \"data\": [";
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (site > 0) text += site % static_cast<std::size_t>(map.size.width()) == 0 ? ",\n  " : ",";
    text += map[site] == kHole ? "-1" : std::to_string(map[site]);
  }
  return text + "]\n}\n";
}

}  // namespace solitaire::tiles
