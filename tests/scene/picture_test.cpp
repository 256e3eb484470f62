// Pictures of scenes: what they show, and that they are always the same.
#include "scene/picture/picture.h"

#include <algorithm>
#include <map>
#include <set>

#include "scene/camera.h"
#include "scene/openings.h"
#include "scene/picture/cutaway.h"
#include "scene/picture/eye_view.h"
#include "scene/picture/picture_files.h"
#include "scene/picture/png.h"
#include "scene/picture/shape.h"
#include "scene/picture/sheet.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

constexpr PictureSize kSmall{96, 72};

PlacedThing named(PlacedThing thing, const std::string& name) {
  thing.name = name;
  return thing;
}

PlacedThing colored(PlacedThing thing, const std::array<double, 3>& color) {
  thing.color = color;
  return thing;
}

Scene scene_of(const std::vector<PlacedThing>& things) {
  static AssetLibrary assets = bundled();
  return build_scene(things, 1, "test", assets);
}

/// A room of 5 x 4 metres with a wall on each side, and a table in it.
std::vector<PlacedThing> room() {
  return {placed("floor", {0, 0, 0}, {5, 4}),
          named(placed("wall", {-0.1, 4, 0}, {5.2, 0.1, 2.5}), "back wall"),
          named(placed("wall", {-0.1, -0.1, 0}, {5.2, 0.1, 2.5}), "front wall"),
          named(placed("wall", {-0.1, 0, 0}, {4, 0.1, 2.5}, 1), "left wall"),
          named(placed("wall", {5, 0, 0}, {4, 0.1, 2.5}, 1), "right wall"),
          placed("table", {3, 0.5, 0}, {1.6, 0.8})};
}

std::map<std::int32_t, std::size_t> pixels_of_objects(const Picture& picture) {
  std::map<std::int32_t, std::size_t> pixels;
  for (const std::int32_t object : picture.objects) ++pixels[object];
  return pixels;
}

/// The mean colour of an object's pixels.
std::array<double, 3> color_of(const Picture& picture, std::int32_t object) {
  std::array<double, 3> sum{};
  double number = 0;
  for (std::size_t i = 0; i < picture.objects.size(); ++i) {
    if (picture.objects[i] != object) continue;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += picture.image.bytes[3 * i + k];
    ++number;
  }
  REQUIRE(number > 0);
  return {sum[0] / number, sum[1] / number, sum[2] / number};
}

/// Where a camera sees a point: across and up, each -1..1 within the picture.
std::array<double, 2> seen_at(const Camera& camera, const Vec3& point) {
  const auto along = [&](const Vec3& axis) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += (point[i] - camera.position[i]) * axis[i];
    return sum;
  };
  const double ahead = along(camera.forward) * camera.half_height;
  REQUIRE(ahead > 0);
  return {along(camera.right) / (ahead * camera.aspect), along(camera.up) / ahead};
}

}  // namespace

TEST_CASE("picture: objects are where they stand, in their colours, and hide what is behind them") {
  const Scene scene = scene_of({colored(placed("", {0, 0, 0}, {1, 1, 1}), {0.9, 0.1, 0.1}),
                                colored(placed("", {2, 0, 0}, {1, 1, 1}), {0.1, 0.8, 0.1}),
                                colored(placed("", {4, 0, 0}, {1, 1, 1}), {0.1, 0.1, 0.9}),
                                placed("", {0.3, 0.3, 0.3}, {0.2, 0.2, 0.2})});  // within the first
  const Picture picture = Painter().draw(scene, kSmall);
  const auto pixels = pixels_of_objects(picture);
  CHECK(pixels.size() == 4);
  CHECK(pixels.contains(Picture::kNothing));
  CHECK_FALSE(pixels.contains(3));
  for (std::int32_t object = 0; object < 3; ++object) {
    const auto color = color_of(picture, object);
    const auto strongest = static_cast<std::size_t>(object);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != strongest) CHECK(color[strongest] > 1.5 * color[k]);
    }
  }
  // The middle of each top face is seen where the camera projects it.
  const Camera camera = default_camera(scene, 96.0 / 72);
  for (std::size_t object = 0; object < 3; ++object) {
    const auto [x, y] = seen_at(camera, {2.0 * static_cast<double>(object) + 0.5, 1, -0.5});
    const auto column = static_cast<std::size_t>((x + 1) / 2 * 96),
               row = static_cast<std::size_t>((1 - y) / 2 * 72);
    CHECK(picture.objects[row * 96 + column] == static_cast<std::int32_t>(object));
  }
}

