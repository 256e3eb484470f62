#include "bench/tiles/problems.h"

#include "engines/tiles/learn/divergence.h"
#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/request/build.h"

namespace solitaire::tiles::bench {
namespace {

TileMask named(const Style& style, const std::string& name) {
  return TileMask::of(style.tileset.find(name).value());
}

/// Leaves the sky to the sites where `is_sky(x, y)` holds, and all but the sky to the others.
template <class IsSky>
Problem with_outline(std::shared_ptr<const Style> style, int width, int height, IsSky is_sky) {
  const TileMask sky = named(*style, "·");
  TileMask wall = TileMask::first(style->tileset.size());
  wall.erase(sky.lowest());
  Problem problem(std::move(style), {{{width, height, 1}}, {}});
  SiteRule above{"the sky", {}, sky}, house{"the outline of the house", {}, wall};
  for_each_point(problem.size(), [&](const Point& at) {
    SiteRule& rule = is_sky(at[0], at[1]) ? above : house;
    rule.sites.push_back(static_cast<std::uint32_t>(problem.size().site(at)));
  });
  problem.add(std::move(above));
  problem.add(std::move(house));
  return problem;
}

}  // namespace

const Size kFourAcross{{4, 1, 1}}, kFourDown{{1, 4, 1}};

std::shared_ptr<Style> style_named(const std::string& name) {
  Request request;
  request.exemplars.push_back({SOLITAIRE_SOURCE_DIR "/" + name + ".txt", "", false, false});
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
  return with_outline(std::move(style), width, height,
                      [=](int x, int y) { return y + 1 < height && (x == 0 || x + 1 == width || y == 0); });
}

Problem facade_in_l(std::shared_ptr<const Style> style, int side) {
  return with_outline(std::move(style), side, side, [=](int x, int y) {
    const bool in_corner = x >= side / 2 && y < side / 2;
    return y + 1 < side && (x == 0 || x + 1 == side || y == 0 || in_corner);
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
