#include "engines/tiles/model/tileset.h"

#include <fmt/format.h>
#include <stdexcept>

namespace solitaire::tiles {

TileKind empty_kind(const std::string& name) {
  TileKind kind;
  kind.name = name;
  kind.height = 0;
  return kind;
}

Tile Tileset::add(TileKind kind) {
  if (kinds_.size() == kMostTiles) {
    throw std::length_error(fmt::format("there are more than {} different tiles", kMostTiles));
  }
  kinds_.push_back(std::move(kind));
  return static_cast<Tile>(kinds_.size() - 1);
}

std::optional<Tile> Tileset::find(std::string_view name) const {
  for (std::size_t tile = 0; tile < kinds_.size(); ++tile) {
    if (kinds_[tile].name == name) return static_cast<Tile>(tile);
  }
  return std::nullopt;
}

std::vector<std::string> Tileset::names() const {
  std::vector<std::string> names;
  names.reserve(kinds_.size());
  for (const TileKind& kind : kinds_) names.push_back(kind.name);
  return names;
}

}  // namespace solitaire::tiles
