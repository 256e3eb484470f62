#include "engines/tiles/request/read_style.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <set>
#include <stdexcept>

#include "base/file_error.h"
#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/read/exemplar.h"
#include "engines/tiles/request/listed_tiles.h"
#include "engines/tiles/request/matching_icons.h"
#include "engines/tiles/request/names.h"
#include "engines/tiles/request/orientations.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {
namespace {

bool is_labelled(const TileKind& kind) {
  return std::ranges::any_of(kind.edges, [](const std::string& label) { return !label.empty(); });
}

/// Leaves only those labels and exemplars from which pairs are to be learned. The labels of Wang sets, which
/// a map of Tiled may have for its editor alone, count where they are asked for, or where there is nothing
/// else.
void choose_pairs(const Request& request, Style& style) {
  const bool labels = request.pairs ? *request.pairs != PairsFrom::kSeen : true;
  const bool wang_sets = request.pairs ? labels : style.exemplars.empty();
  style.learns_from_exemplars = request.pairs != PairsFrom::kLabels;
  bool any = false;
  for (std::size_t number = 0; number < style.tileset.size(); ++number) {
    TileKind& kind = style.tileset[static_cast<Tile>(number)];
    if (!(kind.gid ? wang_sets : labels)) kind.edges = {};
    any = any || is_labelled(kind);
  }
  any = any || !request.adjacencies.empty() || request.icon_tolerance;
  if (any || (style.learns_from_exemplars && !style.exemplars.empty())) return;
  throw RequestError("there is no exemplar to learn from, and no tile has edges");
}

/// Returns the numbers by which adjacencies name tiles.
std::set<std::uint32_t> numbers_of(const Request& request) {
  std::set<std::uint32_t> numbers;
  for (const AdjacencyEntry& entry : request.adjacencies) {
    for (const auto* names : {&entry.first, &entry.second}) {
      for (const std::string& name : *names) {
        std::uint32_t number = 0;
        const char* const end = name.data() + name.size();
        if (std::from_chars(name.data(), end, number).ptr == end) numbers.insert(number);
      }
    }
  }
  return numbers;
}

/// Returns the tile that the holes of an exemplar are.
Tile empty_tile(const ExemplarEntry& entry, Tileset& tileset, bool open) {
  if (const auto known = tileset.find(entry.empty)) return *known;
  if (!open) return tile_called(tileset, entry.empty);
  TileKind kind = empty_kind(entry.empty);
  if (is_tiled(entry.file)) kind.gid = 0;
  return tileset.add(std::move(kind));
}

void fill_holes(const ExemplarEntry& entry, bool open, Tileset& tileset, Grid& grid) {
  if (entry.empty.empty() || std::ranges::count(grid.tiles, kHole) == 0) return;
  try {
    std::ranges::replace(grid.tiles, kHole, empty_tile(entry, tileset, open));
  } catch (const std::length_error& error) {
    throw FileError(entry.file.string(), error.what());
  }
}

void read_exemplar_of(const Request& request, const ExemplarEntry& entry, Style& style) {
  if (is_tileset(entry.file)) {
    const std::set<std::uint32_t> numbers = numbers_of(request);
    return numbers.empty() ? read_tiles_of(entry.file, style.tileset)
                           : read_numbered_tiles_of(entry.file, numbers, style.tileset);
  }
  const bool open = request.tiles.empty();
  for (Grid& grid : read_exemplars(entry.file, request.side_of_tiles(), style.tileset, open)) {
    fill_holes(entry, open, style.tileset, grid);
    Exemplar exemplar;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      exemplar.periodic[axis] = entry.periodic[axis] && grid.size.extent[axis] > 1;
    exemplar.grid = std::move(grid);
    exemplar.zone = zone_number(zone_names(request), entry.zone);
    exemplar.negative = entry.negative;
    exemplar.name = entry.file.string();
    style.exemplars.push_back(std::move(exemplar));
  }
}

void add_adjacencies(const Request& request, Style& style) {
  for (const AdjacencyEntry& entry : request.adjacencies) {
    said_at(entry.where, [&] {
      style.listed.push_back(
          {entry.axis, tile_set(style.tileset, entry.first), tile_set(style.tileset, entry.second)});
    });
  }
}

}  // namespace

std::shared_ptr<Style> read_style(const Request& request) {
  auto style = std::make_shared<Style>();
  add_listed_tiles(request, style->tileset);
  style->zones = std::max<std::size_t>(1, zone_names(request).size());
  if (style->zones > kMostZones) throw RequestError(fmt::format("there are more than {} zones", kMostZones));
  for (const ExemplarEntry& entry : request.exemplars) read_exemplar_of(request, entry, *style);
  add_remarks(request, style->tileset);
  add_adjacencies(request, *style);
  if (request.icon_tolerance) add_pairs_of_matching_icons(*request.icon_tolerance, *style);
  add_orientations(request, *style);
  choose_pairs(request, *style);
  learn_pairs(*style);
  return style;
}

}  // namespace solitaire::tiles
