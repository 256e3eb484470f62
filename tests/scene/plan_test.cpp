// The plan and the gallery page.
#include "scene/page/drawing/plan.h"

#include <cstdio>

#include "scene/page/gallery.h"
#include "scene/text.h"
#include "tests/scene/fixture.h"

namespace solitaire {

namespace {

/// What stands in a plan, in the order of drawing.
struct Drawn {
  double x = 0, y = 0, turn = 0, width = 0, depth = 0;
  double label_size = 0, label_turn = 0;  // no label: size 0
};

std::vector<Drawn> drawn_objects(const std::string& svg) {
  std::vector<Drawn> objects;
  const auto scan = [](const char* text, const char* format, auto... targets) {
    std::sscanf(text, format, targets...);
  };
  for (auto at = svg.find("<g data-address="); at != std::string::npos;
       at = svg.find("<g data-address=", at + 1)) {
    const std::string one = svg.substr(at, svg.find("\n<", svg.find("</title>", at)) - at);
    Drawn object;
    double ignored = 0;
    scan(one.c_str() + one.find("<g transform"), "<g transform=\"translate(%lf %lf) rotate(%lf)", &object.x,
         &object.y, &object.turn);
    scan(one.c_str() + one.find("<rect"), "<rect x=\"%lf\" y=\"%lf\" width=\"%lf\" height=\"%lf\"", &ignored,
         &ignored, &object.width, &object.depth);
    const auto label = one.find("</g><text");
    if (label != std::string::npos) {
      scan(one.c_str() + label, "</g><text transform=\"translate(%lf %lf) rotate(%lf)", &ignored, &ignored,
           &object.label_turn);
      scan(one.c_str() + one.find("font-size", label), "font-size=\"%lf\"", &object.label_size);
    }
    objects.push_back(object);
  }
  return objects;
}

}  // namespace

TEST_CASE("plan: true proportions, y up, small and high things on top") {
  AssetLibrary assets = bundled();
  PlacedThing turned = placed("", {0, 0, 1}, {2, 1, 1});
  turned.angle = 30;
  const auto objects = drawn_objects(svg_plan(build_scene(
      {turned, placed("", {3, 1, 0}, {1, 1}), placed("", {0, 0, 0}, {4, 2})}, 1, "test", assets)));
  REQUIRE(objects.size() == 3);
  const Drawn &ground = objects[0], &box = objects[1];
  const double scale = ground.width / 4;
  CHECK(ground.depth == doctest::Approx(2 * scale));
  CHECK(box.width == doctest::Approx(scale));
  CHECK(box.x == doctest::Approx(ground.x + 1.5 * scale).epsilon(1e-4));
  CHECK(box.y == doctest::Approx(ground.y - 0.5 * scale).epsilon(1e-4));
  CHECK(objects[2].turn == -30);  // SVG counts clockwise
}

TEST_CASE("plan: labels stay within their shapes, and are left out where there is no room") {
  AssetLibrary assets = bundled();
  std::vector<PlacedThing> placements;
  const std::string name(4, 'W');
  for (int i = 0; i < 12; ++i) {
    placements.push_back(placed("", {i * 3.0, 0, 0}, {0.2 + 0.25 * i, 3.0 - 0.2 * i}));
    placements.back().name = name;
  }
  const auto objects = drawn_objects(svg_plan(build_scene(placements, 1, "test", assets)));
  CHECK(objects.size() == 12);
  std::size_t level = 0, upright = 0;
  for (const Drawn& object : objects) {
    if (object.label_size == 0) continue;
    const bool is_level = object.label_turn == 0;
    ++(is_level ? level : upright);
    CHECK(text_width(name) * object.label_size <= (is_level ? object.width : object.depth));
    CHECK(object.label_size <= (is_level ? object.depth : object.width));
  }
  CHECK(level > 0);
  CHECK(upright > 0);
  CHECK(level + upright < 12);
}

TEST_CASE("plan and gallery: names are escaped, whatever they hold") {
  AssetLibrary assets = bundled();
  PlacedThing placement = placed("", {0, 0, 0}, {2, 1});
  placement.name = "<script>\"&'\xff\x02";
  placement.address = "a<b>";
  const std::string plan = svg_plan(build_scene({placement}, 1, "t<i>tle", assets));
  const std::string page =
      gallery_html({"t<i>tle", "a&b.sol", "\"1\"", {{"<o>", "<v>"}}, "{\"<b>\":\"</script>\"}"},
                   {{1,
                     placement.name,
                     "a<b>.svg",
                     "a \"b\":#ü.glb",
                     "j.json",
                     "<v>&",
                     2,
                     {"cost <5>"},
                     "",
                     "{\"value\":\"<b>\"}"}});
  for (const std::string& text : {plan, page}) {
    CHECK(text.find("<script>") == std::string::npos);
    CHECK(text.find("<i>") == std::string::npos);
    CHECK(text.find("<b>") == std::string::npos);
    CHECK(text.find("<v>") == std::string::npos);
    CHECK(text.find('\xff') == std::string::npos);
    CHECK(text.find('\x02') == std::string::npos);
    CHECK(text.find("&lt;script&gt;&quot;&amp;&#39;\uFFFD ") != std::string::npos);
  }
  CHECK(page.find("href=\"./a%20%22b%22%3A%23%C3%BC.glb\"") != std::string::npos);
}

TEST_CASE("gallery: a picture stands before the plan, whatever its name") {
  const std::string page =
      gallery_html({"t", "", "", {}}, {{1, "n", "page/n.svg", "n.glb", "n.json", "", 0, {}, "a \"b\".png"}});
  CHECK(page.find("<img src=\"./a%20%22b%22.png\" alt=\"Picture of n\"") != std::string::npos);
  CHECK(page.find("page/n.svg") == std::string::npos);
  const std::string drawn =
      gallery_html({"t", "", "", {}}, {{1, "n", "page/n.svg", "n.glb", "n.json", "", 0, {}, ""}});
  CHECK(drawn.find("<img src=\"./page/n.svg\" alt=\"Drawing of n\"") != std::string::npos);
}

TEST_CASE("gallery: entries in the given order, the value in place of a plan, nothing from elsewhere") {
  const std::string page =
      gallery_html({"queens", "queens.sol", "7", {}},
                   {{2, "queens-0002", "", "", "queens-0002.json", "[1, 3]", 4, {}, ""},
                    {1, "queens-0001", "", "", "queens-0001.json", "[2, 0]", 1, {}, ""}});
  CHECK(page.find("queens-0002") < page.find("queens-0001"));
  CHECK(page.find("<p class=\"value alone\">[1, 3]</p>") != std::string::npos);
  CHECK(page.find("4 choices") != std::string::npos);
  CHECK(page.find("1 choice<") != std::string::npos);
  CHECK(page.find(".glb") == std::string::npos);
  CHECK(page.find("http") == std::string::npos);
  const auto next = [&](const char* what, std::size_t from) { return page.find(what, from); };
  CHECK(next("src=\"", 0) == next("src=\"./page/page.js\"", 0));
  CHECK(next("src=", next("src=", 0) + 1) == std::string::npos);
  CHECK(gallery_html({"t", "", "", {}}, {}).find("No solution.") != std::string::npos);
}

}  // namespace solitaire
