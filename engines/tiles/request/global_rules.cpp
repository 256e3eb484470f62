#include "engines/tiles/request/global_rules.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "engines/tiles/request/names.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/request/tile_images.h"
#include "engines/tiles/rules/acyclic.h"
#include "engines/tiles/rules/connected.h"
#include "engines/tiles/rules/distance.h"
#include "engines/tiles/rules/keys.h"
#include "engines/tiles/rules/longest_run.h"
#include "engines/tiles/rules/loops.h"
#include "engines/tiles/rules/path.h"
#include "engines/tiles/rules/tile_count.h"

namespace solitaire::tiles {
namespace {

Sides image_of(Sides sides, const Symmetry& symmetry) {
  Sides image = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int step : {1, -1}) {
      if ((sides & side(axis, step)) == 0) continue;
      Point towards{};
      towards[axis] = step;
      towards = symmetry.apply(towards);
      for (std::size_t other = 0; other < kAxes; ++other) {
        if (towards[other] != 0) image |= side(other, towards[other]);
      }
    }
  }
  return image;
}

/// Opens sides of a tile, and of its images what becomes of these sides.
void open_images(Tileset tileset, Tile tile, Sides sides, const SymmetryGroup& group,
                 std::vector<Sides>& open) {
  TileImages images(tileset, UnknownImages::kByLook);
  for (const Symmetry& symmetry : group.members()) {
    const auto image = images.image(tile, symmetry);
    if (image && *image < open.size() && open[*image] == 0) open[*image] = image_of(sides, symmetry);
  }
  open[tile] = sides;
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
  for (const auto& [name, letters] : entry.open)
    open_images(tileset, tile_called(tileset, name), sides_of(letters), entry.symmetry, open);
  return open;
}

/// Returns the members of a network, for messages.
std::string members_of(const ConnectedEntry& entry) {
  std::vector<std::string> names = entry.tiles;
  for (const auto& [name, letters] : entry.open) names.push_back(name);
  for (const std::string& label : entry.edges) names.push_back("sides " + label);
  return quoted(names);
}

std::shared_ptr<const GlobalRule> connected_rule(const ConnectedEntry& entry, const Problem& problem) {
  return std::make_shared<Connected>(problem.topology(), open_sides(entry, problem.style().tileset),
                                     fmt::format("{} are one connected network", members_of(entry)));
}

std::shared_ptr<const GlobalRule> acyclic_rule(const ConnectedEntry& entry, const Problem& problem) {
  return std::make_shared<Acyclic>(problem.topology(), open_sides(entry, problem.style().tileset),
                                   fmt::format("no way over {} leads round", members_of(entry)));
}

std::shared_ptr<const GlobalRule> loops_rule(const ConnectedEntry& entry, const Problem& problem) {
  return std::make_shared<Loops>(problem.topology(), open_sides(entry, problem.style().tileset),
                                 fmt::format("two ways over {} lead everywhere", members_of(entry)));
}

std::size_t site_of(const Point& said, const Size& size, const char* what) {
  const Point at = size.counted(said);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (at[axis] < 0 || at[axis] >= size.extent[axis]) {
      throw RequestError(fmt::format("{} at ({},{}) is outside of the map of {}x{}", what, said[0], said[1],
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
    const Tile closed = tile_called(tileset, door), opener = tile_called(tileset, key);
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
  const Tileset& tileset = problem.style().tileset;
  if (entry.others.empty()) {
    return std::make_shared<Distance>(
        problem.topology(), tile_set(tileset, entry.tiles), entry.least,
        fmt::format("{} are at least {} steps from each other", quoted(entry.tiles), entry.least));
  }
  return std::make_shared<PairDistance>(problem.topology(), tile_set(tileset, entry.tiles),
                                        tile_set(tileset, entry.others), entry.least,
                                        fmt::format("{} are at least {} steps from {}", quoted(entry.tiles),
                                                    entry.least, quoted(entry.others)));
}

std::shared_ptr<const GlobalRule> count_rule(const CountEntry& entry, const Problem& problem) {
  const auto sites = static_cast<double>(problem.size().volume());
  const auto least =
      std::max(entry.least, static_cast<std::uint64_t>(std::ceil(sites * entry.least_share - 1e-9)));
  const auto most = std::min(entry.most, static_cast<std::uint64_t>(std::floor(sites * entry.most_share)));
  if (least > most) {
    throw RequestError(fmt::format("at least {} of {} are asked for, and there can be at most {}", least,
                                   quoted(entry.tiles), most));
  }
  const std::string end = most == problem.size().volume() ? "any number" : std::to_string(most);
  return std::make_shared<TileCount>(
      tile_set(problem.style().tileset, entry.tiles), least, most,
      fmt::format("there are {} to {} of {}", least, end, quoted(entry.tiles)));
}

/// Adds a rule for each entry. `make` makes it of an entry and the problem.
template <class Entry, class Make>
void add_each(const std::vector<Entry>& entries, Problem& problem, Make make) {
  for (const Entry& entry : entries)
    said_at(entry.where, [&] { problem.add(make(entry, static_cast<const Problem&>(problem))); });
}

}  // namespace

void add_global_rules(const Request& request, Problem& problem) {
  add_each(request.connected, problem, connected_rule);
  add_each(request.acyclic, problem, acyclic_rule);
  add_each(request.loops, problem, loops_rule);
  add_each(request.runs, problem, run_rule);
  add_each(request.distances, problem, distance_rule);
  add_each(request.paths, problem, path_rule);
  add_each(request.keys, problem, keys_rule);
  add_each(request.counts, problem, count_rule);
}

}  // namespace solitaire::tiles
