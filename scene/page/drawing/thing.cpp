#include "scene/page/drawing/thing.h"

#include <algorithm>
#include <fmt/format.h>

#include "scene/page/drawing/paper.h"
#include "scene/text.h"

namespace solitaire {
namespace {

std::string height_line(const PlacedBox& box) {
  const std::string high = length_text(box.size[2]) + " high";
  return box.center[2] == 0 ? high : fmt::format("{}, from {}", high, length_text(box.center[2]));
}

std::string broken_line(const PlacedThing& thing) {
  const auto broken =
      std::ranges::find(thing.extras, "broken", [](const auto& extra) { return extra.first; });
  return broken == thing.extras.end() ? "" : "\nbroken: " + broken->second;
}

}  // namespace

std::vector<NamedObject> named_objects(const Scene& scene, const std::vector<std::size_t>& indices) {
  std::vector<bool> wanted(scene.objects.size());
  for (const std::size_t index : indices) wanted[index] = true;
  std::vector<NamedObject> named;
  for (const SceneNode& node : scene.nodes) {
    if (node.object && wanted[*node.object]) named.push_back({&scene.objects[*node.object], &node.name});
  }
  return named;
}

std::vector<NamedObject> named_objects(const Scene& scene) {
  std::vector<NamedObject> named;
  for (const SceneNode& node : scene.nodes) {
    if (node.object) named.push_back({&scene.objects[*node.object], &node.name});
  }
  return named;
}

std::string thing_element(const SceneObject& object, std::string_view unique_name, std::string_view content) {
  const std::string address = escape_markup(object.thing.address);
  return fmt::format("<g data-address=\"{1}\"><title>{0}\n{1}\n{2}{3}</title>{4}</g>\n",
                     escape_markup(unique_name), address, height_line(object.box),
                     escape_markup(broken_line(object.thing)), content);
}

}  // namespace solitaire
