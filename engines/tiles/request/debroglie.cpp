#include "engines/tiles/request/debroglie.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <map>

#include "engines/tiles/read/file.h"
#include "engines/tiles/read/lenient_json.h"
#include "engines/tiles/request/debroglie_words.h"

namespace solitaire::tiles {

namespace fs = std::filesystem;

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

namespace {

/// Returns the name of the tile that is turned the other way: "wall!270" for "wall!90", "wall!x90" for
/// "wall!x270".
std::string turned_the_other_way(const std::string& name) {
  const std::size_t sign = name.rfind('!');
  if (sign == std::string::npos) return name;
  const std::size_t from = name.find_first_not_of("!x", sign);
  const std::string turn = from == std::string::npos ? "" : name.substr(from);
  return turn == "90" ? name.substr(0, from) + "270" : turn == "270" ? name.substr(0, from) + "90" : name;
}

}  // namespace

std::string debroglie_tile(const DebroglieMap& map, JsonObject& object, const char* member,
                           const nlohmann::json& value) {
  if (value.is_number_integer()) return value.dump();
  if (!value.is_string()) object.fail(member, "has what is neither the name nor the number of a tile");
  std::string name = value.get<std::string>();
  if (name.starts_with('#')) name = in_small_letters(std::move(name));
  if (name.ends_with("!x0")) name.pop_back();
  if (name.ends_with("!0")) name.resize(name.size() - 2);
  return map.is_flipped ? turned_the_other_way(name) : name;
}

std::vector<std::string> debroglie_tiles(const DebroglieMap& map, JsonObject& object, const char* tiles,
                                         const char* tile) {
  if (object.has(tile)) return {debroglie_tile(map, object, tile, object.at(tile))};
  const nlohmann::json& list = object.at(tiles);
  if (!list.is_array()) object.fail(tiles, "is no list of tiles");
  std::vector<std::string> names;
  for (const nlohmann::json& each : list) names.push_back(debroglie_tile(map, object, tiles, each));
  return names;
}

namespace {

/// What is said of a tile of the sample.
struct TileData {
  std::string turned, mirrored, upside_down;  // what it becomes
  double bias = 1;
  std::string where;  // it is said
};

/// Reads one configuration.
class DebroglieReader {
 public:
  DebroglieReader(const fs::path& path, const std::string& text)
      : name_(path.string()),
        folder_(path.parent_path()),
        json_(parse_json(name_, strict_json(text))),
        file_(name_, json_, "") {}

  Request read() {
    // What it says of the search and of its own output has no meaning here.
    for (const char* member : {"$schema", "dest", "backtrack", "animate", "comment"}) file_.has(member);
    read_source();
    read_symmetry();
    read_size();
    read_periodic();
    read_model();
    read_tiles();
    read_adjacencies();
    if (file_.has("ground"))
      add_debroglie_ground(debroglie_tile(map_, file_, "ground", file_.at("ground")), name_ + ": 'ground'",
                           map_, request_);
    for (JsonObject& each : file_.objects("constraints")) add_debroglie_constraint(each, map_, request_);
    file_.require_no_more();
    return std::move(request_);
  }

 private:
  /// Returns a file in the base folder or below.
  fs::path path(JsonObject& object, const char* member) const {
    const fs::path relative = (base_ / object.text(member)).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..")
      object.fail(member, "is no path within the folder of the configuration");
    return folder_ / relative;
  }

  void read_source() {
    if (file_.has("baseDirectory")) base_ = file_.text("baseDirectory");
    const std::string type = in_small_letters(file_.text_or("srcType", ""));
    if (!type.empty() && type != "sample" && type != "bitmapset" && type != "voxset")
      file_.fail("srcType", "is none of sample, bitmapSet and voxSet");
    has_models_ = map_.is_flipped = map_.has_layers = type == "voxset";
    if (!file_.has("src")) return;
    ExemplarEntry sample;
    sample.file = path(file_, "src");
    const std::string ending = sample.file.extension().string();
    if (ending != ".png" && ending != ".tmx" && ending != ".tmj" && ending != ".tsx" && ending != ".tsj" &&
        ending != ".vox")
      file_.fail("src", "is no .png, .tmx, .tsx or .vox");
    sample.empty = "empty";
    map_.is_flipped = map_.has_layers = ending == ".vox";
    request_.exemplars.push_back(std::move(sample));
  }

  void read_symmetry() {
    SymmetryGroup& group = request_.symmetry;
    if (file_.has("symmetry")) {
      const auto count = static_cast<int>(file_.number("symmetry", 1, 8));
      group = count % 2 == 0 ? SymmetryGroup{count / 2, true} : SymmetryGroup{count, false};
    }
    if (file_.has("rotationalSymmetry"))
      group.turns = static_cast<int>(file_.number("rotationalSymmetry", 1, 4));
    if (file_.has("reflectionalSymmetry")) group.mirrored = file_.flag("reflectionalSymmetry");
    if (group.turns == 3)
      throw FileError(name_,
                      "asks for three rotations, which squares do not have; one, two and four are read");
    treatment_ = treatment_of(file_, "unchanged");
    // A tile with a picture of its own says itself what it becomes.
    if (!request_.exemplars.empty()) {
      request_.unknown_images = treatment_ == "unchanged" ? UnknownImages::kItself
                                : treatment_ == "missing" ? UnknownImages::kNothing
                                                          : UnknownImages::kByLook;
    }
  }