TEST_CASE("picture: the same scene gives the same bytes, on any number of threads and after other scenes") {
  const Scene scene = scene_of(room());
  Painter one(1), three(3);
  const Picture first = one.draw(scene, kSmall);
  one.draw(scene_of({placed("chair", {0, 0, 0})}), kSmall);
  CHECK(png_bytes(one.draw(scene, kSmall).image) == png_bytes(first.image));
  CHECK(png_bytes(three.draw(scene, kSmall).image) == png_bytes(first.image));
  CHECK(three.draw(scene, kSmall).objects == first.objects);
}

TEST_CASE("picture: things cast shadows on what they stand on, darkest where they touch it") {
  const std::vector<PlacedThing> slab = {colored(placed("", {0, 0, 0}, {6, 6, 0.1}), {0.8, 0.8, 0.8})};
  std::vector<PlacedThing> with_box = slab;
  with_box.push_back(placed("", {2, 2, 0.1}, {2, 2, 1.5}));
  const Scene bare = scene_of(slab), full = scene_of(with_box);
  const PictureSize size{160, 120};
  const Camera camera = default_camera(full, 160.0 / 120);
  Painter painter;
  const Picture before = painter.draw(bare, size, camera), after = painter.draw(full, size, camera);
  const auto loss_at = [&](const Vec3& point) {
    const auto [x, y] = seen_at(camera, point);
    const auto column = static_cast<std::size_t>((x + 1) / 2 * 160),
               row = static_cast<std::size_t>((1 - y) / 2 * 120);
    REQUIRE(after.objects[row * 160 + column] == 0);
    return before.image.pixel(column, row)[1] - after.image.pixel(column, row)[1];
  };
  // The sun stands at the right: the shadow falls to the left. In front of the box there is only less sky.
  const int left = loss_at({0.9, 0.1, -3}), touching = loss_at({3, 0.1, -1.85}),
            far = loss_at({5.5, 0.1, -0.5});
  CHECK(left > 40);
  CHECK(touching > 5);
  CHECK(touching < left);
  CHECK(std::abs(far) <= 1);
}

TEST_CASE("picture: a box of glass lets the sun through, and a model that is painted over does not") {
  const auto on_slab = [](PlacedThing thing, const char* material) {
    if (material != nullptr) thing.extras.emplace_back("material", material);
    return scene_of({colored(placed("", {0, 0, 0}, {6, 6, 0.1}), {0.8, 0.8, 0.8}), thing});
  };
  const PlacedThing box = placed("", {2, 2, 0.1}, {2, 2, 1.5});
  const PictureSize size{160, 120};
  const Camera camera = default_camera(on_slab(box, nullptr), 160.0 / 120);
  const auto [x, y] = seen_at(camera, {0.9, 0.1, -3});  // where the box's shadow falls
  const auto column = static_cast<std::size_t>((x + 1) / 2 * 160),
             row = static_cast<std::size_t>((1 - y) / 2 * 120);
  const auto light = [&](const Scene& scene) {
    return static_cast<int>(Painter().draw(scene, size, camera).image.pixel(column, row)[1]);
  };
  const int open = light(scene_of({colored(placed("", {0, 0, 0}, {6, 6, 0.1}), {0.8, 0.8, 0.8})}));
  CHECK(light(on_slab(box, nullptr)) < open - 40);
  CHECK(light(on_slab(box, "\"glass\"")) == open);
  CHECK(light(on_slab(box, "\"oak\"")) < open - 40);
}

