#include "engines/tiles/sample/sampler.h"

#include <doctest/doctest.h>

#include "engines/tiles/check/check.h"
#include "engines/tiles/learn/divergence.h"
#include "engines/tiles/learn/fit.h"
#include "engines/tiles/request/build.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/request_file.h"
#include "engines/tiles/rules/connected.h"
#include "engines/tiles/rules/tile_count.h"
#include "tests/tiles/enumeration.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

Sample sample(const Problem& problem, const SamplerOptions& options, std::uint64_t number = 1) {
  return draw_sample(problem, consistent_domains(problem), options, number, StopSignal());
}

std::shared_ptr<Style> example(const std::string& name) {
  return read_style(
      read_request(std::string(SOLITAIRE_SOURCE_DIR "/examples/tiles/") + name + ".tiles.json"));
}

TEST_CASE("whatever a sampler makes keeps all rules") {
  const std::shared_ptr<Style> style = style_of(kStreets);
  add_step_shape(*style, {{2, 2, 1}}, 0.1);
  for (const SamplerKind kind :
       {SamplerKind::kWindows, SamplerKind::kBlockSs, SamplerKind::kWfc, SamplerKind::kRaster,
        SamplerKind::kMh, SamplerKind::kGibbs, SamplerKind::kSearch}) {
    CAPTURE(static_cast<int>(kind));
    SamplerOptions options;
    options.kind = kind;
    if (kind == SamplerKind::kMh || kind == SamplerKind::kGibbs) options.effort = 300'000;
    Problem problem(style, flat(6, 5));
    problem.add({"the corner", {0}, TileMask::of(*style->tileset.find("#"))});
    std::size_t found = 0;
    for (std::uint64_t number = 1; number <= 5; ++number) {
      const Sample made = sample(problem, options, number);
      if (made.outcome != Outcome::kFound) continue;
      ++found;
      CHECK(find_faults(problem, made.map).empty());
      CHECK(sample(problem, options, number).map == made.map);  // the same number gives the same map
    }
    CHECK(found > 0);
  }
}

TEST_CASE("windows with too many ways to fill them are redrawn in parts") {
  std::string exemplar;
  RandomStream random(5, Purpose::kTiles, 0);
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 60; ++column) exemplar += static_cast<char>('a' + random.below(24));
    exemplar += '\n';
  }
  Problem problem(style_of(exemplar), flat(8, 8));
  // A rule about the whole map makes the windows boxes.
  problem.add(std::make_shared<TileCount>(TileMask::of(0), 0, 40, "there are at most 40 of one"));
  SamplerOptions options;
  options.anneal = 0;
  options.sweeps = 2;
  const Sample made = sample(problem, options);
  CHECK(made.windows > 0);
  CHECK(made.left == 0);
  CHECK(find_faults(problem, made.map).empty());
}

TEST_CASE("BlockSS fulfils its slice at once where it does not start anew") {
  const std::shared_ptr<Style> style = style_of(kStreets);
  add_step_shape(*style, {{2, 2, 1}}, 0.1);
  const Problem problem(style, flat(10, 10));
  SamplerOptions options;
  options.kind = SamplerKind::kBlockSs;
  options.restart = false;
  options.burn_in = 0;
  const Grid first = sample(problem, options).map;
  options.burn_in = 20;
  CHECK(sample(problem, options).map == first);
  options.restart = true;
  CHECK(sample(problem, options).map != first);
}

TEST_CASE("all sides meet on a map that is periodic") {
  Topology topology = flat(13, 11);
  topology.periodic = {true, true, false};
  const std::shared_ptr<Style> style = example("suburb");
  add_step_shape(*style, {{2, 2, 1}}, 0.5);
  const Problem problem(style, topology);
  SamplerOptions options;
  options.anneal = 10;
  options.sweeps = 10;
  const Sample made = sample(problem, options);
  REQUIRE(made.outcome == Outcome::kFound);
  CHECK(made.left == 0);
  CHECK(find_faults(problem, made.map).empty());
}

