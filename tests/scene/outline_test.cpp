// Shapes that stand on an outline.
#include "scene/outline.h"

#include <random>

#include "scene/gltf/writer.h"
#include "scene/page/drawing/plan.h"
#include "scene/picture/picture.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

PlacedThing on_outline(const std::string& points, std::array<double, 3> at = {0, 0, 0}) {
  PlacedThing thing = placed("lake", at);
  thing.extras.emplace_back("outline", points);
  return thing;
}

/// The volume below the faces of a closed surface, by the divergence theorem.
double volume(const std::vector<std::vector<Vec3>>& faces) {
  double sum = 0;
  for (const auto& face : faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Vec3 &a = face[0], &b = face[i - 1], &c = face[i];
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return sum / 6;
}

double area(const Outline& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return std::abs(sum) / 2;
}

constexpr const char* kArrow = "[[0, 0], [4, 0], [4, 3], [2, 1], [0, 3]]";

}  // namespace

TEST_CASE(
    "outline: a body over it has the outline's area for its volume, whichever way its points go round") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.2, 1);
  for (int round = 0; round < 200; ++round) {
    Outline star;  // seen from the origin, its points go round: it never crosses itself
    const int corners = 3 + round % 12;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.2832 * i / corners, r = radius(random);
      star.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    if (round % 2 == 1) std::reverse(star.begin(), star.end());
    CHECK(fault_of(star) == std::string());
    const Outline unit = in_unit_square(star);
    CHECK(volume(faces_over(unit)) == doctest::Approx(area(unit)));
  }
  const Outline with_flat_corner = in_unit_square({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}});
  CHECK(volume(faces_over(with_flat_corner)) == doctest::Approx(1));
}

TEST_CASE("outline: what is none is an error that says why") {
  AssetLibrary assets = bundled();
  const auto error = [&](PlacedThing thing) -> std::string {
    try {
      build_scene({std::move(thing)}, 1, "test", assets);
    } catch (const SceneError& thrown) {
      return thrown.what();
    }
    return "";
  };
  const auto says = [&](const std::string& points, const std::string& why) {
    return error(on_outline(points)).find(why) != std::string::npos;
  };
  CHECK(says("[[0, 0], [1, 0]]", "has fewer than three points"));
  CHECK(says("[[0, 0], [2, 2], [2, 0], [0, 2]]", "cross or touch"));
  CHECK(says("[[0, 0], [2, 0], [1, 0]]", "cross or touch"));
  CHECK(says("[[0, 0], [0, 0], [1, 0], [0, 1]]", "cross or touch"));
  CHECK(says("[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]", "cross or touch"));
  CHECK(says("[[0, 0, 0], [2, 0], [1, 1]]", "list of points"));
  CHECK(says("7", "list of points"));
  PlacedThing sized = on_outline(kArrow);
  sized.size = {1, 1, 1};
  CHECK(error(sized).find("stands beside 'size'") != std::string::npos);
  PlacedThing chair = on_outline(kArrow);
  chair.asset = "chair";
  CHECK(error(chair).find("no model") != std::string::npos);
  CHECK(error(on_outline(kArrow)).empty());
}

TEST_CASE("outline: it lies where its points say, in files, plans and pictures") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  PlacedThing arrow = on_outline("[[1, 2], [5, 2], [5, 5], [3, 3], [1, 5]]", {10, 20, 0});
  arrow.extras.emplace_back("extrude", "0.5");
  arrow.extras.emplace_back("label", "\"Lake\"");
  const Scene scene = build_scene({arrow}, 2, "test", assets);
  check_point(scene.objects[0].box.center, {26, 47, 0});
  check_point(scene.objects[0].box.size, {8, 6, 1});
  write_glb(scene, folder / "a.glb");  // which reads it back
  const json file = json_of(read_file(folder / "a.glb"));
  const auto& mesh = file["meshes"][node_named(file, "lake")["mesh"].get<std::size_t>()];
  const auto& indices = file["accessors"][mesh["primitives"][0]["indices"].get<std::size_t>()];
  CHECK(indices["count"] == 3 * (3 + 3 + 2 * 5));
  CHECK(node_named(file, "lake")["extras"]["label"] == "Lake");
  const std::string plan = svg_plan(scene);
  CHECK(plan.find("<polygon") != std::string::npos);
  CHECK(plan.find("Lake") != std::string::npos);

  // From above, a picture shows ground in the notch, and the lake beside it.
  const Camera above = fitted_camera({{22, 0, -44}, {30, 0, -50}}, {0, 0.999, 0.0447}, 1);
  const Picture picture = Painter().draw(scene, {60, 60}, above);
  const auto lake = std::count(picture.objects.begin(), picture.objects.end(), 0);
  const double share = static_cast<double>(lake) / 3600;
  CHECK(share > 0.25);
  CHECK(share < 0.65);
}

}  // namespace solitaire
