// From placements to a .glb.
#include <map>
#include <set>

#include "scene/gltf/reader.h"
#include "scene/gltf/verify.h"
#include "scene/gltf/writer.h"
#include "scene/names.h"
#include "scene/page/drawing/plan.h"
#include "tests/scene/fixture.h"

namespace solitaire {

TEST_CASE("scene: an asset's corner comes to the right place in all four turns") {
  TemporaryFolder folder;
  write_file(folder / "sail.gltf", triangle_file(folder.path()).dump());
  AssetLibrary assets(kAssets, folder.path());
  // The front left corner, worked out by hand: 2 × 1 at turns 0 and 2, 1 × 2 at turns 1 and 3.
  const Vec3 expected[] = {{10, 20, 5}, {11, 20, 5}, {12, 21, 5}, {10, 22, 5}};
  for (int turn = 0; turn < 4; ++turn) {
    CAPTURE(turn);
    const Scene scene = build_scene({placed("sail.gltf", {10, 20, 5}, {}, turn)}, 1, "test", assets);
    const json file = json_of(glb_bytes(scene));
    check_point(in_program(node_named(file, "sail"), {-1, 0, 0.5}), expected[turn]);
  }
}

TEST_CASE("scene: size stretches an asset before it is turned, and the unit scales everything") {
  TemporaryFolder folder;
  write_file(folder / "sail.gltf", triangle_file(folder.path()).dump());
  AssetLibrary assets(kAssets, folder.path());
  const Scene scene = build_scene({placed("sail.gltf", {2, 4, 6}, {8, 6, 2}, 1)}, 0.5, "test", assets);
  const json file = json_of(glb_bytes(scene));
  // 4 × 3 × 1 metres from (1, 2, 3), turned once: the front left corner at the right, the rear right at the
  // left.
  check_point(in_program(node_named(file, "sail"), {-1, 0, 0.5}), {4, 2, 3});
  check_point(in_program(node_named(file, "sail"), {1, 3, -0.5}), {1, 6, 4});
}

TEST_CASE("scene: an angle turns about the middle of the box that is not turned") {
  AssetLibrary assets = bundled();
  PlacedThing placement = placed("", {10, 20, 0}, {4, 2, 1});
  placement.angle = 30;
  placement.turn = 1;  // counts for nothing beside an angle
  const json file = json_of(glb_bytes(build_scene({placement}, 1, "test", assets)));
  const double c = std::cos(std::acos(-1) / 6), s = 0.5;
  check_point(in_program(node_named(file, "box"), {-0.5, 0, 0.5}), {12 - 2 * c + s, 21 - 2 * s - c, 0});
}

TEST_CASE("scene: heights: as given, else an asset's own, else a box's lesser side") {
  AssetLibrary assets = bundled();
  const auto height = [&](const std::string& asset, std::vector<double> size) {
    return build_scene({placed(asset, {0, 0, 0}, std::move(size))}, 0.5, "test", assets)
        .objects[0]
        .box.size[2];
  };
  CHECK(height("table", {9, 9}) == doctest::Approx(0.74));
  CHECK(height("table", {9, 9, 3}) == doctest::Approx(1.5));
  CHECK(height("table", {}) == doctest::Approx(0.74));
  CHECK(height("no such thing", {4, 3}) == doctest::Approx(1.5));
  CHECK(height("", {}) == doctest::Approx(0.5));
}

TEST_CASE("scene: an asset that states its front is turned to it") {
  TemporaryFolder folder;
  json file = triangle_file(folder.path());
  file["nodes"][0]["extras"] = {{"front", "+X"}};
  write_file(folder / "sail.gltf", file.dump());
  AssetLibrary assets(kAssets, folder.path());
  // Its front is the side x = 1, 1 m wide, now towards -y; the corner (-1, 0.5) is at the left of the rear.
  const Scene scene = build_scene({placed("sail.gltf", {0, 0, 0})}, 1, "test", assets);
  CHECK(scene.objects[0].box.size[0] == doctest::Approx(1));
  CHECK(scene.objects[0].box.size[1] == doctest::Approx(2));
  const json written = json_of(glb_bytes(scene));
  check_point(in_program(node_named(written, "sail"), {1, 0, 0.5}), {0, 0, 0});
  check_point(in_program(node_named(written, "sail"), {-1, 0, 0.5}), {0, 2, 0});
}

TEST_CASE("scene: impossible sizes and places are errors that name the place call") {
  AssetLibrary assets = bundled();
  const auto error = [&](const PlacedThing& placement) {
    return error_of([&] { build_scene({placement}, 1, "test", assets); });
  };
  CHECK(error(placed("", {0, 0, 0}, {1, -1})).find("test.sol:1:1") == 0);
  CHECK(error(placed("", {0, 0, 0}, {1, std::nan("")})) != "");
  CHECK(error(placed("", {0, 0, 0}, {1})) != "");
  CHECK(error(placed("", {INFINITY, 0, 0}, {1, 1})) != "");
  CHECK(error(placed("", {0, 0, 0}, {1, 0})) == "");
}

TEST_CASE("scene: the tree is the call tree, in the program's order") {
  AssetLibrary assets = bundled();
  PlacedThing first = placed("table", {0, 0, 0}), second = placed("chair", {2, 0, 0}),
              third = placed("chair", {4, 0, 0});
  first.groups = third.groups = {"wing[0]", "room[0]"};
  second.groups = {"wing[1]", "room[0]"};
  const json file = json_of(glb_bytes(build_scene({first, second, third}, 1, "office", assets)));
  const auto children = [&](const std::string& name) {
    std::vector<std::string> names;
    for (const json& child : node_named(file, name)["children"])
      names.push_back(file["nodes"][child.get<int>()]["name"]);
    return names;
  };
  CHECK(children("office") == std::vector<std::string>{"wing[0]", "wing[1]"});
  CHECK(children("wing[0]") == std::vector<std::string>{"room[0]"});
  CHECK(children("room[0]") == std::vector<std::string>{"table", "chair[1]"});
  CHECK(children("room[0][1]") == std::vector<std::string>{"chair[0]"});
}

TEST_CASE("scene: nodes share an asset's mesh, and colours share its geometry") {
  AssetLibrary assets = bundled();
  std::vector<PlacedThing> placements;
  for (int i = 0; i < 10; ++i) placements.push_back(placed("chair", {i * 1.0, 0, 0}, {}, i % 4));
  for (int i = 0; i < 4; ++i) {
    placements.push_back(placed("chair", {i * 1.0, 2, 0}));
    placements.back().color = {{i < 2 ? 1.0 : 0.5, 0, 0}};
    placements.push_back(placed("no such model", {i * 1.0, 4, 0}));
  }
  const json file = json_of(glb_bytes(build_scene(placements, 1, "test", assets)));
  CHECK(file["meshes"].size() == 5);  // chair, two colours of it, one box, the ground
  std::set<int> positions;
  std::map<int, int> uses;
  for (const json& mesh : file["meshes"]) {
    for (const json& primitive : mesh["primitives"])
      positions.insert(primitive["attributes"]["POSITION"].get<int>());
  }
  for (const json& node : file["nodes"]) {
    if (node.contains("mesh")) ++uses[node["mesh"].get<int>()];
  }
  CHECK(uses == std::map<int, int>{{0, 10}, {1, 2}, {2, 4}, {3, 2}, {4, 1}});
  CHECK(positions.size() == json_of(read_file(kAssets / "chair.glb"))["meshes"][0]["primitives"].size() + 2);
}

TEST_CASE("scene: a user's file is copied with its hierarchy, materials and images") {
  TemporaryFolder folder;
  json file = triangle_file(folder.path());
  file["nodes"] = {
      {{"name", "boat"}, {"children", {1, 2}}, {"translation", {5, 1, 0}}},
      {{"name", "sail"}, {"mesh", 0}, {"rotation", {0, 0.70710678, 0, 0.70710678}}},
      {{"name", "sail"}, {"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1}}}};
  write_file(folder / "boat.gltf", file.dump());
  AssetLibrary assets(kAssets, folder.path());
  const Scene scene =
      build_scene({placed("boat.gltf", {0, 0, 0}), placed("./boat.gltf", {9, 0, 0})}, 1, "test", assets);
  CHECK(scene.objects[0].asset == scene.objects[1].asset);
  // Turned once, the triangle is 1 × 2; twice as wide and 3 m higher, the other is 4 × 1.
  check_point(scene.objects[0].box.size, {4, 2, 6});

  const fs::path path = folder / "out.glb";
  write_glb(scene, path);
  const json written = json_of(read_file(path));
  CHECK(written["meshes"].size() == 2);  // and the ground
  CHECK(written["images"].size() == 1);
  CHECK(written["images"][0]["mimeType"] == "image/png");
  CHECK(written["samplers"][0]["wrapS"] == 33071);
  CHECK(written["meshes"][0]["primitives"][1]["mode"] == 2);
  CHECK(written["materials"].size() == 3);
  std::set<std::string> names;
  for (const json& node : written["nodes"]) names.insert(node["name"].get<std::string>());
  CHECK(names.size() == 4 + 2 * 4);  // with the camera, the sun and the ground
  const auto& view = written["bufferViews"][written["images"][0]["bufferView"].get<std::size_t>()];
  const auto offset = 28 + word(read_file(path), 12) + view.value("byteOffset", 0u);
  CHECK(read_file(path).substr(offset, view["byteLength"]) == read_file(folder / "a picture.png"));
}

TEST_CASE("scene: names are unique and start none of Godot's import rules") {
  CHECK(harmless_name("wall-col") == "wall-col (1)");
  CHECK(harmless_name("Loop_CYCLE 2") == "Loop_CYCLE 2 (1)");
  CHECK(harmless_name("door.navmesh.001") == "door.navmesh.001 (1)");
  CHECK(harmless_name("a$col b") == "a_col b");
  CHECK(harmless_name("protocol") == "protocol");
  CHECK(harmless_name("tab\tnul\x01 bad\xff") == "tab nul  bad\uFFFD");
  UniqueNames names;
  CHECK(names.take("a") == "a");
  CHECK(names.take("a[1]") == "a[1]");
  CHECK(names.take("a") == "a[2]");
  names.announce("seat");
  names.announce("seat");
  CHECK(names.take("seat") == "seat[0]");
  CHECK(names.take("seat") == "seat[1]");
  CHECK(names.take("x-rigid") == "x-rigid (1)");
  CHECK(names.take("x-rigid") == "x-rigid (1)[1]");
}

TEST_CASE("scene: extras tell address, source, choices and the program's own arguments") {
  AssetLibrary assets = bundled();
  PlacedThing placement = placed("chair", {0, 0, 0});
  const std::string long_address(100, 'a');
  placement.choices = {
      {"b/x", std::int64_t{-7}}, {long_address, true}, {"a/i", std::int64_t{1234567890123}}, {"c/f", 0.5}};
  placement.extras = {{"price", "12.5"}, {"tags", R"(["a","b"])"}, {"none", "null"}, {"address", "\"home\""}};
  const json file = json_of(glb_bytes(build_scene({placement}, 1, "test", assets)));
  const json expected = {{"address", placement.address},
                         {"address_", "home"},
                         {"source", "test.sol:1:1"},
                         {"choices",
                          {{{"at", "b/x"}, {"value", -7}},
                           {{"at", long_address}, {"value", true}},
                           {{"at", "a/i"}, {"value", "1234567890123"}},
                           {{"at", "c/f"}, {"value", 0.5}}}},
                         {"price", 12.5},
                         {"tags", R"(["a","b"])"},
                         {"none", "null"}};
  CHECK(node_named(file, "chair")["extras"] == expected);
}

TEST_CASE("scene: the same placements give the same bytes") {
  const auto bytes = [] {
    AssetLibrary assets = bundled();
    std::vector<PlacedThing> placements;
    for (const char* asset : {"chair", "table", "unknown", "", "tree", "chair"}) {
      placements.push_back(
          placed(asset, {placements.size() * 2.5, 1, 0}, {}, static_cast<int>(placements.size())));
      placements.back().angle = placements.size() * 17.0;
    }
    return glb_bytes(build_scene(placements, 1, "test", assets));
  };
  CHECK(bytes() == bytes());
}

TEST_CASE("scene: a program that places nothing still gives a valid file") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const Scene scene = build_scene({}, 1, "queens", assets);
  write_glb(scene, folder / "queens.glb");
  CHECK(svg_plan(scene) == "");
  CHECK(read_gltf(folder / "queens.glb").nodes.size() == 3);  // its root, the camera and the sun
}

TEST_CASE("scene: reading back finds what does not belong to the scene") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const auto make = [&](double x, int turn, const std::string& asset) {
    return build_scene({placed("table", {0, 0, 0}), placed(asset, {x, 0, 0}, {2, 1}, turn)}, 1, "test",
                       assets);
  };
  const Scene scene = make(3, 0, "chair");
  write_glb(scene, folder / "a.glb");
  CHECK_NOTHROW(verify_glb(folder / "a.glb", scene));
  Scene moved = scene;
  moved.objects[1].box.center[0] += 0.001;
  CHECK_THROWS_AS(verify_glb(folder / "a.glb", moved), SceneError);
  Scene turned = scene;
  turned.objects[1].box.angle = 90;
  CHECK_THROWS_AS(verify_glb(folder / "a.glb", turned), SceneError);
  CHECK_THROWS_AS(verify_glb(folder / "a.glb", make(3, 0, "sofa")), SceneError);
}

}  // namespace solitaire
