// How things look: their proportions, their materials, the camera and the light.
#include "scene/gltf/writer.h"
#include "scene/sun.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

/// What a node's rotation makes of a vector.
Vec3 rotated(const json& node, const Vec3& v) {
  const auto& q = node["rotation"];
  const Affine map = to_affine({{}, {q[0], q[1], q[2], q[3]}, {1, 1, 1}});
  return map.apply(v);
}

}  // namespace

TEST_CASE("scene: a model that keeps its proportions is as large as its ground allows, in the middle of it") {
  AssetLibrary assets = bundled();
  const Asset* tree = assets.find("tree");
  const Vec3 natural = {tree->box.size()[0], tree->box.size()[2], tree->box.size()[1]};
  const Scene scene = build_scene(
      {placed("tree", {10, 20, 0}, {natural[0] / 2, 9}), placed("tree", {10, 20, 0}, {9, natural[0] / 2}, 1),
       placed("tree", {0, 0, 0}, {1, 1, 8}), placed("tree", {0, 0, 0})},
      1, "test", assets);
  check_point(scene.objects[0].box.size, {natural[0] / 2, natural[1] / 2, natural[2] / 2});
  check_point(scene.objects[0].box.center, {10 + natural[0] / 4, 24.5, 0});
  const double scale = natural[0] / 2 / natural[1];
  check_point(scene.objects[1].box.size, {natural[0] * scale, natural[1] * scale, natural[2] * scale});
  check_point(scene.objects[1].box.center, {10 + natural[0] / 4, 24.5, 0});
  check_point(scene.objects[2].box.size, {1, 1, 8});
  check_point(scene.objects[3].box.size, natural);
}

TEST_CASE("scene: every file has a ground below all of it, which reaches past it") {
  AssetLibrary assets = bundled();
  const Scene scene =
      build_scene({placed("", {3, 4, -1}, {2, 2, 2}), placed("", {9, 4, 0}, {2, 2, 2})}, 1, "test", assets);
  const json file = json_of(glb_bytes(scene));
  const json& ground = node_named(file, "ground");
  CHECK(ground["extras"]["role"] == "ground");
  const json& primitive = file["meshes"][ground["mesh"].get<std::size_t>()]["primitives"][0];
  const json& points = file["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  CHECK(points["max"][1].get<double>() < -1);
  CHECK(points["max"][1].get<double>() > -1.01);
  CHECK(points["min"][0].get<double>() < 0);
  CHECK(points["max"][0].get<double>() > 14);
  CHECK(points["min"][2].get<double>() < -9);
  CHECK(points["max"][2].get<double>() > -1);
}

TEST_CASE("scene: every file has a camera that looks at the scene, and a sun") {
  AssetLibrary assets = bundled();
  PlacedThing named_so = placed("", {3, 4, 0}, {2, 2, 2});
  named_so.name = "camera";
  const json file = json_of(glb_bytes(build_scene({named_so}, 1, "test", assets)));
  const json& camera = node_named(file, "camera[1]");
  CHECK(camera["camera"] == 0);
  CHECK(file["cameras"][0]["type"] == "perspective");
  const Vec3 ahead = rotated(camera, {0, 0, -1}), up = rotated(camera, {0, 1, 0});
  CHECK(ahead[1] < -0.3);
  CHECK(up[1] > 0.3);
  check_point({rotated(camera, {1, 0, 0})[1], 0, 0}, {0, 0, 0});  // its horizon is level
  // Seen from the camera, the middle of the box is about ahead, and farther away than the nearest thing it
  // shows.
  const Vec3 middle{4, 1, -5};
  Vec3 way{};
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    way[i] = middle[i] - camera["translation"][i].get<double>();
    along += way[i] * ahead[i];
  }
  CHECK(along > 0.97 * std::hypot(way[0], way[1], way[2]));
  CHECK(along > file["cameras"][0]["perspective"]["znear"].get<double>());
  CHECK(along < file["cameras"][0]["perspective"]["zfar"].get<double>());

  const json& sun = node_named(file, "sun");
  CHECK(sun["extensions"]["KHR_lights_punctual"]["light"] == 0);
  CHECK(file["extensions"]["KHR_lights_punctual"]["lights"][0]["type"] == "directional");
  CHECK(file["extensionsUsed"] == json{"KHR_lights_punctual"});
  const Vec3 shines = rotated(sun, {0, 0, -1});
  check_point(shines, {-to_sun()[0], -to_sun()[1], -to_sun()[2]}, 1e-5);
}

TEST_CASE("scene: a material gives its colour and finish to the primary surface, and a colour tints it") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const auto of = [&](PlacedThing thing, const std::string& material) {
    thing.extras = {{"material", material}};
    return thing;
  };
  PlacedThing tinted = of(placed("chair", {4, 0, 0}), "\"steel\"");
  tinted.color = {{1, 0, 0}};
  const Scene scene =
      build_scene({of(placed("chair", {0, 0, 0}), "\"steel\""), of(placed("", {2, 0, 0}), "\"brick\""),
                   tinted, placed("chair", {6, 0, 0})},
                  1, "test", assets);
  write_glb(scene, folder / "a.glb");
  const json file = json_of(read_file(folder / "a.glb"));
  const auto surface = [&](const std::string& node, std::size_t primitive) {
    const auto& mesh = file["meshes"][node_named(file, node)["mesh"].get<std::size_t>()];
    return file["materials"][mesh["primitives"][primitive]["material"].get<std::size_t>()]
               ["pbrMetallicRoughness"];
  };
  const auto number = [](const json& pbr, const char* name) { return pbr.value(name, 1.0); };  // glTF's own
  CHECK(number(surface("chair[0]", 0), "metallicFactor") == 1);
  CHECK(number(surface("chair[0]", 0), "roughnessFactor") == doctest::Approx(0.35));
  CHECK(number(surface("chair[2]", 0), "metallicFactor") == 0);
  CHECK(surface("chair[0]", 1) == surface("chair[2]", 1));  // the seat stays
  CHECK(number(surface("box", 0), "roughnessFactor") == doctest::Approx(0.95));
  CHECK(surface("chair[1]", 0)["baseColorFactor"] == json{1.0, 0.0, 0.0, 1.0});
  CHECK(number(surface("chair[1]", 0), "metallicFactor") == 1);
  CHECK(node_named(file, "chair[0]")["extras"]["material"] == "steel");

  for (const char* wrong : {"\"stel\"", "5", "null", "[\"oak\"]"}) {
    const std::string error = error_of([&] {
      build_scene({of(placed("", {0, 0, 0}), wrong)}, 1, "test", assets);
    });
    CHECK(error.find(std::string("test.sol:1:1: there is no material ") + wrong) == 0);
    CHECK(error.find("oak, walnut") != std::string::npos);
  }
}

}  // namespace solitaire
