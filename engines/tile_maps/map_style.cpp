#include "engines/tile_maps/map_style.h"

#include <algorithm>
#include <stdexcept>

#include "engines/tiles/learn/fit.h"
#include "engines/tiles/learn/patterns.h"

namespace solitaire {
namespace {

using tiles::Tile;

void add_exemplar(const TileRows& rows, tiles::Style& style) {
  if (rows.empty() || rows.front().empty()) return;
  tiles::Exemplar exemplar;
  exemplar.grid =
      tiles::Grid(tiles::Size{{static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), 1}});
  std::size_t site = 0;
  for (const auto& row : rows) {
    for (const std::uint32_t tile : row)
      exemplar.grid[site++] = tile == kNoTile ? tiles::kHole : static_cast<Tile>(tile);
  }
  style.exemplars.push_back(std::move(exemplar));
}

void add_tiles(std::size_t count, tiles::Style& style) {
  for (std::size_t tile = 0; tile < count; ++tile) style.tileset.add(tiles::empty_kind(std::to_string(tile)));
}

/// The exemplar stands in the program: its pairs are all that there are.
void learn_from(const List& rows, tiles::Style& style) {
  TileRows numbers;
  std::uint32_t most = 0;
  for (const Value& row : rows.items) {
    numbers.emplace_back();
    for (const Value& tile : row.as_list()->items) {
      numbers.back().push_back(static_cast<std::uint32_t>(*tile.get<std::int64_t>()));
      most = std::max(most, numbers.back().back());
    }
  }
  add_tiles(most + 1, style);
  add_exemplar(numbers, style);
}

/// The pairs are those of a file, which its exemplars need not have.
void learn_from(const TilePairs& pairs, tiles::Style& style) {
  add_tiles(pairs.names.size(), style);
  style.learns_from_exemplars = false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& followers = axis == 0 ? pairs.to_the_right : pairs.below;
    for (std::size_t tile = 0; tile < followers.size(); ++tile) {
      tiles::ListedPairs listed{axis, tiles::TileMask::of(static_cast<Tile>(tile)), {}};
      for (const std::uint32_t next : followers[tile]) listed.second.insert(static_cast<Tile>(next));
      style.listed.push_back(listed);
    }
  }
  for (const TileRows& rows : pairs.exemplars) add_exemplar(rows, style);
}

}  // namespace

std::shared_ptr<const tiles::Style> style_of_source(const Value& source, const Program& program,
                                                    std::uint64_t seed, const StopSignal& stop) {
  auto style = std::make_shared<tiles::Style>();
  if (const String* file = source.object<String>()) {
    learn_from(*program.tile_files->find(file->text), *style);
  } else {
    learn_from(*source.as_list(), *style);
  }
  tiles::learn_pairs(*style);
  if (!style->exemplars.empty()) tiles::fit_weights(*style, tiles::default_shapes(*style), seed, stop);
  return style;
}

}  // namespace solitaire
