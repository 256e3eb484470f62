#include "engines/tiles/request/build.h"

#include <algorithm>
#include <fmt/format.h>

#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/model/palette.h"
#include "engines/tiles/read/exemplar.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/request/tile_variants.h"
#include "engines/tiles/rules/connected.h"
#include "engines/tiles/rules/distance.h"
#include "engines/tiles/rules/keys.h"
#include "engines/tiles/rules/longest_run.h"
#include "engines/tiles/rules/path.h"
#include "engines/tiles/rules/tile_count.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {
namespace {

std::string quoted(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += fmt::format("{}'{}'", text.empty() ? "" : ", ", name);
  return text;
}

/// Returns the zones that exemplars name, in the order of their first appearance.
std::vector<std::string> zone_names(const Request& request) {
  std::vector<std::string> names;
  for (const ExemplarEntry& exemplar : request.exemplars) {
    if (std::ranges::find(names, exemplar.zone) == names.end()) names.push_back(exemplar.zone);
  }
  return names;
}

std::uint8_t zone_number(const std::vector<std::string>& names, const std::string& zone) {
  const auto found = std::ranges::find(names, zone);
  if (found == names.end()) {
    throw RequestError(fmt::format("no exemplar has the zone '{}'; there are {}", zone, quoted(names)));
  }
  return static_cast<std::uint8_t>(found - names.begin());
}

TileMask tile_set(const Tileset& tileset, const std::vector<std::string>& names) {
  TileMask mask;
  for (const std::string& name : names) {
    const auto tile = tileset.find(name);
    if (!tile) {
      throw RequestError(
          fmt::format("there is no tile '{}'; the tiles are {}", name, quoted(tileset.names())));
    }
    mask.insert(*tile);
  }
  return mask;
}

Picture icon_at(const Picture& icons, const TileEntry& entry, int side) {
  const int left = (*entry.icon)[0] * side, top = (*entry.icon)[1] * side;
  if (left < 0 || top < 0 || left + side > icons.width || top + side > icons.height) {
    throw RequestError(fmt::format("the icon of '{}' is outside of the picture of icons", entry.name));
  }
  Picture icon(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) icon.at(x, y) = icons.at(left + x, top + y);
  }
  return icon;
}

Sides sides_of(const std::string& letters);

/// Writes the labels of a tile's sides into its kind: first those that are the same for all other sides.
void add_edges(const TileEntry& entry, TileKind& kind) {
  for (const bool all : {true, false}) {
    for (const auto& [letter, label] : entry.edges) {
      if ((letter == "*") != all) continue;
      const Sides sides = all ? kFlatSides : sides_of(letter);
      for (std::size_t side = 0; side < kind.edges.size(); ++side) {
        if ((sides >> side & 1U) != 0) kind.edges[side] = label;
      }
    }
  }
}

void add_tiles(const Request& request, Tileset& tileset) {
  Picture icons;
  if (!request.icons.empty()) icons = read_png(request.icons.string(), read_bytes(request.icons));
  for (const TileEntry& entry : request.tiles) {
    TileKind kind;
    kind.name = entry.name;
    kind.text = entry.text;
    kind.bias = entry.bias;
    kind.voxel = entry.voxel;
    kind.asset = entry.asset;
    kind.turn = entry.turn;
    kind.height = entry.height;
    if (entry.icon) kind.icon = icon_at(icons, entry, request.tile_side);
    kind.color = entry.color  ? *entry.color
                 : entry.icon ? mean_color(kind.icon)
                              : palette_color(tileset.size());
    add_edges(entry, kind);
    for (TileKind& variant : variants_of(kind, entry.symmetry)) {
      if (tileset.find(variant.name)) {
        throw RequestError(fmt::format("there are two tiles '{}'", variant.name));
      }
      tileset.add(std::move(variant));
    }
  }
}

