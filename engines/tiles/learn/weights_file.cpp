#include "engines/tiles/learn/weights_file.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engines/tiles/read/file.h"
#include "engines/tiles/read/json_object.h"

namespace solitaire::tiles {
namespace {

using Json = nlohmann::ordered_json;

/// No weight is larger or smaller: products of them stay within the range of a double.
constexpr double kLargestWeight = 20;
constexpr int kLongestSide = 16;

Json weights_of(const SoftShape& shape, std::size_t patch) {
  Json weights = Json::array();
  for (const std::vector<double>& zone : shape.log_weights) weights.push_back(zone[patch]);
  return weights;
}

/// Reads the weights of one shape.
class ShapeReader {
 public:
  ShapeReader(JsonObject& object, const Style& style) : object_(object), style_(style) {}

  SoftShape read() {
    const std::vector<int> size = object_.numbers("size", 1, 2, 3);
    const Size shape{{size[0], size[1], size.size() > 2 ? size[2] : 1}};
    for (const int extent : shape.extent) {
      if (extent > kLongestSide)
        object_.fail("size", fmt::format("has a side of more than {} tiles", kLongestSide));
    }
    if (shape.volume() > PatchIndex::most_sites(style_.tileset.size()))
      object_.fail("size",
                   fmt::format("has more than {} tiles", PatchIndex::most_sites(style_.tileset.size())));
    SoftShape soft{PatchIndex(shape, style_.tileset.size()),
                   std::vector<std::vector<double>>(style_.zones, std::vector<double>(1))};
    set(soft, 0, object_, "others");
    for (JsonObject& patch : object_.objects("patches")) {
      const std::uint32_t known = static_cast<std::uint32_t>(soft.patches.size());
      const std::uint32_t number = soft.patches.insert(code(patch, soft.patches));
      if (number <= known) patch.fail("tiles", "are a patch that stands in the list already");
      for (std::vector<double>& zone : soft.log_weights) zone.push_back(0);
      set(soft, number, patch, "weights");
      patch.require_no_more();
    }
    object_.require_no_more();
    return soft;
  }

 private:
  PatchCode code(JsonObject& patch, const PatchIndex& patches) const {
    const std::vector<std::string> names = patch.texts("tiles");
    if (names.size() != patches.shape().volume())
      patch.fail("tiles",
                 fmt::format("are {}, and the shape has {}", names.size(), patches.shape().volume()));
    PatchCode code = 0;
    for (std::size_t place = 0; place < names.size(); ++place) {
      const auto tile = style_.tileset.find(names[place]);
      if (!tile) patch.fail("tiles", fmt::format("name '{}', which is no tile", names[place]));
      code |= PatchCode{*tile} << (place * patches.bits());
    }
    return code;
  }

  void set(SoftShape& soft, std::uint32_t number, JsonObject& from, const char* member) const {
    const nlohmann::json& weights = from.at(member);
    if (!weights.is_array() || weights.size() != style_.zones)
      from.fail(member, fmt::format("is no list of {} numbers, one for each zone", style_.zones));
    for (std::size_t zone = 0; zone < style_.zones; ++zone) {
      const bool fits = weights[zone].is_number() && std::abs(weights[zone].get<double>()) <= kLargestWeight;
      if (!fits) from.fail(member, fmt::format("has what is no number from -{0} to {0}", kLargestWeight));
      soft.log_weights[zone][number] = weights[zone].get<double>();
    }
  }

  JsonObject& object_;
  const Style& style_;
};

}  // namespace

std::string write_weights(const Style& style) {
  std::string text = "{\"shapes\": [";
  for (const SoftShape& shape : style.shapes) {
    text += fmt::format("{}\n {{\"size\": {}, \"others\": {}, \"patches\": [", text.back() == '[' ? "" : ",",
                        Json(shape.patches.shape().extent).dump(), weights_of(shape, 0).dump());
    for (std::uint32_t number = 1; number <= shape.patches.size(); ++number) {
      Json names = Json::array();
      for (std::size_t place = 0; place < shape.patches.shape().volume(); ++place)
        names.push_back(style.tileset[shape.patches.tile(shape.patches.code(number), place)].name);
      const Json patch{{"tiles", std::move(names)}, {"weights", weights_of(shape, number)}};
      text += fmt::format("{}\n  {}", number == 1 ? "" : ",", patch.dump());
    }
    text += "]}";
  }
  return text + "\n]}\n";
}

void read_weights(const std::filesystem::path& path, Style& style) {
  const std::string file = path.string();
  const nlohmann::json json = parse_json(file, read_bytes(path));
  JsonObject object(file, json, "");
  for (JsonObject& shape : object.objects("shapes")) style.shapes.push_back(ShapeReader(shape, style).read());
  object.require_no_more();
}

}  // namespace solitaire::tiles
