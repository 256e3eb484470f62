#include "engines/tiles/request/request_file.h"

#include <fmt/format.h>

#include "engines/tiles/read/file.h"
#include "engines/tiles/read/json_object.h"

namespace solitaire::tiles {
namespace {

namespace fs = std::filesystem;

/// Reads "#rrggbb".
Rgba color_of(JsonObject& object, const char* member) {
  const std::string text = object.text(member);
  Rgba color{0, 0, 0, 255};
  unsigned value = 0;
  const bool fits = text.size() == 7 && text[0] == '#' &&
                    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!fits) object.fail(member, "is no colour; write #rrggbb");
  value = static_cast<unsigned>(std::stoul(text.substr(1), nullptr, 16));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    color[channel] = static_cast<std::uint8_t>(value >> (16 - 8 * channel));
  }
  return color;
}

/// Problem files may name others, for their zones, so deep at most.
constexpr int kMostNesting = 4;

/// Reads one problem file.
class RequestReader {
 public:
  /// `nesting` counts the problem files that lead here.
  RequestReader(const fs::path& path, const std::string& text, int nesting)
      : name_(path.string()),
        folder_(path.parent_path()),
        nesting_(nesting),
        json_(parse_json(name_, text)) {}

  Request read() {
    JsonObject file(name_, json_, "");
    request_.icons = file.has("icons") ? path(file, "icons") : fs::path();
    if (file.has("tile")) request_.tile_side = static_cast<int>(file.number("tile", 1, 1024));
    for (JsonObject& each : file.objects("tiles")) read_tile(each);
    if (file.has("exemplars")) read_exemplars(file);
    read_map(file);
    read_weights(file);
    for (JsonObject& each : file.objects("pins")) read_pin(each);
    for (JsonObject& each : file.objects("borders")) read_border(each);
    for (JsonObject& each : file.objects("connected")) read_connected(each);
    for (JsonObject& each : file.objects("acyclic")) read_acyclic(each);
    for (JsonObject& each : file.objects("loops")) read_loops(each);
    for (JsonObject& each : file.objects("adjacencies")) read_adjacency(each);
    for (JsonObject& each : file.objects("counts")) read_count(each);
    for (JsonObject& each : file.objects("runs")) read_run(each);
    for (JsonObject& each : file.objects("distances")) read_distance(each);
    for (JsonObject& each : file.objects("paths")) read_path(each);
    for (JsonObject& each : file.objects("keys")) read_keys(each);
    if (file.has("pins_from")) request_.pin_maps.push_back(path(file, "pins_from"));
    if (file.has("mirror")) read_mirror(JsonObject(name_, file.at("mirror"), "mirror"));
    if (file.has("zones")) read_zones(JsonObject(name_, file.at("zones"), "zones"));
    file.require_no_more();
    return std::move(request_);
  }