SiteRule pin_rule(const PinEntry& pin, const Problem& problem) {
  SiteRule rule;
  rule.allowed = tile_set(problem.style().tileset, pin.tiles);
  const Size& size = problem.size();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (pin.from[axis] >= 0 && pin.from[axis] < pin.to[axis] && pin.to[axis] <= size.extent[axis]) continue;
    throw RequestError(fmt::format("the pin at ({},{},{}) is outside of the map of {}x{}x{}", pin.from[0],
                                   pin.from[1], pin.from[2], size.width(), size.height(), size.depth()));
  }
  const Size box{{pin.to[0] - pin.from[0], pin.to[1] - pin.from[1], pin.to[2] - pin.from[2]}};
  for_each_point(box, [&](const Point& at) {
    rule.sites.push_back(static_cast<std::uint32_t>(
        size.site({pin.from[0] + at[0], pin.from[1] + at[1], pin.from[2] + at[2]})));
  });
  const std::string where = box.volume() == 1 ? fmt::format("({},{})", pin.from[0], pin.from[1])
                                              : fmt::format("({},{}) to ({},{})", pin.from[0], pin.from[1],
                                                            pin.to[0] - 1, pin.to[1] - 1);
  rule.text = fmt::format("{} is pinned to {}", where, quoted(pin.tiles));
  return rule;
}

/// Returns the axis and the step of a side's name.
std::pair<std::size_t, int> side_named(const std::string& name) {
  static constexpr std::array<const char*, 6> kNames{"right", "left", "bottom", "top", "above", "below"};
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) {
    throw RequestError(
        fmt::format("'{}' is no side of a map: left, right, top, bottom, below, above or all", name));
  }
  const auto number = static_cast<std::size_t>(found - kNames.begin());
  return {number / 2, number % 2 == 0 ? 1 : -1};
}

bool on_side(const Size& size, const Point& at, std::size_t axis, int step) {
  return at[axis] == (step > 0 ? size.extent[axis] - 1 : 0);
}

SiteRule border_rule(const BorderEntry& border, const Problem& problem) {
  SiteRule rule;
  rule.allowed = tile_set(problem.style().tileset, border.tiles);
  rule.text = fmt::format("the border ({}) has {}", border.side, quoted(border.tiles));
  std::vector<std::pair<std::size_t, int>> sides;
  if (border.side == "all") {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (problem.size().extent[axis] > 1) sides.insert(sides.end(), {{axis, 1}, {axis, -1}});
    }
  } else {
    sides.push_back(side_named(border.side));
  }
  for_each_point(problem.size(), [&](const Point& at) {
    const bool any = std::ranges::any_of(
        sides, [&](const auto& each) { return on_side(problem.size(), at, each.first, each.second); });
    if (any) rule.sites.push_back(static_cast<std::uint32_t>(problem.size().site(at)));
  });
  return rule;
}

/// Returns the zone of every site, by the colours of a picture that is stretched over the map.
std::vector<std::uint8_t> read_zones(const ZoneMap& map, const Size& size,
                                     const std::vector<std::string>& names) {
  const Picture picture = read_png(map.file.string(), read_bytes(map.file));
  std::vector<std::uint8_t> zones;
  zones.reserve(size.volume());
  for_each_point(size, [&](const Point& at) {
    const Rgba& color = picture.at_share(at[0], size.width(), at[1], size.height());
    const auto found = std::ranges::find(map.legend, color, &std::pair<Rgba, std::string>::first);
    if (found == map.legend.end()) {
      throw FileError(map.file.string(),
                      fmt::format("the colour #{:02x}{:02x}{:02x} for ({},{}) is in no legend", color[0],
                                  color[1], color[2], at[0], at[1]));
    }
    zones.push_back(zone_number(names, found->second));
  });
  return zones;
}

/// Returns the sides that letters name: l, r, t, b, and u and d for up and down in maps of several layers.
Sides sides_of(const std::string& letters) {
  Sides sides = 0;
  for (const char letter : letters) {
    const std::size_t place = std::string("rlbtud").find(letter);
    if (place == std::string::npos) {
      throw RequestError(fmt::format("'{}' is no side; l, r, t, b, u and d are", letter));
    }
    sides |= static_cast<Sides>(1U << place);
  }
  return sides;
}

