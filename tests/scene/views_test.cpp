// Levels, views from the sides, isometric views.
#include "scene/page/drawing/views.h"

#include <algorithm>

#include "scene/page/drawing/levels.h"
#include "scene/page/drawing/paper.h"
#include "scene/page/drawing/solids.h"
#include "tests/scene/fixture.h"

namespace solitaire {

namespace {

PlacedThing named(const std::string& name, std::array<double, 3> at, std::vector<double> size) {
  PlacedThing thing = placed("", at, std::move(size));
  thing.name = name;
  thing.address = name;
  return thing;
}

/// A house with two storeys and a roof.
std::vector<PlacedThing> house() {
  return {named("ground", {0, 0, 0}, {6, 5, 0.2}),       named("table", {1, 1, 0.2}, {2, 1, 0.75}),
          named("lamp", {1.5, 1, 2.2}, {1, 1, 0.2}),     named("upper floor", {0, 0, 2.8}, {6, 5, 0.2}),
          named("bed", {3, 2, 3}, {2, 1, 0.5}),          named("roof", {0, 0, 5.6}, {6, 5, 0.2}),
          named("shelf", {0, 4, 2.1}, {0.5, 0.3, 0.05}), named("vase", {0.1, 4.1, 2.15}, {0.1, 0.1, 0.3})};
}

std::vector<std::string> names(const Scene& scene, const std::vector<std::size_t>& indices) {
  std::vector<std::string> names;
  for (const std::size_t index : indices) names.push_back(scene.objects[index].thing.name);
  return names;
}

/// The addresses in the order in which a drawing shows them.
std::vector<std::string> order_of(const std::string& svg) {
  constexpr std::string_view kMark = "data-address=\"";
  std::vector<std::string> order;
  for (auto at = svg.find(kMark); at != std::string::npos; at = svg.find(kMark, at + 1)) {
    const auto from = at + kMark.size();
    order.push_back(svg.substr(from, svg.find('"', from) - from));
  }
  return order;
}

std::string element_of(const std::string& svg, const std::string& address) {
  const auto at = svg.find("data-address=\"" + address + "\"");
  REQUIRE(at != std::string::npos);
  return svg.substr(at, svg.find("</g>\n", at) - at);
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("levels: a floor that carries something begins one, and a roof or a shelf does not") {
  AssetLibrary assets = bundled();
  const Scene scene = build_scene(house(), 1, "house", assets);
  const std::vector<Level> levels = levels_of(scene);
  REQUIRE(levels.size() == 2);
  CHECK(levels[0].floor == 0);
  CHECK(levels[1].floor == doctest::Approx(2.8));
  CHECK(names(scene, levels[0].standing) == Names{"ground", "table"});
  CHECK(names(scene, levels[0].overhead) == Names{"lamp", "shelf", "vase"});
  CHECK(names(scene, levels[1].standing) == Names{"upper floor", "bed"});
  CHECK(names(scene, levels[1].overhead) == Names{"roof"});
  CHECK(levels_of(build_scene({}, 1, "none", assets)).empty());
}

TEST_CASE("levels: what hangs above nothing stands for itself, and a stack of small things is one level") {
  AssetLibrary assets = bundled();
  const Scene scene = build_scene({named("low", {0, 0, 0}, {1, 1, 1}), named("kite", {5, 5, 9}, {1, 1, 0.1}),
                                   named("block", {0, 0, 1}, {1, 1, 1}), named("top", {0, 0, 2}, {1, 1, 1})},
                                  1, "stack", assets);
  const std::vector<Level> levels = levels_of(scene);
  REQUIRE(levels.size() == 1);
  CHECK(names(scene, levels[0].standing) == Names{"low", "kite", "block"});
  CHECK(names(scene, levels[0].overhead) == Names{"top"});
}

TEST_CASE("views: a plan of each level, both sides, and last the isometric one") {
  AssetLibrary assets = bundled();
  const Scene scene = build_scene(house(), 1, "house", assets);
  const std::vector<View> views = views_of(scene);
  Names titles;
  for (const View& view : views) titles.push_back(view.title);
  CHECK(titles == Names{"Plan from 0 m", "Plan from 2.8 m", "From the front", "From the right", "Isometric"});
  CHECK(order_of(views[0].svg) == Names{"ground", "table", "lamp", "shelf", "vase"});
  CHECK(element_of(views[0].svg, "lamp").find("stroke-dasharray") != std::string::npos);
  CHECK(element_of(views[0].svg, "table").find("stroke-dasharray") == std::string::npos);
  CHECK(element_of(views[0].svg, "table").find("75 cm high, from 20 cm") != std::string::npos);
  CHECK(element_of(views[0].svg, "table").find(">75 cm</tspan>") != std::string::npos);
  CHECK(views_of(build_scene({}, 1, "none", assets)).empty());
}

TEST_CASE("views: from the side, near things cover far ones, and a wall before something is an outline") {
  AssetLibrary assets = bundled();
  const std::vector<PlacedThing> things = {
      named("front wall", {0, 0, 0}, {4, 0.1, 2.5}), named("near", {1, 1, 0}, {1, 1, 1}),
      named("far", {2.5, 2.5, 0}, {1, 1, 2}), named("back wall", {0, 4, 0}, {4, 0.1, 2.5})};
  const Scene scene = build_scene(things, 1, "room", assets);
  const std::string front = svg_elevation(scene, Side::kFront);
  CHECK(order_of(front) == Names{"back wall", "far", "near", "front wall"});
  CHECK(element_of(front, "front wall").find("fill=\"none\"") != std::string::npos);
  CHECK(element_of(front, "back wall").find("fill=\"none\"") == std::string::npos);
  // 4 m are 400 units; the thing at 2.5 m begins at 250, and is as high as half of them.
  CHECK(element_of(front, "far").find("<rect x=\"250\" y=\"50\" width=\"100\" height=\"200\"") !=
        std::string::npos);
  for (const char* height : {">0 m<", ">1 m<", ">2 m<"}) CHECK(front.find(height) != std::string::npos);
  CHECK(front.find(">3 m<") == std::string::npos);
  const std::string right = svg_elevation(scene, Side::kRight);
  CHECK(order_of(right) == Names{"near", "far", "front wall", "back wall"});
}

TEST_CASE("views: an isometric one draws what lies behind or below before what covers it") {
  AssetLibrary assets = bundled();
  const auto order = [&](const std::vector<PlacedThing>& things) {
    return order_of(svg_isometric(build_scene(things, 1, "test", assets)));
  };
  const PlacedThing floor = named("floor", {-50, -50, -0.1}, {100, 100, 0.1});
  const PlacedThing table = named("table", {0, 0, 0}, {2, 2, 1}),
                    cup = named("cup", {0.1, 1.7, 1}, {0.2, 0.2, 0.2});
  const PlacedThing behind = named("behind", {0, 3, 0}, {2, 2, 3}),
                    left = named("left", {-3, 0, 0}, {2, 2, 3});
  CHECK(order({cup, table, floor}) == Names{"floor", "table", "cup"});
  const Names all = order({cup, table, behind, left, floor});
  const auto place = [&](const char* name) { return std::ranges::find(all, name) - all.begin(); };
  CHECK(place("floor") == 0);
  CHECK(place("behind") < place("table"));
  CHECK(place("left") < place("table"));
  CHECK(place("table") < place("cup"));
}

TEST_CASE("views: an isometric one shows three sides of a box, and cuts the walls before something") {
  AssetLibrary assets = bundled();
  const Scene scene =
      build_scene({named("front wall", {0, 0, 0}, {4, 0.1, 2.5}), named("box", {1, 1, 0}, {1, 1, 1}),
                   named("back wall", {0, 4, 0}, {4, 0.1, 2.5})},
                  1, "room", assets);
  const std::string svg = svg_isometric(scene);
  const auto polygons = [&](const char* address) {
    const std::string element = element_of(svg, address);
    std::size_t count = 0;
    for (auto at = element.find("<polygon"); at != std::string::npos; at = element.find("<polygon", at + 1))
      ++count;
    return count;
  };
  for (const char* address : {"front wall", "box", "back wall"}) CHECK(polygons(address) == 3);
  const std::string cut = hex({0.23, 0.24, 0.26});
  CHECK(element_of(svg, "front wall").find(cut) != std::string::npos);
  CHECK(element_of(svg, "back wall").find(cut) == std::string::npos);
}

TEST_CASE("views: lengths for people") {
  CHECK(length_text(0) == "0 m");
  CHECK(length_text(2.8) == "2.8 m");
  CHECK(length_text(0.75) == "75 cm");
  CHECK(length_text(-0.2) == "-20 cm");
  CHECK(length_text(0.0032) == "3.2 mm");
  CHECK(length_text(1500) == "1.5 km");
  CHECK(round_length(7) == 5);
  CHECK(round_length(4.9) == 2);
  CHECK(round_length(0.19) == doctest::Approx(0.1));
}

}  // namespace solitaire