  static std::string treatment_of(JsonObject& object, const std::string& otherwise) {
    const std::string treatment = object.text_or("rotationTreatment", otherwise);
    if (treatment != "unchanged" && treatment != "missing" && treatment != "generated")
      object.fail("rotationTreatment", "is none of missing, unchanged and generated");
    return treatment;
  }

  void read_size() {
    for (JsonObject& each : file_.objects("adjacencies"))
      map_.has_layers = map_.has_layers || each.has("above") || each.has("below");
    if (map_.has_layers) map_.size[2] = 48;
    static constexpr std::array<const char*, kAxes> kNames{"width", "height", "depth"};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!file_.has(kNames.at(axis))) continue;
      const auto extent = static_cast<int>(file_.number(kNames.at(axis), 1, 1 << 20));
      if (axis < 2 || map_.has_layers) map_.size[axis] = extent;
    }
    request_.size = map_.size;
  }

  /// Reads a flag for all axes, and those for each; only axes that the map has count.
  std::array<bool, kAxes> axes_of(const std::string& member) {
    std::array<bool, kAxes> axes{};
    axes.fill(file_.flag(member.c_str()));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const std::string one = member + "XYZ"[axis];
      if (file_.has(one.c_str())) axes[axis] = file_.flag(one.c_str());
    }
    axes[2] = axes[2] && map_.has_layers;
    return axes;
  }

  void read_periodic() {
    request_.periodic = axes_of("periodic");
    const auto input = axes_of("periodicInput");
    for (ExemplarEntry& sample : request_.exemplars) sample.periodic = input;
  }

  void read_model() {
    if (!file_.has("model")) return;
    JsonObject model(name_, file_.at("model"), "model");
    const std::string type = model.text("type");
    if (type == "overlapping") {
      read_overlapping(model);
    } else if (type != "adjacent") {
      model.fail("type", "is neither adjacent nor overlapping");
    }
    model.require_no_more();
  }

  void read_overlapping(JsonObject& model) {
    Point extent{2, 2, 2};
    if (model.has("n")) extent.fill(static_cast<int>(model.number("n", 1, 16)));
    static constexpr std::array<const char*, kAxes> kNames{"nX", "nY", "nZ"};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (model.has(kNames.at(axis))) extent[axis] = static_cast<int>(model.number(kNames.at(axis), 1, 16));
    }
    if (!map_.has_layers) extent[2] = 1;
    request_.shapes = {{{1, 1, 1}}, {{2, 1, 1}}, {{1, 2, 1}}, {extent}};
    request_.notes.push_back(
        fmt::format("{}: the overlapping model is read as soft factors: patches of {}x{} that the sample has "
                    "are favoured, and "
                    "others are not forbidden",
                    name_, extent[0], extent[1]));
  }

  void read_tiles() {
    for (JsonObject& each : file_.objects("tiles")) {
      each.has("src") ? read_drawn_tile(each) : read_sampled_tile(each);
      each.require_no_more();
    }
    if (!request_.tiles.empty() && !request_.exemplars.empty())
      throw FileError(name_, "has a 'src' for the sample and for single tiles; one of both is read");
    for (const auto& [name, data] : data_) add_remark(name, data);
  }

  static double frequency_of(JsonObject& tile) {
    if (!tile.has("multiplyFrequency")) return 1;
    if (tile.at("multiplyFrequency").is_number()) return tile.real("multiplyFrequency", 1e-6, 1e6);
    const std::string text = tile.text("multiplyFrequency");
    double factor = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, factor);
    const bool in_percent = stop != end && *stop == '%' && stop + 1 == end;
    if (in_percent) factor /= 100;
    if (error != std::errc{} || !(stop == end || in_percent) || !(factor >= 1e-6 && factor <= 1e6))
      tile.fail("multiplyFrequency", "is no number from 0.000001 to 1000000, nor one with % behind it");
    return factor;
  }

  /// A tile with a picture of its own.
  void read_drawn_tile(JsonObject& object) {
    TileEntry tile;
    tile.name = debroglie_tile(map_, object, "value", object.at("value"));
    fs::path& file = has_models_ ? tile.voxel_file : tile.icon_file;
    file = path(object, "src");
    if (file.extension() != (has_models_ ? ".vox" : ".png"))
      object.fail("src", has_models_ ? "is no .vox, as all tiles of a voxSet are"
                                     : "is no .png; for .vox say \"srcType\": \"voxSet\"");
    tile.bias = frequency_of(object);
    tile.where = object.where();
    for (const char* member : {"rotateCw", "rotateCcw", "reflectX", "reflectY"}) {
      if (object.has(member))
        object.fail(member, "is read of the tiles of samples; say 'tileSymmetry' of a tile with a 'src'");
    }
    set_symmetry(object, tile);
    request_.tiles.push_back(std::move(tile));
  }

  void set_symmetry(JsonObject& object, TileEntry& tile) {
    const std::string treatment = treatment_of(object, treatment_);
    const std::string letter = object.text_or("tileSymmetry", "");
    const SymmetryGroup& group = request_.symmetry;
    if (group.turns == 1 && !group.mirrored) return;
    if (!letter.empty()) {
      tile.symmetry = letter_of(object, letter);
    } else if (treatment == "generated") {
      tile.symmetry = group.mirrored ? "F" : "L";
    } else if (treatment == "missing") {
      tile.rotates = false;
    } else {
      tile.turned = tile.mirrored = tile.name;
    }
  }

  static std::string letter_of(JsonObject& object, const std::string& letter) {
    static const std::map<std::string, std::string> kLetters{{"X", "X"}, {"I", "I"},   {"T", "T"},
                                                             {"E", "T"}, {"L", "L"},   {"Q", "L"},
                                                             {"F", "F"}, {"\\", "\\"}, {"Slash", "\\"}};
    const auto found = kLetters.find(letter);
    if (found == kLetters.end()) object.fail("tileSymmetry", "is none of X, I, T, E, L, Q, F and \\");
    return found->second;
  }

  /// Something about a tile of the sample.
  void read_sampled_tile(JsonObject& object) {
    const std::string name = debroglie_tile(map_, object, "value", object.at("value"));
    const auto image = [&](const char* member) {
      return object.has(member) ? debroglie_tile(map_, object, member, object.at(member)) : "";
    };
    const std::string letter = object.text_or("tileSymmetry", "");
    if (!letter.empty() && letter != "X")
      object.fail("tileSymmetry",
                  "is read of tiles with a 'src' of their own; X of all, and say 'rotateCw' and 'reflectX'");
    TileData& data = data_[name];
    data.bias = frequency_of(object);
    data.where = object.where();
    if (letter == "X") data.turned = data.mirrored = name;
    if (object.has("reflectX")) data.mirrored = image("reflectX");
    if (object.has("reflectY")) data.upside_down = image("reflectY");
    const char* const clockwise = map_.is_flipped ? "rotateCcw" : "rotateCw";
    const char* const back = map_.is_flipped ? "rotateCw" : "rotateCcw";
    if (object.has(clockwise)) data.turned = image(clockwise);
    if (object.has(back)) data_[image(back)].turned = name;
  }

  void add_remark(const std::string& name, const TileData& data) {
    RemarkEntry remark{name, data.bias, data.turned, data.mirrored, data.where.empty() ? name_ : data.where};
    // Left to right is upside down, turned by a half.
    if (remark.mirrored.empty() && !data.upside_down.empty())
      remark.mirrored = turned_by_half(data.upside_down);
    request_.remarks.push_back(std::move(remark));
  }

  std::string turned_by_half(const std::string& name) const {
    std::string now = name;
    for (int turn = 0; turn < 2; ++turn) {
      const auto found = data_.find(now);
      if (found != data_.end() && !found->second.turned.empty()) now = found->second.turned;
    }
    return now;
  }

  void read_adjacencies() {
    const double tolerance =
        file_.has("autoAdjacencyTolerance") ? file_.real("autoAdjacencyTolerance", 0, 1) : 0;
    if (file_.flag("autoAdjacency")) {
      if (request_.tiles.empty())
        file_.fail("autoAdjacency", "needs 'tiles' with a 'src' each, whose sides are compared");
      request_.icon_tolerance = tolerance;
    }
    for (JsonObject& each : file_.objects("adjacencies")) {
      AdjacencyEntry entry;
      const bool layers = each.has("above") || each.has("below"), down = each.has("up") || each.has("down");
      entry.axis = layers ? 2 : down ? 1 : 0;
      entry.first = debroglie_tiles(map_, each, layers ? "below" : down ? "up" : "left");
      entry.second = debroglie_tiles(map_, each, layers ? "above" : down ? "down" : "right");
      if (down && map_.is_flipped) std::swap(entry.first, entry.second);
      entry.where = each.where();
      each.has("comment");
      each.require_no_more();
      request_.adjacencies.push_back(std::move(entry));
    }
  }

  std::string name_;
  fs::path folder_, base_;
  nlohmann::json json_;
  JsonObject file_;
  DebroglieMap map_;
  bool has_models_ = false;               // of voxels, as tiles
  std::string treatment_;                 // of tiles of which nothing else is said
  std::map<std::string, TileData> data_;  // by tile of the sample
  Request request_;
};

}  // namespace

Request read_debroglie(const fs::path& path) { return parse_debroglie(path, read_bytes(path)); }

Request parse_debroglie(const fs::path& path, const std::string& text) {
  return DebroglieReader(path, text).read();
}

}  // namespace solitaire::tiles
