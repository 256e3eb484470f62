// Scenes in which things that look alike share a node.
#include "scene/gltf/instances.h"

#include "scene/gltf/verify.h"
#include "scene/gltf/writer.h"
#include "tests/scene/fixture.h"
#include "tests/support/text.h"

namespace solitaire {
namespace {

/// Five chairs, one of them red and one below another call, a table, and a wall with a door in it.
std::vector<PlacedThing> furniture() {
  std::vector<PlacedThing> things = {placed("chair", {0, 0, 0}),
                                     placed("chair", {1, 2, 0.5}, {0.6, 0.7, 1.1}),
                                     placed("table", {5, 5, 0}),
                                     placed("chair", {2, 0, 0}),
                                     placed("chair", {3, 0, 0}),
                                     placed("chair", {4, 0, 0}),
                                     placed("wall", {0, 9, 0}, {4, 0.2, 2.5}),
                                     placed("door", {1, 8.9, 0}, {1, 0.4, 2})};
  things[1].turn = 3;
  things[1].extras.emplace_back("price", "12");
  things[1].extras.emplace_back("tags", "[\"a\", 1]");
  things[1].choices.push_back({"x", std::int64_t{3}});
  things[4].color = {{1, 0, 0}};
  things[5].groups = {"room[0]"};
  return things;
}

std::vector<std::string> names_of(const json& file, const json& node) {
  std::vector<std::string> names;
  for (const json& child : node["children"]) names.push_back(file["nodes"][child.get<std::size_t>()]["name"]);
  return names;
}

}  // namespace

TEST_CASE("scene: with instances, things of one mesh below one node share a node, which tells of each") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const Scene scene = build_scene(furniture(), 1, "test", assets);
  write_glb(scene, folder / "a.glb", Nodes::kInstances);
  const json file = json_of(read_file(folder / "a.glb"));
  CHECK(file["extensionsRequired"] == json{"EXT_mesh_gpu_instancing"});
  CHECK(names_of(file, node_named(file, "test")) ==
        std::vector<std::string>{"chair instances", "table", "chair[3]", "room[0]", "wall", "door"});
  CHECK(names_of(file, node_named(file, "room[0]")) == std::vector<std::string>{"chair[4]"});

  const json& shared = node_named(file, "chair instances");
  const json facts = json::parse(shared["extras"]["instances"].get<std::string>());
  REQUIRE(facts.size() == 3);
  CHECK(facts[0]["name"] == "chair[0]");
  CHECK(facts[2]["name"] == "chair[2]");
  CHECK(facts[1]["address"] == scene.objects[1].thing.address);
  CHECK(facts[1]["price"] == 12);
  CHECK(facts[1]["tags"] == json{"a", 1});
  CHECK(facts[1]["choices"] == json{{{"at", "x"}, {"value", 3}}});
  const json& attributes = shared["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
    CHECK(file["accessors"][attributes[name].get<std::size_t>()]["count"] == 3);
}

TEST_CASE("scene: a model made of instances is as large as one made of nodes, and has no ground") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const Scene scene = build_scene(furniture(), 1, "test", assets);
  write_glb(scene, folder / "plain.glb");
  write_glb(scene, folder / "shared.glb", Nodes::kInstances);
  AssetLibrary own(kAssets, folder.path());
  const Asset* plain = own.find("plain.glb");
  const Asset* shared = own.find("shared.glb");
  check_point(shared->box.low, plain->box.low);
  check_point(shared->box.high, plain->box.high);
  CHECK(plain->box.size()[0] < 7);
}

TEST_CASE(
    "scene: merged things of one mesh fill the same box, with as many triangles, in squares of 32 metres") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  std::vector<PlacedThing> things = furniture();
  things.push_back(placed("chair", {40, 0, 0}));
  things.push_back(placed("chair", {41, 0, 0}));
  const Scene scene = build_scene(things, 1, "test", assets);
  write_glb(scene, folder / "plain.glb");
  write_glb(scene, folder / "merged.glb", Nodes::kChunks);  // which reads it back and compares the boxes
  const json file = json_of(read_file(folder / "merged.glb"));
  CHECK_FALSE(has(file["extensionsUsed"].dump(), "EXT_mesh_gpu_instancing"));
  const std::vector<std::string> names = names_of(file, node_named(file, "test"));
  REQUIRE(names.size() == 7);
  CHECK(names.front() == "chair chunk");
  CHECK(names.back().starts_with("chair chunk"));
  AssetLibrary own(kAssets, folder.path());
  const Asset* plain = own.find("plain.glb");
  const Asset* merged = own.find("merged.glb");
  check_point(merged->box.low, plain->box.low);
  check_point(merged->box.high, plain->box.high);
  Scene moved = scene;
  moved.objects[1].box.center[1] += 0.5;  // that of the greatest y
  CHECK_THROWS_AS(verify_glb(folder / "merged.glb", moved, Nodes::kChunks), SceneError);
}

TEST_CASE("scene: instances are read back and compared, each") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const Scene scene = build_scene(furniture(), 1, "test", assets);
  const std::string bytes = glb_bytes(scene, Nodes::kInstances);
  const auto verify = [&](const std::string& written) {
    write_file(folder / "a.glb", written);
    verify_glb(folder / "a.glb", scene, Nodes::kInstances);
  };
  CHECK_NOTHROW(verify(bytes));
  CHECK_THROWS_AS(verify(glb_bytes(scene)), SceneError);
  // A moved instance: the accessor of scales stands for that of places.
  json file = json_of(bytes);
  for (json& node : file["nodes"]) {
    if (!node.contains("extensions") || !node["extensions"].contains("EXT_mesh_gpu_instancing")) continue;
    json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    attributes["TRANSLATION"] = attributes["SCALE"];
  }
  CHECK_THROWS_AS(verify(with_json(bytes, file)), SceneError);
  file = json_of(bytes);
  for (json& node : file["nodes"]) {
    if (node.contains("extras") && node["extras"].contains("instances")) node["extras"]["instances"] = "[]";
  }
  CHECK_THROWS_AS(verify(with_json(bytes, file)), SceneError);
}

}  // namespace solitaire