/// Returns the open sides of each tile of a network.
std::vector<Sides> open_sides(const ConnectedEntry& entry, const Tileset& tileset) {
  std::vector<Sides> open(tileset.size());
  tile_set(tileset, entry.tiles).for_each([&](Tile tile) { open[tile] = kAllSides; });
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const auto& edges = tileset[static_cast<Tile>(tile)].edges;
    for (std::size_t place = 0; place < edges.size(); ++place) {
      if (std::ranges::count(entry.edges, edges[place]) > 0) open[tile] |= static_cast<Sides>(1U << place);
    }
  }
  for (const auto& [name, letters] : entry.open) {
    open[tile_set(tileset, {name}).lowest()] = sides_of(letters);
  }
  return open;
}

std::shared_ptr<const GlobalRule> connected_rule(const ConnectedEntry& entry, const Problem& problem) {
  std::vector<std::string> names = entry.tiles;
  for (const auto& [name, letters] : entry.open) names.push_back(name);
  for (const std::string& label : entry.edges) names.push_back("sides " + label);
  return std::make_shared<Connected>(problem.topology(), open_sides(entry, problem.style().tileset),
                                     fmt::format("{} are one connected network", quoted(names)));
}

std::size_t site_of(const Point& at, const Size& size, const char* what) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (at[axis] >= size.extent[axis]) {
      throw RequestError(fmt::format("{} at ({},{}) is outside of the map of {}x{}", what, at[0], at[1],
                                     size.width(), size.height()));
    }
  }
  return size.site(at);
}

std::shared_ptr<const GlobalRule> path_rule(const PathEntry& entry, const Problem& problem) {
  return std::make_shared<Path>(problem.topology(), open_sides(entry.over, problem.style().tileset),
                                site_of(entry.from, problem.size(), "the path's end"),
                                site_of(entry.to, problem.size(), "the path's end"),
                                fmt::format("a path leads from ({},{}) to ({},{})", entry.from[0],
                                            entry.from[1], entry.to[0], entry.to[1]));
}

/// Doors and keys are passable, also where the network does not name them.
std::shared_ptr<const GlobalRule> keys_rule(const KeysEntry& entry, const Problem& problem) {
  const Tileset& tileset = problem.style().tileset;
  std::vector<Sides> open = open_sides(entry.over, tileset);
  std::vector<std::optional<Tile>> keys(tileset.size());
  for (const auto& [door, key] : entry.doors) {
    const Tile closed = tile_set(tileset, {door}).lowest(), opener = tile_set(tileset, {key}).lowest();
    keys[closed] = opener;
    for (const Tile tile : {closed, opener}) open[tile] = open[tile] == 0 ? kAllSides : open[tile];
  }
  const std::size_t from = site_of(entry.from, problem.size(), "the place where one begins");
  return std::make_shared<Keys>(problem.topology(), std::move(open), std::move(keys), from,
                                fmt::format("all can be reached from ({},{}), the key of each door before it",
                                            entry.from[0], entry.from[1]));
}

std::shared_ptr<const GlobalRule> run_rule(const RunEntry& entry, const Problem& problem) {
  std::vector<std::size_t> axes{0, 1, 2};
  if (entry.axis) axes = {*entry.axis};
  return std::make_shared<LongestRun>(
      tile_set(problem.style().tileset, entry.tiles), axes, entry.most,
      fmt::format("at most {} of {} follow each other", entry.most, quoted(entry.tiles)));
}

std::shared_ptr<const GlobalRule> distance_rule(const DistanceEntry& entry, const Problem& problem) {
  return std::make_shared<Distance>(
      problem.topology(), tile_set(problem.style().tileset, entry.tiles), entry.least,
      fmt::format("{} are at least {} steps from each other", quoted(entry.tiles), entry.least));
}