 private:
  /// Returns a file beside the problem file or below it.
  fs::path path(JsonObject& object, const char* member) const {
    const fs::path relative = fs::path(object.text(member)).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") {
      object.fail(member, "is no path within the folder of the problem file");
    }
    return folder_ / relative;
  }

  /// A place in the picture of icons, or a file of its own.
  void read_icon(JsonObject& object, TileEntry& tile) const {
    if (object.at("icon").is_string()) {
      tile.icon_file = path(object, "icon");
      return;
    }
    const std::vector<int> place = object.numbers("icon", 0, 2, 2);
    tile.icon = {place[0], place[1]};
  }

  void read_tile(JsonObject& object) {
    TileEntry tile;
    tile.name = object.text("name");
    tile.text = object.text_or("char", "");
    if (object.has("color")) tile.color = color_of(object, "color");
    if (object.has("icon")) read_icon(object, tile);
    if (object.has("bias")) tile.bias = object.real("bias", 1e-6, 1e6);
    if (object.has("voxel")) tile.voxel = static_cast<std::uint8_t>(object.number("voxel", 0, 255));
    if (object.has("voxels")) tile.voxel_file = path(object, "voxels");
    if (object.has("asset")) tile.asset = object.text("asset");
    if (object.has("turn")) tile.turn = static_cast<int>(object.number("turn", 0, 3));
    if (object.has("edges")) tile.edges = pairs_of_texts(object, "edges", "sides and their labels");
    tile.symmetry = object.text_or("symmetry", "");
    if (object.has("height")) tile.height = object.real("height", 0, 1000);
    tile.rotates = !object.has("rotate") || object.flag("rotate");
    tile.turned = object.text_or("turned", "");
    tile.mirrored = object.text_or("mirrored", "");
    tile.where = object.where();
    object.require_no_more();
    request_.tiles.push_back(std::move(tile));
  }

  /// A list of file names, or of objects that say more of each.
  void read_exemplars(JsonObject& file) {
    const auto& list = file.at("exemplars");
    if (!list.is_array()) file.fail("exemplars", "is no list");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const nlohmann::json as_object = list[i].is_string() ? nlohmann::json{{"file", list[i]}} : list[i];
      JsonObject object(name_, as_object, fmt::format("exemplars[{}]", i));
      ExemplarEntry entry;
      entry.file = path(object, "file");
      entry.zone = object.text_or("zone", "");
      entry.negative = object.flag("negative");
      if (object.has("periodic")) entry.periodic = axes_of(object, "periodic");
      entry.empty = object.text_or("empty", "");
      object.require_no_more();
      request_.exemplars.push_back(std::move(entry));
    }
  }

  static Point point_of(const std::vector<int>& numbers, int otherwise) {
    Point point{otherwise, otherwise, otherwise};
    for (std::size_t axis = 0; axis < numbers.size(); ++axis) point[axis] = numbers[axis];
    return point;
  }

  /// Reads a place of the map; numbers below 0 count from its far side.
  static Point place_of(JsonObject& object, const char* member) {
    return point_of(object.numbers(member, -(1 << 20), 2, 3), 0);
  }

  static std::size_t axis_of(JsonObject& object, const char* member, const std::string& letter) {
    const std::size_t axis = std::string("xyz").find(letter);
    if (letter.size() != 1 || axis == std::string::npos) {
      object.fail(member, "names other axes than x, y and z");
    }
    return axis;
  }

  /// Reads a list of axes, or true for all of them.
  static std::array<bool, kAxes> axes_of(JsonObject& object, const char* member) {
    std::array<bool, kAxes> axes{};
    if (object.at(member).is_boolean()) {
      axes.fill(object.flag(member));
      return axes;
    }
    for (const std::string& axis : object.texts(member)) axes[axis_of(object, member, axis)] = true;
    return axes;
  }

  void read_map(JsonObject& file) {
    if (file.has("size")) request_.size = point_of(file.numbers("size", 1, 2, 3), 1);
    if (file.has("periodic")) request_.periodic = axes_of(file, "periodic");
  }

  void read_weights(JsonObject& file) {
    read_kind_of_weights(file);
    read_pairs(file);
    if (file.has("symmetry")) read_symmetry(file);
    if (file.has("epsilon")) request_.epsilon = file.real("epsilon", 0, 1000);
    if (!file.has("shapes")) return;
    const auto& list = file.at("shapes");
    if (!list.is_array()) file.fail("shapes", "is no list");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const nlohmann::json as_object{{"size", list[i]}};
      JsonObject object(name_, as_object, fmt::format("shapes[{}]", i));
      request_.shapes.push_back({point_of(object.numbers("size", 1, 2, 3), 1)});
    }
  }

  /// "fitted", "step", or the name of a file that --learn wrote.
  void read_kind_of_weights(JsonObject& file) {
    const std::string kind = file.text_or("weights", "fitted");
    if (kind == "fitted") return;
    request_.weights = kind == "step" ? WeightsKind::kStep : WeightsKind::kRead;
    if (kind == "step") return;
    if (!kind.ends_with(".json"))
      file.fail("weights", "is neither \"fitted\" nor \"step\" nor the name of a .json file with weights");
    request_.weights_file = path(file, "weights");
  }

  void read_symmetry(JsonObject& file) {
    const auto group = symmetry_named(file.text("symmetry"));
    if (!group) file.fail("symmetry", "is none of \"none\", \"mirror\", \"4\" and \"8\"");
    request_.symmetry = *group;
  }

  void read_pairs(JsonObject& file) {
    if (!file.has("pairs")) return;
    const std::string from = file.text("pairs");
    if (from != "seen" && from != "labels" && from != "both")
      file.fail("pairs", "is neither \"seen\" nor \"labels\" nor \"both\"");
    request_.pairs = from == "seen"     ? PairsFrom::kSeen
                     : from == "labels" ? PairsFrom::kLabels
                                        : PairsFrom::kBoth;
  }

  void read_pin(JsonObject& object) {
    PinEntry pin;
    pin.from = place_of(object, "at");
    const bool has_end = object.has("to");
    const Point size = object.has("size") ? point_of(object.numbers("size", 1, 2, 3), 1) : Point{1, 1, 1};
    const Point last = has_end ? place_of(object, "to") : Point{};
    if (has_end && object.has("size")) object.fail("to", "says what 'size' says; one of both is read");
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      pin.to[axis] = has_end ? last[axis] + 1 : pin.from[axis] + size[axis];
    if (object.has("every")) pin.every = point_of(object.numbers("every", 0, 2, 3), 0);
    pin.tiles = object.texts("tiles");
    pin.where = object.where();
    object.require_no_more();
    request_.pins.push_back(std::move(pin));
  }

  void read_border(JsonObject& object) {
    BorderEntry border{object.texts("side"), object.texts("tiles")};
    if (object.has("except")) border.except = object.texts("except");
    border.inside = object.flag("inside");
    border.forbidden = object.flag("forbid");
    border.where = object.where();
    object.require_no_more();
    request_.borders.push_back(std::move(border));
  }

  /// Reads the tiles of a network, and which of their sides are open.
  static ConnectedEntry network_of(JsonObject& object) {
    ConnectedEntry entry;
    if (object.has("tiles")) entry.tiles = object.texts("tiles");
    if (object.has("open")) entry.open = pairs_of_texts(object, "open", "tiles and their open sides");
    if (object.has("edges")) entry.edges = object.texts("edges");
    entry.where = object.where();
    return entry;
  }

  /// Reads an object whose members are all texts.
  static std::vector<std::pair<std::string, std::string>> pairs_of_texts(JsonObject& object,
                                                                         const char* member,
                                                                         const std::string& of_what) {
    const auto& members = object.at(member);
    if (!members.is_object()) object.fail(member, "is no object of " + of_what);
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& [name, text] : members.items()) {
      if (!text.is_string()) object.fail(member, fmt::format("has '{}', which is no text", name));
      pairs.emplace_back(name, text.get<std::string>());
    }
    return pairs;
  }

  void read_connected(JsonObject& object) {
    request_.connected.push_back(network_of(object));
    object.require_no_more();
  }

  void read_acyclic(JsonObject& object) {
    request_.acyclic.push_back(network_of(object));
    object.require_no_more();
  }

  void read_loops(JsonObject& object) {
    request_.loops.push_back(network_of(object));
    object.require_no_more();
  }

  /// {"left", "right"}, {"top", "bottom"} or {"below", "above"}: any of the one list before any of the other.
  void read_adjacency(JsonObject& object) {
    static constexpr std::array<std::array<const char*, 2>, kAxes> kSides{
        {{"left", "right"}, {"top", "bottom"}, {"below", "above"}}};
    AdjacencyEntry entry;
    while (entry.axis + 1 < kAxes && !object.has(kSides.at(entry.axis)[0]) &&
           !object.has(kSides.at(entry.axis)[1]))
      ++entry.axis;
    entry.first = object.texts(kSides.at(entry.axis)[0]);
    entry.second = object.texts(kSides.at(entry.axis)[1]);
    entry.where = object.where();
    object.require_no_more();
    request_.adjacencies.push_back(std::move(entry));
  }

  void read_run(JsonObject& object) {
    RunEntry run;
    run.tiles = object.texts("tiles");
    run.most = static_cast<std::uint64_t>(object.number("most", 0, INT32_MAX));
    if (object.has("axis")) run.axis = axis_of(object, "axis", object.text("axis"));
    run.where = object.where();
    object.require_no_more();
    request_.runs.push_back(std::move(run));
  }

  void read_distance(JsonObject& object) {
    DistanceEntry distance;
    distance.tiles = object.texts("tiles");
    if (object.has("others")) distance.others = object.texts("others");
    distance.least = static_cast<int>(object.number("least", 1, 1 << 20));
    distance.where = object.where();
    object.require_no_more();
    request_.distances.push_back(std::move(distance));
  }

  void read_path(JsonObject& object) {
    PathEntry path;
    path.from = place_of(object, "from");
    path.to = place_of(object, "to");
    path.over = network_of(object);
    path.where = object.where();
    object.require_no_more();
    request_.paths.push_back(std::move(path));
  }

  void read_keys(JsonObject& object) {
    KeysEntry keys;
    keys.from = place_of(object, "from");
    keys.over = network_of(object);
    keys.doors = pairs_of_texts(object, "doors", "doors and their keys");
    keys.where = object.where();
    object.require_no_more();
    request_.keys.push_back(std::move(keys));
  }

  void read_mirror(JsonObject object) {
    MirrorEntry mirror;
    mirror.axis = axis_of(object, "axis", object.text("axis"));
    if (object.has("partners"))
      mirror.partners = pairs_of_texts(object, "partners", "tiles and their mirror images");
    mirror.where = object.where();
    object.require_no_more();
    request_.mirror = std::move(mirror);
  }

  void read_count(JsonObject& object) {
    CountEntry entry;
    entry.tiles = object.texts("tiles");
    if (object.has("least")) entry.least = static_cast<std::uint64_t>(object.number("least", 0, INT64_MAX));
    if (object.has("most")) entry.most = static_cast<std::uint64_t>(object.number("most", 0, INT64_MAX));
    if (object.has("least_share")) entry.least_share = object.real("least_share", 0, 1);
    if (object.has("most_share")) entry.most_share = object.real("most_share", 0, 1);
    entry.where = object.where();
    object.require_no_more();
    request_.counts.push_back(std::move(entry));
  }

  void read_zones(JsonObject object) {
    if (object.has("from")) return read_districts(object);
    ZoneMap zones;
    zones.file = path(object, "mask");
    for (JsonObject& each : object.objects("legend")) {
      zones.legend.emplace_back(color_of(each, "color"), each.text("zone"));
      each.require_no_more();
    }
    object.require_no_more();
    request_.zones = std::move(zones);
  }

  void read_districts(JsonObject& object) {
    if (nesting_ == kMostNesting)
      object.fail("from", fmt::format("is a problem file in another one, more than {} deep", kMostNesting));
    DistrictsEntry districts;
    const fs::path coarse = path(object, "from");
    districts.coarse =
        std::make_shared<Request>(RequestReader(coarse, read_bytes(coarse), nesting_ + 1).read());
    if (object.has("scale")) districts.scale = static_cast<int>(object.number("scale", 1, 1024));
    object.require_no_more();
    request_.districts = std::move(districts);
  }

  std::string name_;
  fs::path folder_;
  int nesting_;
  nlohmann::json json_;
  Request request_;
};

}  // namespace

Request read_request(const fs::path& path) { return parse_request(path, read_bytes(path)); }

Request parse_request(const fs::path& path, const std::string& text) {
  return RequestReader(path, text, 0).read();
}

}  // namespace solitaire::tiles
