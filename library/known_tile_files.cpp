#include "library/known_tile_files.h"

#include <fmt/format.h>

#include "engines/tiles/request/read_inputs.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/request_error.h"

namespace solitaire::api {
namespace {

std::vector<std::vector<std::uint32_t>> followers(const tiles::Style& style, std::size_t axis) {
  std::vector<std::vector<std::uint32_t>> result(style.tileset.size());
  for (std::size_t first = 0; first < result.size(); ++first) {
    const auto tile = static_cast<tiles::Tile>(first);
    style.pairs.front().beside(tile, axis, 1).for_each([&](tiles::Tile next) {
      result[first].push_back(next);
    });
  }
  return result;
}

/// Returns the exemplars whose pairs are allowed, of maps in one layer.
std::vector<TileRows> exemplars_of(const tiles::Style& style) {
  std::vector<TileRows> exemplars;
  for (const tiles::Exemplar& exemplar : style.exemplars) {
    const tiles::Size& size = exemplar.grid.size;
    if (exemplar.negative || size.depth() > 1) continue;
    TileRows rows(static_cast<std::size_t>(size.height()));
    tiles::for_each_point(size, [&](const tiles::Point& at) {
      const tiles::Tile tile = exemplar.grid.at(at);
      rows[static_cast<std::size_t>(at[1])].push_back(tile == tiles::kHole ? kNoTile : tile);
    });
    exemplars.push_back(std::move(rows));
  }
  return exemplars;
}

std::shared_ptr<const TilePairs> read_pairs(const std::filesystem::path& file) {
  const std::shared_ptr<tiles::Style> style = tiles::read_style(tiles::read_inputs({file.string()}));
  if (style->zones > 1) {
    throw tiles::RequestError(
        fmt::format("{} has several zones, of which a program knows nothing", file.string()));
  }
  return std::make_shared<TilePairs>(
      TilePairs{style->tileset.names(), followers(*style, 0), followers(*style, 1), exemplars_of(*style)});
}

}  // namespace

std::shared_ptr<const TilePairs> KnownTileFiles::find(const std::string& file) const {
  const std::lock_guard lock(mutex_);
  auto& known = read_[file];
  if (known == nullptr) known = read_pairs(folder_ / file);
  return known;
}

}  // namespace solitaire::api
