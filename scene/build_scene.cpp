#include "scene/build_scene.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <utility>

#include "scene/error.h"
#include "scene/names.h"
#include "scene/openings.h"
#include "scene/thing_options.h"

namespace solitaire {
namespace {

constexpr double kThinnest = 0.001;  // metres; a size of 0 would leave a node that cannot be inverted
constexpr double kLargest = 1e7;     // metres; beyond it 32-bit floats no longer tell centimetres apart

/// Returns the lowest and the highest of the outline's points, along both axes.
Box3 extent_of(const Outline& outline) {
  Box3 extent;
  for (const auto& [x, y] : outline) extent.include({x, y, 0});
  return extent;
}

/// Returns the size that a thing has if its program says nothing: width, depth, height.
Vec3 own_size(const ThingOptions& options, const Asset* asset, double unit) {
  Vec3 size = asset ? natural_size(*asset) : Vec3{unit, unit, unit};
  if (!options.outline.empty()) {
    const Vec3 extent = extent_of(options.outline).size();
    size = {extent[0] * unit, extent[1] * unit, options.extrude * unit};
  }
  for (double& length : size) length *= options.scale;
  return size;
}

/// Returns the size that the program asks for: width, depth, height.
Vec3 wanted_size(const PlacedThing& thing, const ThingOptions& options, const Asset* asset, double unit) {
  const auto& wanted = thing.size;
  if (!wanted.empty() && options.scale != 1) refuse(thing, "'scale' stands beside 'size': give one of them");
  if (!wanted.empty() && wanted.size() != 2 && wanted.size() != 3)
    refuse(thing, "size needs [w, d] or [w, d, h]");
  if (!wanted.empty() && !options.outline.empty())
    refuse(thing, "'outline' stands beside 'size': it says how large the thing is");
  if (asset && !options.outline.empty()) refuse(thing, "'outline' is for things that no model shows");
  if (wanted.empty()) return own_size(options, asset, unit);
  Vec3 size{wanted[0] * unit, wanted[1] * unit, 0};
  if (wanted.size() == 3) {
    size[2] = wanted[2] * unit;
  } else {
    size[2] = asset ? natural_size(*asset)[2] : std::min(size[0], size[1]);
  }
  for (double& length : size) {
    if (!(length >= 0 && length <= kLargest)) refuse(thing, "size is negative, not finite or beyond measure");
    length = std::max(length, kThinnest);
  }
  return size;
}

/// Returns the size that the thing has where this is wanted. A model that keeps its proportions is as large
/// as the wanted ground allows, unless its height is wanted, too.
Vec3 fitted_size(const PlacedThing& thing, const Asset* asset, const Vec3& wanted) {
  if (!asset || !asset->keeps_proportions || thing.size.size() != 2) return wanted;
  const Vec3 natural = natural_size(*asset);
  const double scale = std::min(wanted[0] / natural[0], wanted[1] / natural[1]);
  return {natural[0] * scale, natural[1] * scale, natural[2] * scale};
}

PlacedBox place_box(const PlacedThing& thing, const ThingOptions& options, const Asset* asset, double unit) {
  PlacedBox box;
  const Vec3 wanted = wanted_size(thing, options, asset, unit);
  box.size = fitted_size(thing, asset, wanted);
  const int turn = ((thing.turn % 4) + 4) % 4;
  box.angle = thing.angle ? *thing.angle : turn * 90.0;
  box.pitch = options.pitch;
  box.roll = options.roll;
  const Vec3 first = options.outline.empty() ? Vec3{} : extent_of(options.outline).low;
  const bool swapped = !thing.angle && turn % 2 == 1;
  const Vec3 half{wanted[swapped ? 1 : 0] / 2, wanted[swapped ? 0 : 1] / 2, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (thing.at[axis] + first[axis]) * unit;
    if (!(std::abs(low) <= kLargest)) refuse(thing, "at is not finite or beyond measure");
    box.center[axis] = low + half[axis];
  }
  if (!std::isfinite(box.angle)) refuse(thing, "angle is not finite");
  return box;
}

Box3 model_box(const Asset* asset) { return asset ? asset->box : unit_box(); }

double stretch(double wanted, double natural) { return natural > 0 ? wanted / natural : 1; }

Transform node_transform(const PlacedBox& box, const Asset* asset) {
  const int front_turns = asset ? asset->front_turns : 0;
  const Box3 model = model_box(asset);
  const Vec3 natural = model.size();
  const bool swapped = front_turns % 2 == 1;
  Transform transform;
  transform.rotation = orientation(box, front_turns * 90);
  transform.scale = {stretch(box.size[swapped ? 1 : 0], natural[0]), stretch(box.size[2], natural[1]),
                     stretch(box.size[swapped ? 0 : 1], natural[2])};
  const Vec3 model_base{(model.low[0] + model.high[0]) / 2, model.low[1], (model.low[2] + model.high[2]) / 2};
  const Vec3 moved = to_affine(transform).apply(model_base);
  const Vec3 base{box.center[0], box.center[2], -box.center[1]};
  for (int axis = 0; axis < 3; ++axis) transform.translation[axis] = rounded(base[axis] - moved[axis], 9);
  return transform;
}

std::optional<Paint> material_of(const PlacedThing& thing, const ThingOptions& options) {
  if (!options.material) return std::nullopt;
  const std::string& text = *options.material;
  const auto material =
      text.starts_with('"') ? material_named(text.substr(1, text.size() - 2)) : std::nullopt;
  if (!material)
    refuse(thing,
           fmt::format("there is no material {}; there are {}", text, fmt::join(material_names(), ", ")));
  return material;
}

/// Returns what the thing is painted with. A colour beside a material tints it: the finish stays.
std::optional<Paint> paint_of(const PlacedThing& thing, const ThingOptions& options, const Asset* asset) {
  if (thing.marked) return Paint{"", thing.color.value_or(Color{1, 0, 0}), Paint::Finish{}, false, true};
  std::optional<Paint> paint = material_of(thing, options);
  if (!paint && (thing.color || !asset)) paint = Paint{"", color_of_name(thing.asset), std::nullopt};
  if (thing.color) paint->color = *thing.color;
  if (thing.color && asset && !options.material) paint->tints = options.tint;
  return paint;
}

SceneObject make_object(PlacedThing given, double unit, AssetLibrary& assets) {
  SceneObject object;
  object.thing = std::move(given);
  const PlacedThing& thing = object.thing;
  const ThingOptions options = read_options(thing);
  try {
    object.asset = assets.find(thing.asset, thing.folder);
  } catch (const SceneError& error) {
    refuse(thing, error.what());
  }
  object.box = place_box(thing, options, object.asset, unit);
  object.paint = paint_of(thing, options, object.asset);
  object.color = object.paint ? object.paint->over(object.asset ? object.asset->color : Color{1, 1, 1})
                              : object.asset->color;
  object.parents = options.parents.empty() ? thing.groups : options.parents;
  object.label = options.label;
  if (!options.outline.empty()) object.outline = in_unit_square(options.outline);
  object.node_transform = node_transform(object.box, object.asset);
  return object;
}

/// Builds the tree of the program's calls, or of the parents that it names, in the order of its run.
class TreeBuilder {
 public:
  explicit TreeBuilder(Scene& scene) : scene_(scene) {
    for (const SceneObject& object : scene.objects) names_.announce(plain_name(object));
    scene_.nodes.push_back({names_.take(scene.title), {}, {}});
  }