TEST_CASE("picture: what glass stands on is seen through its foot everywhere") {
  PlacedThing box = placed("", {2, 2, 0.1}, {2, 2, 1.5});
  box.extras.emplace_back("material", "\"glass\"");
  const Scene scene = scene_of({colored(placed("", {0, 0, 0}, {6, 6, 0.1}), {0.8, 0.8, 0.8}), box});
  const PictureSize size{320, 240};
  const Camera camera = default_camera(scene, 320.0 / 240);
  const Picture picture = Painter().draw(scene, size, camera);
  int darkest = 255, brightest = 0;
  for (double right = 2.1; right < 3.95; right += 0.05) {
    for (double deep = 2.1; deep < 3.95; deep += 0.05) {
      const auto [x, y] = seen_at(camera, {right, 0.1, -deep});
      const auto column = static_cast<std::size_t>((x + 1) / 2 * 320),
                 row = static_cast<std::size_t>((1 - y) / 2 * 240);
      REQUIRE(picture.objects[row * 320 + column] == 0);
      const int light = picture.image.pixel(column, row)[1];
      darkest = std::min(darkest, light), brightest = std::max(brightest, light);
    }
  }
  CHECK(brightest - darkest < 40);
}

TEST_CASE(
    "picture: the walls towards the camera are cut low, with their doors and windows and what is tall at "
    "them") {
  std::vector<PlacedThing> things = room();
  things.push_back(placed("window", {1, -0.15, 0.9}, {1.2, 0.2}));      // in the front wall
  things.push_back(placed("window", {1, 3.95, 0.9}, {1.2, 0.2}));       // in the back wall
  things.push_back(placed("door", {4.95, 1, 0}, {0.9, 0.2}, 1));        // in the right wall
  things.push_back(placed("bookcase", {2, 0.1, 0}, {1, 0.3}));          // tall and thin, but no wall
  things.push_back(placed("", {2, 1.6, 0}, {2, 0.1, 2}));               // a partition, though nobody says so
  things.push_back(named(placed("", {9, 9, 0}, {4, 0.1, 2}), "wall"));  // hides nothing
  things.push_back(placed("", {0.2, 0.0, 1.2}, {1, 0.05, 0.6}));        // hangs at the front wall
  things.push_back(placed("", {3.2, 0.05, 0}, {0.8, 0.4, 0.7}));        // stands there, but is low
  things.push_back(placed("", {3.5, 0.05, 0.7}, {0.2, 0.2, 0.4}));      // on that
  things.push_back(placed("cone", {1, -0.125, 2.5}, {0.15, 0.15, 0.3}));  // on the front wall
  things.push_back(placed("", {3, -1, 2.5}, {2, 1.9, 0.1}));              // on it, too, but much wider
  const Scene scene = scene_of(things);
  const auto cut = cut_heights(scene, three_quarter_view());
  std::set<std::size_t> low;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    if (!cut[i]) continue;
    low.insert(i);
    CHECK(*cut[i] == (i == 9 ? 0.8 : 0.3));
  }
  CHECK(low == std::set<std::size_t>{2, 4, 6, 8, 9, 10, 12, 15});

  const Picture picture = Painter().draw(scene_of(room()), kSmall);
  const auto pixels = pixels_of_objects(picture);
  CHECK(pixels.size() == 7);  // all objects, and nothing
  CHECK(pixels.at(1) > 2 * pixels.at(2));
  CHECK(pixels.at(5) > 50);
}

TEST_CASE("picture: what is cut ends at that height, and its cut is closed but for its openings") {
  const Box3 wall{{0, 0, 0}, {4, 2.5, 0.2}};
  const auto parts = solid_parts(wall, {{0.25, 0.5, 0, 0.8}, {0.5, 0.75, 0.4, 0.8}});  // a door and a window
  const Shape cut = cut_below(blocks(parts, {}), parts, Affine{}, 0.5);
  for (const Vector& point : cut.points) CHECK(point.y <= 0.5F);
  double lids = 0;
  for (const Shape::Triangle& triangle : cut.triangles) {
    if (triangle.finish + 1 != cut.finishes.size()) continue;
    const auto& [a, b, c] = triangle.corners;
    const Vector twice = cross(cut.points[b] - cut.points[a], cut.points[c] - cut.points[a]);
    CHECK(twice.x == 0);
    CHECK(twice.y > 0);
    lids += twice.y / 2;
  }
  CHECK(lids == doctest::Approx(3 * 0.2));  // 4 metres less the door's one
}

TEST_CASE("picture: seen from below or from the side nothing is cut") {
  const Scene scene = scene_of(room());
  for (const Vec3& view : {Vec3{0, -1, 0}, Vec3{0, 0, 1}}) {
    for (const auto& height : cut_heights(scene, view)) CHECK_FALSE(height);
  }
}

