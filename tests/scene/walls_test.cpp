// Walls, and the openings that doors and windows make in them.
#include "scene/gltf/writer.h"
#include "scene/openings.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

/// What is left of a wall of 4 x 0.2 x 2.5 metres, as boxes in shares of it.
std::vector<Box3> left_of_wall(const PlacedThing& wall, const std::vector<PlacedThing>& fixtures) {
  AssetLibrary assets = bundled();
  std::vector<PlacedThing> things = fixtures;
  things.push_back(wall);
  const Scene scene = build_scene(things, 1, "test", assets);
  return solid_parts({{0, 0, 0}, {1, 1, 1}}, scene.objects.back().openings);
}

void check_boxes(const std::vector<Box3>& found, const std::vector<Box3>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    check_point(found[i].low, expected[i].low);
    check_point(found[i].high, expected[i].high);
  }
}

}  // namespace

TEST_CASE("scene: doors and windows open the wall that they stand in, whichever way it stands") {
  const std::vector<Box3> with_door = {
      {{0, 0, 0}, {0.25, 1, 1}}, {{0.25, 0.8, 0}, {0.5, 1, 1}}, {{0.5, 0, 0}, {1, 1, 1}}};
  // 1 m wide, 2 m high, 1 m from the wall's left end as seen from its front.
  check_boxes(
      left_of_wall(placed("wall", {0, 0, 0}, {4, 0.2, 2.5}), {placed("door", {1, -0.1, 0}, {1, 0.4, 2})}),
      with_door);
  check_boxes(left_of_wall(placed("wall", {0, 0, 0}, {4, 0.2, 2.5}, 1),
                           {placed("door", {-0.1, 1, 0}, {1, 0.4, 2}, 3)}),
              with_door);
  check_boxes(
      left_of_wall(placed("wall", {0, 0, 0}, {4, 0.2, 2.5}, 2), {placed("door", {2, -0.1, 0}, {1, 0.4, 2})}),
      with_door);
  PlacedThing box = placed("", {0, 0, 0}, {4, 0.2, 2.5});
  box.name = "the wall";
  check_boxes(left_of_wall(box, {placed("door", {1, -0.1, 0}, {1, 0.4, 2})}), with_door);
  check_boxes(
      left_of_wall(placed("wall", {0, 0, 0}, {4, 0.2, 2.5}),
                   {placed("window", {1, -0.1, 1}, {1, 0.4, 1}), placed("door", {2, 0, 0}, {1, 0.2, 2})}),
      {{{0, 0, 0}, {0.25, 1, 1}},
       {{0.25, 0, 0}, {0.5, 0.4, 1}},
       {{0.25, 0.8, 0}, {0.5, 1, 1}},
       {{0.5, 0.8, 0}, {0.75, 1, 1}},
       {{0.75, 0, 0}, {1, 1, 1}}});
}

TEST_CASE("scene: what does not go through a wall leaves it whole, and so does what would leave no wall") {
  const PlacedThing wall = placed("wall", {0, 0, 0}, {4, 0.2, 2.5});
  const std::vector<Box3> whole = {{{0, 0, 0}, {1, 1, 1}}};
  PlacedThing askew = placed("door", {1, -0.1, 0}, {1, 0.4, 2});
  askew.angle = 10;
  for (const PlacedThing& thing :
       {placed("door", {1, 0.12, 0}, {1, 0.2, 2}), placed("door", {5, -0.1, 0}, {1, 0.4, 2}), askew,
        placed("bookcase", {1, -0.1, 0}, {1, 0.4, 2}), placed("door", {1, -0.1, 3}, {1, 0.4, 2}),
        placed("door", {-1, -0.1, 0}, {6, 0.4, 2}), placed("door", {0, -0.1, 0}, {4, 0.4, 3}),
        placed("door", {3, -0.1, 0}, {1, 0.4, 3})}) {
    check_boxes(left_of_wall(wall, {thing}), whole);
  }
  PlacedThing other = placed("", {0, 0, 0}, {4, 0.2, 2.5});
  other.name = "wallpaper";
  check_boxes(left_of_wall(other, {placed("door", {1, -0.1, 0}, {1, 0.4, 2})}), whole);
}

TEST_CASE("scene: a wall with an opening is written as blocks, in the wall's material, and read back") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  PlacedThing box = placed("", {0, 5, 0}, {4, 0.2, 2.5});
  box.name = "wall";
  const Scene scene =
      build_scene({placed("wall", {0, 0, 0}, {4, 0.2, 2.5}), placed("wall", {0, 9, 0}), box,
                   placed("door", {1, -0.1, 0}, {1, 0.4, 2}), placed("door", {1, 4.9, 0}, {1, 0.4, 2})},
                  1, "test", assets);
  write_glb(scene, folder / "a.glb");
  const json file = json_of(read_file(folder / "a.glb"));
  const auto primitive = [&](const std::string& node) {
    return file["meshes"][node_named(file, node)["mesh"].get<std::size_t>()]["primitives"][0];
  };
  const auto triangles = [&](const std::string& node) {
    return file["accessors"][primitive(node)["indices"].get<std::size_t>()]["count"].get<int>() / 3;
  };
  CHECK(triangles("wall[0]") == 36);  // three blocks
  CHECK(triangles("wall[1]") == 12);
  CHECK(triangles("wall[2]") == 36);
  CHECK(primitive("wall[0]")["material"] == primitive("wall[1]")["material"]);
  CHECK(primitive("wall[0]")["material"] != primitive("wall[2]")["material"]);
}

}  // namespace solitaire
