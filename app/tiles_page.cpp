#include "app/tiles_page.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/tiles_options.h"
#include "base/installation.h"
#include "scene/atomic_file.h"
#include "scene/gltf/writer.h"
#include "scene/text.h"

namespace solitaire::app {
namespace {

using Json = nlohmann::ordered_json;

/// Maps of more tiles are shown, and not compared place by place.
constexpr std::size_t kMostCompared = 5000;

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string address_of(const tiles::ShownTile& tile) {
  const auto [x, y, z] = tile.at;
  return z == 0 ? fmt::format("{},{}", x, y) : fmt::format("{},{},{}", x, y, z);
}

/// Returns {width, height} of a PNG: they stand at the same place in each, high bytes first.
std::pair<unsigned, unsigned> png_size(std::string_view png) {
  const auto number_at = [&](std::size_t at) {
    unsigned number = 0;
    for (std::size_t i = at; i < at + 4; ++i) number = number << 8U | static_cast<unsigned char>(png.at(i));
    return number;
  };
  return {number_at(16), number_at(20)};
}

/// Returns a drawing that consists of the picture in a file beside the page.
Json drawing_of(const std::string& file, std::string_view png) {
  const auto [width, height] = png_size(png);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"Map\">"
      "<image href=\"{2}\" width=\"{0}\" height=\"{1}\"/></svg>",
      width, height, relative_link(file));
  return {{"kind", "picture"}, {"title", "Map"}, {"svg", std::move(svg)}};
}

Json choices_of(const std::vector<tiles::ShownTile>& tiles) {
  Json choices = Json::array();
  if (tiles.size() > kMostCompared) return choices;
  for (const tiles::ShownTile& tile : tiles)
    choices.push_back({{"at", address_of(tile)}, {"value", tile.name}});
  return choices;
}

}  // namespace

TilesPage::TilesPage(const Options& options, std::string stem)
    : options_(options), stem_(std::move(stem)), page_(options.output, find_data_folder() / "page") {}

void TilesPage::add(std::uint64_t number, const MapLook& look) {
  GalleryEntry entry;
  entry.index = number;
  entry.name = look.name;
  entry.picture = has_format("png") ? entry.name + ".png" : fmt::format("page/{}.png", entry.name);
  entry.has_sharp_pixels = true;
  entry.glb = file_of(entry.name, "glb");
  entry.json = file_of(entry.name, "json");
  const Json about{{"views", {drawing_of(entry.picture, look.png)}}, {"choices", choices_of(look.tiles)}};
  // What has no names cannot be clicked at.
  const SolutionFiles files =
      look.scene && (look.nodes == Nodes::kOneEach || look.nodes == Nodes::kInstances)
          ? page_.add(entry.name, &*look.scene,
                      look.glb.empty() ? glb_bytes(*look.scene, look.nodes) : look.glb, text_of(about))
          : page_.add(entry.name, nullptr, "", text_of(about));
  if (!has_format("png")) write_file_atomically(options_.output / entry.picture, look.png);
  if (look.tiles.size() <= kMostCompared) entry.choices = look.tiles.size();
  entry.facts = text_of({{"index", number}, {"script", files.script}});
  add_row(look.tiles);
  entries_.push_back(std::move(entry));
}

void TilesPage::close() const {
  if (entries_.empty()) return;
  GalleryInfo info{stem_,
                   fmt::format("{}", fmt::join(options_.tiles->job.inputs, ", ")),
                   std::to_string(options_.tiles->job.sampling.seed),
                   {}};
  page_.close(info, entries_,
              fmt::format("{{\"addresses\":{},\n\"solutions\":[{}]}}", text_of(Json(addresses_)), rows_));
}

bool TilesPage::has_format(const std::string& format) const {
  return std::ranges::count(options_.tiles->formats, format) > 0;
}

/// Returns the name of the map's file in a format, or "" if that was not asked for.
std::string TilesPage::file_of(const std::string& name, const std::string& format) const {
  return has_format(format) ? fmt::format("{}.{}", name, format) : "";
}

std::size_t TilesPage::position_of(const std::string& address) {
  const auto [place, added] = positions_.try_emplace(address, addresses_.size());
  if (added) addresses_.push_back(address);
  return place->second;
}

void TilesPage::add_row(const std::vector<tiles::ShownTile>& tiles) {
  Json row = Json::array();
  if (tiles.size() <= kMostCompared) {
    for (const tiles::ShownTile& tile : tiles) {
      row.push_back(position_of(address_of(tile)));
      row.push_back(tile.name);
    }
  }
  if (!entries_.empty()) rows_ += ",\n";
  rows_ += text_of(row);
}

}  // namespace solitaire::app
