// What further named arguments of place mean to a scene: tints, tilts, scale, parents, glass.
#include "scene/gltf/writer.h"
#include "scene/picture/picture.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

PlacedThing having(PlacedThing thing, const std::string& name, const std::string& text) {
  thing.extras.emplace_back(name, text);
  return thing;
}

Scene scene_of_options(const std::vector<PlacedThing>& things) {
  static AssetLibrary assets = bundled();
  return build_scene(things, 1, "test", assets);
}

const json& surface_of(const json& file, const std::string& node, std::size_t primitive) {
  const json& mesh = file["meshes"][node_named(file, node)["mesh"].get<std::size_t>()];
  return file["materials"][mesh["primitives"][primitive]["material"].get<std::size_t>()];
}

std::vector<double> color_factor(const json& file, const std::string& node, std::size_t primitive) {
  return surface_of(file, node, primitive)["pbrMetallicRoughness"]["baseColorFactor"];
}

}  // namespace

TEST_CASE("scene: a colour that tints multiplies the colours of all surfaces, any other replaces the first") {
  TemporaryFolder folder;
  PlacedThing plain = placed("table", {0, 0, 0}), painted = placed("table", {3, 0, 0}), tinted = painted;
  plain.name = "plain", painted.name = "painted", tinted.name = "tinted";
  painted.color = tinted.color = {{0.5, 1, 0}};
  const Scene scene = scene_of_options({plain, painted, having(tinted, "tint", "true")});
  write_glb(scene, folder / "a.glb");
  const json file = json_of(read_file(folder / "a.glb"));
  const Color tint = to_linear({0.5, 1, 0});
  for (std::size_t surface = 0; surface < 2; ++surface) {
    for (std::size_t part = 0; part < 3; ++part) {
      const double own = color_factor(file, "plain", surface)[part];
      CHECK(color_factor(file, "tinted", surface)[part] == doctest::Approx(own * tint[part]));
      CHECK(color_factor(file, "painted", surface)[part] == doctest::Approx(surface == 0 ? tint[part] : own));
    }
  }
  CHECK(scene.objects[2].color[1] == doctest::Approx(scene.objects[0].color[1]));
  CHECK(scene.objects[2].color[2] == doctest::Approx(0));
}

TEST_CASE("scene: what is marked has its colour all over, whatever it is made of") {
  for (const auto& [asset, name, text] : {std::array{"table", "tint", "true"},
                                          {"table", "material", "\"glass\""},
                                          {"", "material", "\"glass\""},
                                          {"tree", "label", "\"oak\""}}) {
    PlacedThing thing = having(placed(asset, {0, 0, 0}), name, text);
    thing.name = "thing", thing.color = {{0.85, 0.1, 0.1}}, thing.marked = true;
    const Scene scene = scene_of_options({thing});
    CHECK(scene.objects[0].color == Color{0.85, 0.1, 0.1});
    const json file = json_of(glb_bytes(scene));
    const json& mesh = file["meshes"][node_named(file, "thing")["mesh"].get<std::size_t>()];
    CHECK(mesh["primitives"].size() == (*asset == 't' ? 2 : 1));
    for (std::size_t surface = 0; surface < mesh["primitives"].size(); ++surface) {
      const Color red = to_linear({0.85, 0.1, 0.1});
      const std::vector<double> found = color_factor(file, "thing", surface);
      for (std::size_t part = 0; part < 3; ++part) CHECK(found[part] == doctest::Approx(red[part]));
      CHECK(found[3] == 1);
    }
  }
}

TEST_CASE("picture: what is marked is seen in its colour all over") {
  PlacedThing shelf = placed("bookcase", {0, 0, 0});
  shelf.color = {{0.85, 0.1, 0.1}};
  const PictureSize size{160, 120};
  Painter painter;
  const auto red_share = [&](const PlacedThing& thing) {
    const Scene scene = scene_of_options({thing});
    const Picture picture = painter.draw(scene, size, default_camera(scene, 4.0 / 3));
    double red = 0, pixels = 0;
    for (std::size_t i = 0; i < picture.objects.size(); ++i) {
      if (picture.objects[i] != 0) continue;
      const std::uint8_t* pixel = picture.image.pixel(i % size.width, i / size.width);
      red += pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2] ? 1 : 0;
      pixels += 1;
    }
    REQUIRE(pixels > 500);
    return red / pixels;
  };
  CHECK(red_share(shelf) < 0.85);  // the books have colours of their own
  shelf.marked = true;
  CHECK(red_share(shelf) > 0.93);
}

TEST_CASE("scene: pitch raises the front, roll lowers the right; the middle of the base stays") {
  const auto corners = [&](const PlacedThing& thing) {
    const Scene scene = scene_of_options({thing});
    const Affine map = to_affine(scene.objects[0].node_transform);
    const Box3 box = scene.objects[0].asset->box;
    const auto at = [&](double x, double y, double z) {  // in shares of the model's box, seen from its front
      return map.apply(
          {box.low[0] + x * box.size()[0], box.low[1] + y * box.size()[1], box.low[2] + z * box.size()[2]});
    };
    return std::array{at(0.5, 0, 0.5), at(0.5, 0, 1), at(1, 0, 0.5), at(0.5, 1, 0.5)};
  };
  for (const int turn : {0, 1, 2, 3}) {
    CAPTURE(turn);
    const PlacedThing chair = placed("chair", {5, 7, 1}, {2, 4, 3}, turn);
    const auto [middle, front, right, top] = corners(chair);
    const auto pitched = corners(having(chair, "pitch", "30"));
    check_point(pitched[0], middle);
    CHECK(pitched[1][1] == doctest::Approx(front[1] + 2 * 0.5));
    CHECK(pitched[2][1] == doctest::Approx(right[1]));
    const auto rolled = corners(having(chair, "roll", "30"));
    check_point(rolled[0], middle);
    CHECK(rolled[2][1] == doctest::Approx(right[1] - 1 * 0.5));
    CHECK(rolled[1][1] == doctest::Approx(front[1]));
    const auto over = corners(having(chair, "pitch", "180"));
    check_point(over[3], {top[0], middle[1] - 3, top[2]});
  }
  TemporaryFolder folder;
  const PlacedThing sofa = having(having(placed("sofa", {1, 2, 3}, {}, 1), "pitch", "20"), "roll", "-35");
  const Scene scene = scene_of_options({sofa});
  CHECK_NOTHROW(write_glb(scene, folder / "a.glb"));  // which reads it back and compares
  const Box3 tilted = bounds(scene.objects[0].box), box = scene.objects[0].asset->box;
  const Box3 found = transformed(to_affine(scene.objects[0].node_transform), box);
  check_point(tilted.low, {found.low[0], -found.high[2], found.low[1]});
  check_point(tilted.high, {found.high[0], -found.low[2], found.high[1]});
}