TEST_CASE("picture: the camera holds the whole scene, as near as it can") {
  for (const double aspect : {0.3, 1.0, 1.5, 4.0}) {
    const Scene scene =
        scene_of({placed("", {-3, 7, 0}, {1, 5, 2}), placed("tree", {10, -4, 1}, {2, 2, 9}, 1)});
    const Camera camera = default_camera(scene, aspect);
    double widest = 0, tallest = 0;
    for (const SceneObject& object : scene.objects) {
      const Box3 box = bounds(object.box);
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 point = box.corner(corner);
        const auto [x, y] = seen_at(camera, {point[0], point[2], -point[1]});
        widest = std::max(widest, std::abs(x));
        tallest = std::max(tallest, std::abs(y));
      }
    }
    CHECK(std::max(widest, tallest) <= 1);
    CHECK(std::max(widest, tallest) > 0.9);
  }
}

TEST_CASE(
    "picture: at eye height one stands in the room, in the open, sees what is in it, and nothing is cut") {
  std::vector<PlacedThing> things = room();
  for (const double x : {1.0, 2.0, 3.0}) things.push_back(placed("chair", {x, 2, 0}));
  const Scene scene = scene_of(things);
  TracedShapes shapes;
  const RayScene traced(shapes, scene, std::vector<std::optional<double>>(scene.objects.size()));
  const Camera camera = eye_view(scene, traced, 96.0 / 72);
  CHECK(camera.position[1] == doctest::Approx(1.6).epsilon(0.02));  // above a floor that is thin
  const double x = camera.position[0], y = -camera.position[2];
  CHECK((x > 0 && x < 5 && y > 0 && y < 4));
  for (std::size_t i = 1; i < scene.objects.size(); ++i) {
    const Box3 box = bounds(scene.objects[i].box);
    CAPTURE(i);
    CHECK_FALSE(
        (x > box.low[0] - 0.3 && x < box.high[0] + 0.3 && y > box.low[1] - 0.3 && y < box.high[1] + 0.3));
  }
  const auto pixels = pixels_of_objects(Painter().draw(scene, kSmall, Viewpoint::kEye));
  for (std::int32_t object = 5; object <= 8; ++object) CHECK(pixels.contains(object));
}

TEST_CASE("picture: at eye height something small is looked at by somebody small, and from outside") {
  const Scene scene = scene_of({placed("brick_4x2", {0, 0, 0}), placed("brick_2x2", {0, 0, 0.0096})});
  const Picture picture = Painter().draw(scene, kSmall, Viewpoint::kEye);
  CHECK(pixels_of_objects(picture).size() == 3);
  const Picture nothing = Painter().draw(scene_of({}), kSmall, Viewpoint::kEye);
  CHECK(pixels_of_objects(nothing).size() == 1);
}

TEST_CASE("picture: unusual scenes") {
  Painter painter;
  const auto draw = [&](const std::vector<PlacedThing>& things) {
    return painter.draw(scene_of(things), kSmall);
  };
  const auto empty = pixels_of_objects(draw({}));
  CHECK(empty == std::map<std::int32_t, std::size_t>{{Picture::kNothing, 96 * 72}});
  CHECK(pixels_of_objects(draw({placed("", {0, 0, 0}, {0, 0, 0})})).size() == 2);      // a speck
  CHECK(pixels_of_objects(draw({placed("", {0, 0, 0}, {3, 3, 0})})).size() == 2);      // a sheet
  CHECK(pixels_of_objects(draw({placed("", {9e6, 9e6, 0}, {1, 1, 1})})).size() == 2);  // far from the origin
  CHECK(pixels_of_objects(draw({placed("", {-9e6, 0, 0}, {9e6, 1e6, 1e5}),             // beyond all measure
                                placed("", {1e6, 0, 0}, {8e6, 1e6, 1e6})}))
            .size() == 3);
  CHECK(error_of([&] { painter.draw(scene_of({}), {0, 10}); }) != "");
  CHECK(error_of([&] { painter.draw(scene_of({}), {0, 10}, Viewpoint::kEye); }) != "");
  CHECK(error_of([&] { painter.draw(scene_of({}), {10, 0}); }) != "");
  CHECK(error_of([&] { painter.draw(scene_of({}), {1U << 20, 1U << 20}); }) != "");
}

