#include "scene/gltf/verify.h"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <tiny_gltf.h>
#include <unordered_set>
#include <utility>

#include "scene/error.h"
#include "scene/gltf/accessor_view.h"
#include "scene/gltf/asset_model.h"
#include "scene/gltf/reader.h"
#include "scene/text.h"

namespace solitaire {
namespace {

class Verifier {
 public:
  Verifier(const tinygltf::Model& model, const Scene& scene, Nodes nodes)
      : model_(model), scene_(scene), nodes_(nodes) {}

  void verify() {
    check_names();
    const auto roots = root_nodes(model_);
    require(roots.size() == (scene_.objects.empty() ? 3 : 4), "its root", scene_.title);
    require(node(roots[1]).camera == 0 && model_.cameras.size() == 1, "the camera", scene_.title);
    require(node(roots[2]).extensions.contains("KHR_lights_punctual"), "the sun", scene_.title);
    check_node(roots.front(), scene_.nodes.front());
  }

 private:
  static void require(bool holds, std::string_view what, const std::string& name) {
    if (!holds) throw SceneError(fmt::format("read back, {} of \"{}\" differs from the scene", what, name));
  }

  const tinygltf::Node& node(int index) const { return model_.nodes[static_cast<std::size_t>(index)]; }

  void check_names() const {
    std::unordered_set<std::string_view> names;
    for (const auto& each : model_.nodes) require(names.insert(each.name).second, "the name", each.name);
  }

  void check_node(int index, const SceneNode& expected) {
    require(node(index).name == expected.name, "the name", expected.name);
    if (expected.object) return check_object(index, scene_.objects[*expected.object], expected.name);
    const auto parts = parts_of(scene_, expected, nodes_);
    require(node(index).children.size() == parts.size(), "the number of children", expected.name);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const int child = node(index).children[i];
      if (parts[i].size() == 1) {
        check_node(child, scene_.nodes[parts[i].front()]);
      } else if (nodes_ == Nodes::kChunks) {
        check_merged(child, parts[i]);
      } else {
        check_instances(child, parts[i]);
      }
    }
  }

  void check_instances(int index, const std::vector<std::size_t>& instances) {
    const std::string& name = node(index).name;
    const std::vector<Transform> transforms = instance_transforms(model_, node(index));
    require(transforms.size() == instances.size(), "the number", name);
    if (nodes_ != Nodes::kPlainInstances) check_facts(index, instances);
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const SceneNode& expected = scene_.nodes[instances[i]];
      const SceneObject& object = scene_.objects[*expected.object];
      check_box(to_affine(transforms[i]), check_sharing(index, object, name).box, object, expected.name);
    }
  }

  /// All that were merged together fill the box that they fill in the scene.
  void check_merged(int index, const std::vector<std::size_t>& alike) const {
    const std::string& name = node(index).name;
    Box3 found, wanted;
    include(index, Affine{}, found);
    for (const std::size_t each : alike) {
      const Box3 box = bounds(scene_.objects[*scene_.nodes[each].object].box);
      wanted.include({box.low[0], box.low[2], -box.high[1]});
      wanted.include({box.high[0], box.high[2], -box.low[1]});
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double tolerance = 1e-5 * (1 + std::abs(wanted.low[axis]) + std::abs(wanted.high[axis]));
      require(std::abs(found.low[axis] - wanted.low[axis]) <= tolerance &&
                  std::abs(found.high[axis] - wanted.high[axis]) <= tolerance,
              "the extent", name);
    }
  }

  void check_facts(int index, const std::vector<std::size_t>& instances) const {
    const std::string& name = node(index).name;
    const auto facts = nlohmann::json::parse(node(index).extras.Get("instances").Get<std::string>());
    require(facts.size() == instances.size(), "the number", name);
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const SceneNode& expected = scene_.nodes[instances[i]];
      require(facts[i]["name"] == expected.name, "the name of an instance", name);
      require(facts[i]["address"] == clean_text(scene_.objects[*expected.object].thing.address),
              "the address", expected.name);
    }
  }

  void check_object(int index, const SceneObject& object, const std::string& name) {
    const auto& extras = node(index).extras;
    const bool has_address = extras.Has("address") && extras.Get("address").IsString();
    require(has_address && extras.Get("address").Get<std::string>() == clean_text(object.thing.address),
            "the address", name);
    check_box(local_transform(node(index)), check_sharing(index, object, name).box, object, name);
  }

  /// What decides which meshes an object has.
  struct Look {
    const Asset* asset;
    std::string paint;
    const SceneObject* itself;  // of a wall with openings and of what stands on an outline, which share their
                                // mesh with nothing

    auto operator<=>(const Look&) const = default;
  };

  struct Meshes {
    std::set<int> indices;
    Box3 box;  // in the frame of the placed node
  };

  const Meshes& check_sharing(int index, const SceneObject& object, const std::string& name) {
    const auto [place, is_new] = looks_.try_emplace(Look{
        object.asset, object.paint ? object.paint->text() : "", has_own_mesh(object) ? &object : nullptr});
    Meshes& known = place->second;
    Meshes found;
    collect(index, found.indices);
    if (is_new) {
      known.indices = found.indices;
      include(index, Affine{}, known.box);
    }
    require(found.indices == known.indices, "the shared mesh", name);
    return known;
  }

  void collect(int index, std::set<int>& meshes) const {
    if (node(index).mesh != -1) meshes.insert(node(index).mesh);
    for (const int child : node(index).children) collect(child, meshes);
  }

  void include(int index, const Affine& map, Box3& box) const {
    if (node(index).mesh != -1) {
      for (const auto& primitive : model_.meshes[static_cast<std::size_t>(node(index).mesh)].primitives) {
        const AccessorView positions(model_, primitive.attributes.at("POSITION"));
        for (std::size_t i = 0; i < positions.count(); ++i) box.include(map.apply(positions.point(i)));
      }
    }
    for (const int child : node(index).children) include(child, map * local_transform(node(child)), box);
  }

  /// Compares in the frame of the placed box, whose base is centred at the origin and not turned.
  void check_box(const Affine& placed, const Box3& meshes, const SceneObject& object,
                 const std::string& name) const {
    const PlacedBox& box = object.box;
    const Affine unturn = to_affine({{}, reversed(orientation(box)), {1, 1, 1}});
    const Affine uncenter =
        to_affine({{-box.center[0], -box.center[2], box.center[1]}, {0, 0, 0, 1}, {1, 1, 1}});
    const Box3 found = transformed(unturn * uncenter * placed, meshes);
    const Box3 wanted{{-box.size[0] / 2, 0, -box.size[1] / 2},
                      {box.size[0] / 2, box.size[2], box.size[1] / 2}};
    for (int axis = 0; axis < 3; ++axis) {
      const double tolerance =
          1e-5 * (1 + std::abs(box.center[0]) + std::abs(box.center[1]) + box.size[axis]);
      const bool flat = found.size()[axis] < tolerance;  // a flat asset cannot fill its box along this axis
      require(flat || (std::abs(found.low[axis] - wanted.low[axis]) <= tolerance &&
                       std::abs(found.high[axis] - wanted.high[axis]) <= tolerance),
              "the extent", name);
    }
  }

  const tinygltf::Model& model_;
  const Scene& scene_;
  Nodes nodes_;
  std::map<Look, Meshes> looks_;
};

}  // namespace

void verify_glb(const std::filesystem::path& file, const Scene& scene, Nodes nodes) {
  const tinygltf::Model model = read_written_gltf(file);
  Verifier(model, scene, nodes).verify();
}

}  // namespace solitaire
