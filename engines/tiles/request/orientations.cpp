#include "engines/tiles/request/orientations.h"

#include <algorithm>
#include <stdexcept>

#include "engines/tiles/request/request_error.h"
#include "engines/tiles/request/tile_images.h"

namespace solitaire::tiles {
namespace {

Size image_of(const Size& size, const Symmetry& symmetry) {
  return symmetry.swaps_axes() ? Size{{size.height(), size.width(), size.depth()}} : size;
}

/// Returns where a place of a grid comes to lie.
Point image_of(Point at, Size size, const Symmetry& symmetry) {
  if (symmetry.mirrored) at[0] = size.width() - 1 - at[0];
  for (int turn = 0; turn < symmetry.turns; ++turn) {
    at = {size.height() - 1 - at[1], at[0], at[2]};
    size = {{size.height(), size.width(), size.depth()}};
  }
  return at;
}

Exemplar image_of(const Exemplar& exemplar, const Symmetry& symmetry, TileImages& images) {
  Exemplar image = exemplar;
  if (symmetry.swaps_axes()) std::swap(image.periodic[0], image.periodic[1]);
  image.grid = Grid(image_of(exemplar.grid.size, symmetry));
  for_each_point(exemplar.grid.size, [&](const Point& at) {
    const Tile tile = exemplar.grid.at(at);
    if (tile == kHole) return;
    image.grid[image.grid.size.site(image_of(at, exemplar.grid.size, symmetry))] =
        images.image(tile, symmetry).value_or(kHole);
  });
  return image;
}

ListedPairs image_of(const ListedPairs& pairs, const Symmetry& symmetry, TileImages& images) {
  const auto image_of_set = [&](const TileMask& tiles) {
    TileMask result;
    tiles.for_each([&](Tile tile) {
      if (const auto image = images.image(tile, symmetry)) result.insert(*image);
    });
    return result;
  };
  Point step{};
  step[pairs.axis] = 1;
  step = symmetry.apply(step);
  const auto axis =
      static_cast<std::size_t>(std::ranges::find_if(step, [](int n) { return n != 0; }) - step.begin());
  const TileMask first = image_of_set(pairs.first), second = image_of_set(pairs.second);
  return step[axis] > 0 ? ListedPairs{axis, first, second} : ListedPairs{axis, second, first};
}

bool has_no_tiles(const Exemplar& exemplar) {
  return std::ranges::all_of(exemplar.grid.tiles, [](Tile tile) { return tile == kHole; });
}

void add_image(const Symmetry& symmetry, const std::vector<Exemplar>& exemplars,
               const std::vector<ListedPairs>& listed, TileImages& images, Style& style) {
  for (const Exemplar& exemplar : exemplars) {
    Exemplar image = image_of(exemplar, symmetry, images);
    if (!has_no_tiles(image)) style.exemplars.push_back(std::move(image));
  }
  for (const ListedPairs& pairs : listed) {
    ListedPairs image = image_of(pairs, symmetry, images);
    if (!image.first.empty() && !image.second.empty()) style.listed.push_back(image);
  }
}

}  // namespace

void add_orientations(const Request& request, Style& style) {
  const std::vector<Exemplar> exemplars = style.exemplars;
  const std::vector<ListedPairs> listed = style.listed;
  TileImages images(style.tileset, request.unknown_images);
  const std::vector<Symmetry> members = request.symmetry.members();
  try {
    for (const Symmetry& symmetry : members) {
      if (!symmetry.is_identity()) add_image(symmetry, exemplars, listed, images, style);
    }
  } catch (const std::length_error& error) {
    throw RequestError(error.what());
  }
  if (members.size() > 1 && style.exemplars.size() == exemplars.size() &&
      style.listed.size() == listed.size()) {
    throw RequestError(
        "the symmetry of exemplars teaches nothing, since of no tile it is known how it looks when it is "
        "turned; "
        "give tiles icons, a \"symmetry\", or the names of what they are \"turned\" and \"mirrored\"");
  }
}

}  // namespace solitaire::tiles