std::shared_ptr<const GlobalRule> count_rule(const CountEntry& entry, const Problem& problem) {
  const std::uint64_t possible = std::min<std::uint64_t>(entry.most, problem.size().volume());
  if (entry.least > possible) {
    throw RequestError(fmt::format("at least {} of {} are asked for, and there can be at most {}",
                                   entry.least, quoted(entry.tiles), possible));
  }
  const std::string most = entry.most == UINT64_MAX ? "any number" : std::to_string(entry.most);
  return std::make_shared<TileCount>(
      tile_set(problem.style().tileset, entry.tiles), entry.least, entry.most,
      fmt::format("there are {} to {} of {}", entry.least, most, quoted(entry.tiles)));
}

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
  if (any || (style.learns_from_exemplars && !style.exemplars.empty())) return;
  throw RequestError("there is no exemplar to learn from, and no tile has edges");
}

}  // namespace

std::shared_ptr<Style> read_style(const Request& request) {
  auto style = std::make_shared<Style>();
  add_tiles(request, style->tileset);
  const bool open = request.tiles.empty();
  const std::vector<std::string> zones = zone_names(request);
  if (zones.size() > kMostZones) throw RequestError(fmt::format("there are more than {} zones", kMostZones));
  style->zones = std::max<std::size_t>(1, zones.size());
  for (const ExemplarEntry& entry : request.exemplars) {
    if (is_tileset(entry.file)) {
      read_tiles_of(entry.file, style->tileset);
      continue;
    }
    Exemplar exemplar;
    exemplar.grid = read_exemplar(entry.file, request.tile_side, style->tileset, open);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      exemplar.periodic[axis] = entry.periodic && exemplar.grid.size.extent[axis] > 1;
    }
    exemplar.zone = zone_number(zones, entry.zone);
    exemplar.negative = entry.negative;
    exemplar.name = entry.file.string();
    style->exemplars.push_back(std::move(exemplar));
  }
  choose_pairs(request, *style);
  learn_pairs(*style);
  return style;
}

Problem make_problem(const Request& request, std::shared_ptr<const Style> style) {
  Problem problem(std::move(style), {{request.size}, request.periodic});
  for (const PinEntry& pin : request.pins) problem.add(pin_rule(pin, problem));
  for (const std::filesystem::path& map : request.pin_maps) {
    for (const TiledPin& pin : read_pins(map)) problem.add(pin_rule({pin.from, pin.to, pin.tiles}, problem));
  }
  for (const BorderEntry& border : request.borders) problem.add(border_rule(border, problem));
  if (request.zones) problem.set_zones(read_zones(*request.zones, problem.size(), zone_names(request)));
  for (const ConnectedEntry& entry : request.connected) problem.add(connected_rule(entry, problem));
  for (const RunEntry& entry : request.runs) problem.add(run_rule(entry, problem));
  for (const DistanceEntry& entry : request.distances) problem.add(distance_rule(entry, problem));
  for (const PathEntry& entry : request.paths) problem.add(path_rule(entry, problem));
  for (const KeysEntry& entry : request.keys) problem.add(keys_rule(entry, problem));
  for (const CountEntry& entry : request.counts) problem.add(count_rule(entry, problem));
  return problem;
}

std::vector<std::uint8_t> zones_by_tile(const Request& request, const Tileset& coarse) {
  const std::vector<std::string> names = zone_names(request);
  std::vector<std::uint8_t> zones;
  for (const std::string& tile : coarse.names()) zones.push_back(zone_number(names, tile));
  return zones;
}

std::optional<Mirror> make_mirror(const Request& request, const Problem& problem) {
  if (!request.mirror) return std::nullopt;
  const Tileset& tileset = problem.style().tileset;
  std::vector<Tile> partners;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) partners.push_back(static_cast<Tile>(tile));
  for (const auto& [name, partner] : request.mirror->partners) {
    const Tile a = tile_set(tileset, {name}).lowest(), b = tile_set(tileset, {partner}).lowest();
    partners[a] = b;
    partners[b] = a;
  }
  try {
    return Mirror(problem, request.mirror->axis, std::move(partners));
  } catch (const std::invalid_argument& error) {
    throw RequestError(error.what());
  }
}

}  // namespace solitaire::tiles