TEST_CASE("fitted weights make tiles as frequent as in the exemplar (slow)") {
  const std::shared_ptr<Style> style = example("suburb"), plain = example("suburb");
  const std::vector<Size> shapes = default_shapes(*style);
  fit_weights(*style, shapes, 1, StopSignal());
  std::vector<Grid> fitted, uniform;
  for (std::uint64_t number = 1; number <= 2; ++number) {
    fitted.push_back(sample(Problem(style, flat(40, 40)), {}, number).map);
    uniform.push_back(sample(Problem(plain, flat(40, 40)), {}, number).map);
  }
  for (const Size& shape : {Size{{1, 1, 1}}, Size{{2, 1, 1}}, Size{{1, 2, 1}}, Size{{2, 2, 1}}}) {
    const double near = divergence(*style, fitted, shape).jensen_shannon;
    CHECK(near < (shape.volume() == 1 ? 0.01 : 0.03));
    CHECK(divergence(*style, uniform, shape).jensen_shannon > 2 * near);
  }
}

TEST_CASE("a connected dungeon has the counts and the border that are asked for (slow)") {
  Request request = read_request(SOLITAIRE_SOURCE_DIR "/examples/tiles/dungeon.tiles.json");
  const std::shared_ptr<Style> style = read_style(request);
  fit_weights(*style, default_shapes(*style), 1, StopSignal());
  request.size = {24, 20, 1};
  const Problem problem = make_problem(request, style);
  SamplerOptions options;
  options.anneal = 60;
  options.sweeps = 20;
  options.effort = 2000;
  const Sample made = sample(problem, options);
  REQUIRE(made.outcome == Outcome::kFound);
  CHECK(find_faults(problem, made.map).empty());
  CHECK(made.refused > 0);
}

TEST_CASE("connectivity counts components, by the sides that are open") {
  const std::shared_ptr<Style> style = style_of("._|\n_.|\n");
  const auto open = [&](const std::string& name, Sides sides, std::vector<Sides>& all) {
    all[*style->tileset.find(name)] = sides;
  };
  std::vector<Sides> sides(style->tileset.size());
  open("_", static_cast<Sides>(side(0, 1) | side(0, -1)), sides);
  const auto map = [&](const char* text) { return read_text("map", text, style->tileset, false); };
  const Topology two_rows = flat(4, 2);
  CHECK(Connected(two_rows, sides, "").violation(map("....\n....\n")) == 0);
  CHECK(Connected(two_rows, sides, "").violation(map("____\n....\n")) == 0);
  CHECK(Connected(two_rows, sides, "").violation(map("__._\n..._\n")) == 2);
  // Rows are not linked, for nothing is open up or down.
  CHECK(Connected(two_rows, sides, "").violation(map("____\n____\n")) == 1);
  Topology ring = two_rows;
  ring.periodic[0] = true;
  CHECK(Connected(two_rows, sides, "").violation(map("_.._\n....\n")) == 1);
  CHECK(Connected(ring, sides, "").violation(map("_.._\n....\n")) == 0);
}

TEST_CASE("the connected maps of a small grid come as often as enumeration says (slow)") {
  const std::shared_ptr<Style> style = style_of(kStreets);
  add_step_shape(*style, {{2, 2, 1}}, 0.5);
  Problem problem(style, flat(3, 2));
  std::vector<Sides> open(style->tileset.size());
  open[*style->tileset.find("#")] = kAllSides;
  problem.add(std::make_shared<Connected>(problem.topology(), open, "houses are together"));
  Enumeration all(problem);
  SamplerOptions options;
  options.anneal = 4;
  options.sweeps = 12;
  for (std::uint64_t number = 0; number < 4000; ++number) {
    const Sample made = sample(problem, options, number);
    REQUIRE(made.outcome == Outcome::kFound);
    all.draw(made.map);
  }
  CHECK(all.strangers() == 0);
  CHECK(all.chi_squared() < 1.5);
}

}  // namespace
}  // namespace solitaire::tiles
