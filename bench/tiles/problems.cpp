#include "bench/tiles/problems.h"

#include <map>

#include "engines/tiles/learn/divergence.h"
#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/request/read_style.h"

namespace solitaire::tiles::bench {
namespace {

TileMask named(const Style& style, const std::string& name) {
  return TileMask::of(style.tileset.find(name).value());
}

/// Leaves to each site the tiles of its part of the outline, the name of which `part_at(x, y)` gives: the
/// sky, the ground, or the house.
template <class PartAt>
Problem with_outline(std::shared_ptr<const Style> style, int width, int height, PartAt part_at) {
  TileMask house = TileMask::first(style->tileset.size());
  house.erase(named(*style, "·").lowest());
  house.erase(named(*style, "_").lowest());
  std::map<std::string, SiteRule> rules{{"sky", {"the sky", {}, named(*style, "·")}},
                                        {"ground", {"the ground", {}, named(*style, "_")}},
                                        {"house", {"the outline of the house", {}, house}}};
  Problem problem(std::move(style), {{{width, height, 1}}, {}});
  for_each_point(problem.size(), [&](const Point& at) {
    rules.at(part_at(at[0], at[1])).sites.push_back(static_cast<std::uint32_t>(problem.size().site(at)));
  });
  for (auto& [name, rule] : rules) problem.add(std::move(rule));
  return problem;
}

}  // namespace

const Size kFourAcross{{4, 1, 1}}, kFourDown{{1, 4, 1}};

std::shared_ptr<Style> style_named(const std::string& name) {
  Request request;
  request.exemplars.push_back({SOLITAIRE_SOURCE_DIR "/" + name + ".txt", "", false, {}});
  return read_style(request);
}

std::shared_ptr<Style> step_style(const std::string& name, const std::vector<Size>& shapes, double epsilon) {
  const std::shared_ptr<Style> style = style_named(name);
  for (const Size& shape : shapes) add_step_shape(*style, shape, epsilon);
  return style;
}

double divergence_of_fours(const Style& style, const std::vector<Grid>& maps) {
  return (divergence(style, maps, kFourAcross).kullback_leibler +
          divergence(style, maps, kFourDown).kullback_leibler) /
         2;
}

double shannon_of_fours(const Style& style, const std::vector<Grid>& maps) {
  return (divergence(style, maps, kFourAcross).jensen_shannon +
          divergence(style, maps, kFourDown).jensen_shannon) /
         2;
}

Problem facade(std::shared_ptr<const Style> style, int width, int height) {
  return with_outline(std::move(style), width, height, [=](int x, int y) {
    const bool beside = x == 0 || x + 1 == width || y == 0;
    return y + 1 == height ? "ground" : beside ? "sky" : "house";
  });
}

Problem facade_in_l(std::shared_ptr<const Style> style, int side) {
  return with_outline(std::move(style), side, side, [=](int x, int y) {
    const bool beside = x == 0 || x + 1 == side || y == 0 || (x >= side / 2 && y < side / 2);
    return y + 1 == side ? "ground" : beside ? "sky" : "house";
  });
}

Problem city(std::shared_ptr<const Style> style, int side) {
  const TileMask crossroad = named(*style, "╋");
  Problem problem(std::move(style), {{{side, side, 1}}, {}});
  for (int y = 10; y < side; y += 20) {
    for (int x = 10; x < side; x += 20) {
      problem.add({"a crossroad", {static_cast<std::uint32_t>(problem.size().site({x, y, 0}))}, crossroad});
    }
  }
  return problem;
}

}  // namespace solitaire::tiles::bench