TEST_CASE("scene: a scale makes a model larger in proportion, and stands beside no size") {
  const Scene scene =
      scene_of_options({placed("chair", {0, 0, 0}), having(placed("chair", {0, 0, 0}), "scale", "2.5"),
                        having(placed("", {0, 0, 0}), "scale", "3")});
  const Vec3 own = scene.objects[0].box.size;
  check_point(scene.objects[1].box.size, {own[0] * 2.5, own[1] * 2.5, own[2] * 2.5});
  check_point(scene.objects[2].box.size, {3, 3, 3});
  CHECK(error_of([&] {
          scene_of_options({having(placed("chair", {0, 0, 0}, {1, 1}), "scale", "2")});
        }).find("'scale' stands beside 'size'") != std::string::npos);
}

TEST_CASE("scene: a parent puts a thing below nodes of these names in place of the program's calls") {
  PlacedThing chair = placed("chair", {0, 0, 0}), table = placed("table", {3, 0, 0}),
              lamp = placed("lamp", {6, 0, 0});
  chair.groups = table.groups = lamp.groups = {"f"};
  const json file = json_of(glb_bytes(scene_of_options({having(chair, "parent", "\"level 1/kitchen\""), lamp,
                                                        having(table, "parent", "\"level 1/kitchen\"")})));
  const auto children = [&](const std::string& name) {
    std::vector<std::string> names;
    for (const json& child : node_named(file, name)["children"])
      names.push_back(file["nodes"][child.get<std::size_t>()]["name"]);
    return names;
  };
  CHECK(children("test") == std::vector<std::string>{"level 1", "f"});
  CHECK(children("level 1") == std::vector<std::string>{"kitchen"});
  CHECK(children("kitchen") == std::vector<std::string>{"chair", "table"});
  CHECK(children("f") == std::vector<std::string>{"lamp"});
}

TEST_CASE("scene: further arguments of a wrong type are errors that name the place call") {
  for (const auto& [name, text, wanted] : {std::array{"tint", "3", "'tint' is true or false, not 3"},
                                           {"pitch", "\"up\"", "'pitch' is a number"},
                                           {"roll", "[1]", "'roll' is a number"},
                                           {"scale", "0", "'scale' is a positive number, not 0"},
                                           {"scale", "-2.5", "'scale' is a positive number"},
                                           {"parent", "1", "'parent' is a string"},
                                           {"material", "true", "there is no material true"},
                                           {"material", "\"oka\"", "there is no material \"oka\""}}) {
    PlacedThing thing = having(placed("chair", {0, 0, 0}), name, text);
    thing.source = "a.sol:3:1";
    const std::string error = error_of([&] { scene_of_options({thing}); });
    CAPTURE(error);
    CHECK(error.starts_with("a.sol:3:1: "));
    CHECK(error.find(wanted) != std::string::npos);
  }
}

TEST_CASE("picture: one looks through glass, which casts no shadow") {
  PlacedThing post = placed("", {0, 4, 0}, {1, 1, 4});
  post.color = {{0.9, 0.1, 0.1}};
  const PictureSize size{160, 120};
  Painter painter;
  const Scene alone = scene_of_options({post});
  const Camera camera = default_camera(alone, 4.0 / 3);
  const auto red = [&](const Picture& picture) {
    double sum = 0, pixels = 0;
    for (std::size_t i = 0; i < picture.objects.size(); ++i) {
      if (picture.objects[i] != 0) continue;
      const std::uint8_t* pixel = picture.image.pixel(i % size.width, i / size.width);
      sum += pixel[0] - pixel[2];
      pixels += 1;
    }
    return std::pair(pixels, sum / pixels);
  };
  const PlacedThing pane = placed("", {-3, 1, 0}, {8, 0.7, 9});
  const auto [pixels, bare] = red(painter.draw(alone, size, camera));
  REQUIRE(pixels > 500);
  const auto [through, tinted] =
      red(painter.draw(scene_of_options({post, having(pane, "material", "\"glass\"")}), size, camera));
  CHECK(through == pixels);  // all of it is still seen
  CHECK(tinted < 0.8 * bare);
  CHECK(tinted > 0.2 * bare);
  CHECK(red(painter.draw(scene_of_options({post, pane}), size, camera)).first <
        0.5 * pixels);  // behind a board it is not

  const json file = json_of(glb_bytes(scene_of_options({having(pane, "material", "\"glass\"")})));
  CHECK(file["materials"][0]["alphaMode"] == "BLEND");
  CHECK(file["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][3] == 0.35);
}

}  // namespace solitaire