TEST_CASE("picture: a hundred thousand boxes (slow)") {
  std::vector<PlacedThing> boxes;
  for (int i = 0; i < 100'000; ++i) {
    const double x = i % 400, y = i / 400;
    boxes.push_back(placed("", {x, y, 0}, {0.8, 0.8, 0.5 + (i * 7919 % 13) * 0.3}));
  }
  const auto pixels = pixels_of_objects(Painter().draw(scene_of(boxes), kSmall));
  CHECK(pixels.size() > 1000);
}

TEST_CASE("picture: models of strips and fans, without normals and with lines") {
  TemporaryFolder folder;
  for (const int mode : {4, 5, 6}) {
    json file = triangle_file(folder.path());
    file["meshes"][0]["primitives"][0]["mode"] = mode;
    write_file(folder / "sail.gltf", file.dump());
    AssetLibrary assets(kAssets, folder.path());
    const Scene scene = build_scene({placed("sail.gltf", {0, 0, 0})}, 1, "test", assets);
    CHECK(pixels_of_objects(Painter().draw(scene, kSmall))[0] > 100);
  }
}

TEST_CASE("picture: a PNG is read as it was written, and a broken one is an error that names it") {
  TemporaryFolder folder;
  Image image(3, 2);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = static_cast<std::uint8_t>(i * 14);
  write_file(folder / "a.png", png_bytes(image));
  CHECK(read_png(folder / "a.png") == image);
  write_file(folder / "b.png", png_bytes(image).substr(0, 40));
  CHECK(error_of([&] { read_png(folder / "b.png"); }).find("b.png") != std::string::npos);
  CHECK(error_of([&] { read_png(folder / "c.png"); }).find("c.png") != std::string::npos);
}

TEST_CASE("picture: scaling down takes means, and keeps what is small enough") {
  Image image(3, 2);
  for (std::size_t x = 0; x < 3; ++x) {
    for (std::size_t y = 0; y < 2; ++y) image.pixel(x, y)[0] = static_cast<std::uint8_t>(60 * x + 30 * y);
  }
  const Image half = scaled_down(image, 2);
  CHECK(half.width == 2);
  CHECK(half.height == 1);
  CHECK(half.pixel(0, 0)[0] == 35);  // (2 * 0 + 60 + 2 * 30 + 90) / 6
  CHECK(half.pixel(1, 0)[0] == 115);
  CHECK(scaled_down(image, 3) == image);
}

TEST_CASE("picture: a run's pictures and their contact sheet") {
  TemporaryFolder folder;
  PictureFiles files(folder.path(), {40, 30}, 1);
  for (int i = 0; i < 3; ++i)
    CHECK(files.draw(scene_of({placed("chair", {0, 0, 0}, {}, i)}), fmt::format("a-{}", i)) ==
          fmt::format("a-{}.png", i));
  files.close();
  const Image sheet = read_png(folder / "sheet.png");
  CHECK(sheet.width == 84);
  CHECK(sheet.height == 64);
  const Image second = read_png(folder / "a-1.png"), third = read_png(folder / "a-2.png");
  for (const auto& [x, y] : {std::pair<std::size_t, std::size_t>{20, 15}, {3, 28}}) {
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(sheet.pixel(x + 44, y)[k] == second.pixel(x, y)[k]);
      CHECK(sheet.pixel(x, y + 34)[k] == third.pixel(x, y)[k]);
    }
  }

  // A resumed run takes the pictures up that are there, and draws those that are missing or of another size.
  write_file(folder / "a-1.png", png_bytes(Image(40, 30)));
  write_file(folder / "a-2.png", png_bytes(Image(50, 30)));
  PictureFiles resumed(folder.path(), {40, 30}, 1);
  for (int i = 0; i < 3; ++i)
    resumed.take_up(scene_of({placed("chair", {0, 0, 0}, {}, i)}), fmt::format("a-{}", i));
  CHECK(read_png(folder / "a-1.png") == Image(40, 30));
  CHECK(read_png(folder / "a-2.png") == third);
}

}  // namespace solitaire
