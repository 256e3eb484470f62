#include "engines/tiles/model/voxel_model.h"

#include "engines/tiles/model/palette.h"

namespace solitaire::tiles {
namespace {

/// Returns a model of another size, whose voxels have moved to where `place(at)` says.
template <class Place>
VoxelModel moved(const VoxelModel& model, const Size& size, Place place) {
  VoxelModel result(size);
  result.palette = model.palette;
  for_each_point(model.size, [&](const Point& at) { result.colors[size.site(place(at))] = model.at(at); });
  return result;
}

}  // namespace

Rgba VoxelModel::color(std::uint8_t number) const {
  if (number == 0) return {};
  return palette.at(number) ? *palette.at(number) : palette_color(number);
}

VoxelModel turned(const VoxelModel& model) {
  const Size size{{model.size.height(), model.size.width(), model.size.depth()}};
  return moved(model, size, [&](const Point& at) { return Point{size.width() - 1 - at[1], at[0], at[2]}; });
}

VoxelModel mirrored(const VoxelModel& model) {
  return moved(model, model.size, [&](const Point& at) {
    return Point{model.size.width() - 1 - at[0], at[1], at[2]};
  });
}

Picture seen_from_above(const VoxelModel& model) {
  Picture picture(model.size.width(), model.size.height());
  for_each_point(model.size, [&](const Point& at) {  // from below, so that what is above comes last
    if (model.at(at) != 0) picture.at(at[0], at[1]) = model.color(model.at(at));
  });
  return picture;
}

std::vector<std::uint8_t> layer_of(const VoxelModel& model, std::size_t axis, bool last) {
  const int across = last ? model.size.extent[axis] - 1 : 0;
  std::vector<std::uint8_t> colors;
  for_each_point(model.size, [&](const Point& at) {
    if (at[axis] == across) colors.push_back(model.at(at));
  });
  return colors;
}

}  // namespace solitaire::tiles
