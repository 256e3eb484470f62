// The constraints of DeBroglie's configuration, in the words of a request.
#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "engines/tiles/request/debroglie_words.h"

namespace solitaire::tiles {
namespace {

/// Reads {"x", "y", "z"}.
Point point_of(JsonObject& holder, const char* member, const nlohmann::json& json, const DebroglieMap& map) {
  JsonObject object(holder.file(), json, holder.way(member));
  Point point{};
  static constexpr std::array<const char*, kAxes> kNames{"x", "y", "z"};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (axis == 2 && !object.has("z")) continue;
    point[axis] = static_cast<int>(object.number(kNames.at(axis), 0, map.size[axis] - 1));
  }
  object.require_no_more();
  if (map.is_flipped) point[1] = map.size[1] - 1 - point[1];
  return point;
}

std::vector<Point> points_of(JsonObject& object, const char* member, const DebroglieMap& map) {
  std::vector<Point> points;
  if (!object.has(member)) return points;
  if (!object.at(member).is_array()) object.fail(member, "is no list of places");
  for (const nlohmann::json& each : object.at(member)) points.push_back(point_of(object, member, each, map));
  return points;
}

/// Returns the letter of the side that "x+", "xplus" and the like name.
char side_letter(JsonObject& object, const char* member, const std::string& direction,
                 const DebroglieMap& map) {
  static constexpr std::array<std::array<const char*, 2>, 6> kNames{{{"x+", "xplus"},
                                                                     {"x-", "xminus"},
                                                                     {"y+", "yplus"},
                                                                     {"y-", "yminus"},
                                                                     {"z+", "zplus"},
                                                                     {"z-", "zminus"}}};
  const std::string name = in_small_letters(direction);
  const auto found =
      std::ranges::find_if(kNames, [&](const auto& each) { return name == each[0] || name == each[1]; });
  if (found == kNames.end())
    object.fail(member, fmt::format("has the direction '{}'; x+, x-, y+, y-, z+ and z- are", direction));
  return (map.is_flipped ? "rltbud" : "rlbtud")[found - kNames.begin()];
}

ConnectedEntry edged_network(JsonObject& object, const DebroglieMap& map, const Request& request) {
  const char* const member = object.has("exits") ? "exits" : "pathTiles";
  const nlohmann::json& exits = object.at(member);
  if (!exits.is_object()) object.fail(member, "is no object of tiles and their exits");
  ConnectedEntry network;
  for (const auto& [name, directions] : exits.items()) {
    if (!directions.is_array()) object.fail(member, fmt::format("has no list of directions for '{}'", name));
    std::string letters;
    for (const nlohmann::json& each : directions) {
      if (!each.is_string()) object.fail(member, fmt::format("has what is no direction for '{}'", name));
      letters += side_letter(object, member, each.get<std::string>(), map);
    }
    network.open.emplace_back(debroglie_tile(map, object, member, name), letters);
  }
  network.symmetry = request.symmetry;
  return network;
}

/// Reads which tiles a path goes over: those of a list, or with exits, as the type says.
ConnectedEntry network_of(JsonObject& object, const std::string& type, const DebroglieMap& map,
                          const Request& request) {
  ConnectedEntry network;
  if (type == "path") {
    network.tiles =
        object.has("pathTiles") ? debroglie_tiles(map, object, "pathTiles") : debroglie_tiles(map, object);
  } else {
    network = edged_network(object, map, request);
  }
  for (const char* member : {"endPointTiles", "relevantTiles"}) {
    if (object.has(member))
      object.fail(member, "is not read: all tiles of the path, or the places of 'endPoints', are connected");
  }
  network.where = object.where();
  return network;
}

/// All of the network is connected, or, if there are places, these are.
void connect(ConnectedEntry network, const std::vector<Point>& ends, Request& request) {
  if (ends.empty()) {
    request.connected.push_back(std::move(network));
    return;
  }
  for (std::size_t end = 1; end < ends.size(); ++end)
    request.paths.push_back({ends.front(), ends[end], network, network.where});
}

void add_path(JsonObject& object, const std::string& type, const DebroglieMap& map, Request& request) {
  ConnectedEntry network = network_of(object, type, map, request);
  connect(std::move(network), points_of(object, "endPoints", map), request);
}

/// Adds "connected", "acyclic" and "loop", whose path is described by a part of its own.
void add_by_spec(JsonObject& object, const std::string& type, const DebroglieMap& map, Request& request) {
  JsonObject spec(object.file(), object.at("pathSpec"), object.way("pathSpec"));
  const std::string kind = spec.text("type");
  ConnectedEntry network = network_of(spec, kind == "path" ? "path" : "edgedPath", map, request);
  const std::vector<Point> cells = points_of(spec, "relevantCells", map);
  spec.require_no_more();
  if (type == "acyclic") {
    request.acyclic.push_back(std::move(network));
  } else if (type == "loop") {
    request.loops.push_back(std::move(network));
  } else {
    connect(std::move(network), cells, request);
  }
}

/// Reads the sides in a text like "xmin, ymax"; those along z are dropped in flat maps.
std::vector<std::string> sides_of_text(JsonObject& object, const char* member, const DebroglieMap& map) {
  static constexpr std::array<const char*, 6> kNames{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  static constexpr std::array<const char*, 6> kHere{"left", "right", "top", "bottom", "below", "above"};
  std::vector<std::string> sides;
  std::string rest = in_small_letters(object.text(member));
  rest.erase(std::remove(rest.begin(), rest.end(), ' '), rest.end());
  for (std::size_t from = 0; from <= rest.size();) {
    const std::size_t comma = std::min(rest.find(',', from), rest.size());
    const std::string name = rest.substr(from, comma - from);
    from = comma + 1;
    if (name == "all") sides.emplace_back("all");
    if (name == "all" || name == "none") continue;
    auto side = static_cast<std::size_t>(std::ranges::find(kNames, name) - kNames.begin());
    if (side == kNames.size())
      object.fail(member, fmt::format("has the side '{}'; xmin, xmax, ymin, ymax, zmin and zmax are", name));
    if (map.is_flipped && (side == 2 || side == 3)) side = 5 - side;
    if (side < 4 || map.has_layers) sides.emplace_back(kHere.at(side));
  }
  return sides;
}

void add_border(JsonObject& object, const DebroglieMap& map, Request& request) {
  BorderEntry border{{"all"}, debroglie_tiles(map, object)};
  if (object.has("sides")) border.sides = sides_of_text(object, "sides", map);
  if (object.has("excludeSides")) border.except = sides_of_text(object, "excludeSides", map);
  border.inside = object.flag("invertArea");
  border.forbidden = object.flag("ban");
  border.where = object.where();
  request.borders.push_back(std::move(border));
}

void add_fixed_tile(JsonObject& object, const DebroglieMap& map, Request& request) {
  const std::vector<std::string> tiles = debroglie_tiles(map, object);
  if (!object.has("point")) {
    request.counts.push_back({tiles, 1, UINT64_MAX, object.where()});
    request.notes.push_back(object.where() +
                            ": a fixed tile without a point is read as: there is one somewhere");
    return;
  }
  PinEntry pin;
  pin.from = point_of(object, "point", object.at("point"), map);
  for (std::size_t axis = 0; axis < kAxes; ++axis) pin.to[axis] = pin.from[axis] + 1;
  pin.tiles = tiles;
  pin.where = object.where();
  request.pins.push_back(std::move(pin));
}

void add_longest_runs(JsonObject& object, const DebroglieMap& map, Request& request) {
  RunEntry run{debroglie_tiles(map, object), std::nullopt, 3, object.where()};
  if (object.has("maxCount")) run.most = static_cast<std::uint64_t>(object.number("maxCount", 1, INT32_MAX));
  if (!object.has("axes")) {
    request.runs.push_back(std::move(run));
    return;
  }
  for (const std::string& name : object.texts("axes")) {
    const std::size_t axis = std::string("xyz").find(in_small_letters(name));
    if (name.size() != 1 || axis >= kAxes)
      object.fail("axes", fmt::format("has '{}'; x, y and z are axes", name));
    run.axis = axis;
    request.runs.push_back(run);
  }
}

void add_mirror(JsonObject& object, std::size_t axis, Request& request) {
  if (request.mirror) object.fail("type", "is a second mirror; one is read");
  MirrorEntry mirror;
  mirror.axis = axis;
  mirror.by_look = true;
  mirror.where = object.where();
  request.mirror = std::move(mirror);
}

void add_count(JsonObject& object, const DebroglieMap& map, Request& request) {
  CountEntry entry{debroglie_tiles(map, object), 0, UINT64_MAX, object.where()};
  const std::string comparison = in_small_letters(object.text("comparison"));
  const auto count = static_cast<std::uint64_t>(object.number("count", 0, INT64_MAX));
  if (comparison != "atleast" && comparison != "atmost" && comparison != "exactly")
    object.fail("comparison", "is none of atLeast, atMost and exactly");
  if (comparison != "atmost") entry.least = count;
  if (comparison != "atleast") entry.most = count;
  object.has("eager");  // how it searches is its own business
  request.counts.push_back(std::move(entry));
}

void add_separation(JsonObject& object, bool of_pairs, const DebroglieMap& map, Request& request) {
  DistanceEntry distance;
  distance.tiles = of_pairs ? debroglie_tiles(map, object, "tiles1") : debroglie_tiles(map, object);
  if (of_pairs) distance.others = debroglie_tiles(map, object, "tiles2");
  distance.least = static_cast<int>(object.number("minDistance", 1, 1 << 20));
  distance.where = object.where();
  request.distances.push_back(std::move(distance));
}

}  // namespace

void add_debroglie_constraint(JsonObject& object, const DebroglieMap& map, Request& request) {
  const std::string type = object.text("type");
  if (type == "path" || type == "edgedPath") {
    add_path(object, type, map, request);
  } else if (type == "connected" || type == "acyclic" || type == "loop") {
    add_by_spec(object, type, map, request);
  } else if (type == "border") {
    add_border(object, map, request);
  } else if (type == "fixedTile") {
    add_fixed_tile(object, map, request);
  } else if (type == "maxConsecutive" || type == "maxConsectuive") {  // its documentation has the second
    add_longest_runs(object, map, request);
  } else if (type == "mirror" || type == "mirrorX") {
    add_mirror(object, 0, request);
  } else if (type == "mirrorY") {
    add_mirror(object, 1, request);
  } else if (type == "count") {
    add_count(object, map, request);
  } else if (type == "separation" || type == "pairSeparation") {
    add_separation(object, type == "pairSeparation", map, request);
  } else {
    object.fail(
        "type",
        fmt::format(
            "is '{}', which is not read; path, edgedPath, connected, acyclic, loop, border, fixedTile, "
            "maxConsecutive, mirrorX, mirrorY, count, separation and pairSeparation are",
            type));
  }
  object.has("comment");
  object.require_no_more();
}

void add_debroglie_ground(const std::string& tile, const std::string& where, const DebroglieMap& map,
                          Request& request) {
  BorderEntry ground{{map.has_layers ? "below" : "bottom"}, {tile}};
  ground.where = where;
  request.borders.push_back(ground);
  ground.inside = ground.forbidden = true;
  request.borders.push_back(std::move(ground));
}

}  // namespace solitaire::tiles