  void add(std::size_t object) {
    std::size_t parent = 0;
    for (const std::string& step : scene_.objects[object].parents) parent = group(parent, step);
    scene_.nodes[append(parent, plain_name(scene_.objects[object]))].object = object;
  }

 private:
  std::size_t group(std::size_t parent, const std::string& call) {
    const auto [place, is_new] = groups_.try_emplace({parent, call}, scene_.nodes.size());
    if (is_new) append(parent, call);
    return place->second;
  }

  std::size_t append(std::size_t parent, const std::string& name) {
    const std::size_t index = scene_.nodes.size();
    scene_.nodes.push_back({names_.take(name), {}, {}});
    scene_.nodes[parent].children.push_back(index);
    return index;
  }

  Scene& scene_;
  UniqueNames names_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> groups_;
};

}  // namespace

Scene build_scene(std::vector<PlacedThing> things, double unit, const std::string& title,
                  AssetLibrary& assets) {
  if (!(unit > 0 && unit <= kLargest)) throw SceneError("the unit must be a positive number of metres");
  Scene scene;
  scene.title = title;
  scene.objects.reserve(things.size());
  for (PlacedThing& thing : things) scene.objects.push_back(make_object(std::move(thing), unit, assets));
  TreeBuilder tree(scene);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) tree.add(i);
  make_openings(scene);
  return scene;
}

}  // namespace solitaire
