#include "engines/tiles/rules/keys.h"

#include <doctest/doctest.h>
#include <set>

#include "engines/tiles/sample/sampler.h"
#include "tests/tiles/drawn_maps.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

/// Floor '.', rock '#', two kinds of doors with their keys: A and a, B and b.
const char* const kRooms = ".#AaBb\n#AaBb.\nAaBb.#\naBb.#A\nBb.#Aa\nb.#AaB\n";

/// Keys as somebody finds out who tries all orders: whether each site can be reached with some set of keys
/// that can be collected, by repeating the walk until nothing is new.
struct Walk {
  const Grid& map;
  const Style& style;
  std::set<std::string> keys;
  std::set<std::size_t> seen;

  const std::string& name(std::size_t site) const { return style.tileset[map[site]].name; }
  bool may_enter(std::size_t site) const {
    if (name(site) == "#") return false;
    if (name(site) == "A") return keys.contains("a");
    return name(site) != "B" || keys.contains("b");
  }
  bool walk() {
    std::size_t known = 0;
    do {
      known = seen.size() + keys.size();
      seen.clear();
      if (may_enter(0)) visit(map.size.point(0));
    } while (seen.size() + keys.size() != known);
    for (std::size_t site = 0; site < map.tiles.size(); ++site) {
      if (name(site) != "#" && !seen.contains(site)) return false;
    }
    return !seen.empty();
  }
  void visit(const Point& at) {
    const std::size_t site = map.size.site(at);
    if (!may_enter(site) || !seen.insert(site).second) return;
    if (name(site) == "a" || name(site) == "b") keys.insert(name(site));
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const Point next{at[0] + x, at[1] + y, 0};
      if (next[0] < 0 || next[1] < 0 || next[0] >= map.size.width() || next[1] >= map.size.height()) continue;
      visit(next);
    }
  }
};

std::shared_ptr<const Keys> rule_of(const Style& style, const Topology& topology) {
  std::vector<Sides> open(style.tileset.size(), kAllSides);
  open[*style.tileset.find("#")] = 0;
  std::vector<std::optional<Tile>> keys(style.tileset.size());
  keys[*style.tileset.find("A")] = style.tileset.find("a");
  keys[*style.tileset.find("B")] = style.tileset.find("b");
  return std::make_shared<Keys>(topology, std::move(open), std::move(keys), 0, "keys");
}

TEST_CASE("keys: a map keeps the rule where a walk that tries everything gets everywhere") {
  const auto style = style_of(kRooms);
  const Topology topology = flat(4, 3);
  const auto rule = rule_of(*style, topology);
  RandomStream random(1, Purpose::kTiles, 0);
  std::size_t kept = 0, broken = 0;
  for (int round = 0; round < 60000; ++round) {
    Grid map(topology.size);
    for (Tile& tile : map.tiles) tile = static_cast<Tile>(random.below(style->tileset.size()));
    const bool wanted = Walk{map, *style, {}, {}}.walk();
    REQUIRE((rule->violation(map) == 0) == wanted);
    ++(wanted ? kept : broken);
  }
  CHECK(kept > 300);
  CHECK(broken > 300);
}

TEST_CASE("keys: a door whose key lies behind it, or behind another such door, is found") {
  const auto style = style_of(kRooms);
  const auto violation = [&](const char* text) {
    const Grid map = read_text("m", text, style->tileset, false);
    return rule_of(*style, {map.size, {}})->violation(map);
  };
  CHECK(violation(".aA.\n") == 0);
  CHECK(violation(".Aa.\n") == 1);
  CHECK(violation(".bBaA.\n") == 0);
  CHECK(violation("aB#\n.A#\n##b\n") == 2);  // the closed door, and the key beyond the rock
  CHECK(violation("#...\n") == 2);
  CHECK(violation(".#.#.\n") == 2);
}

TEST_CASE("keys: maps come as often as enumeration says") {
  const auto style = style_of(".#Aa\n#Aa.\nAa.#\na.#A\n..aA\n.aA.\n");
  add_step_shape(*style, {{2, 2, 1}}, 0.5);
  Problem problem(style, flat(3, 2));
  std::vector<Sides> open(style->tileset.size(), kAllSides);
  open[*style->tileset.find("#")] = 0;
  std::vector<std::optional<Tile>> keys(style->tileset.size());
  keys[*style->tileset.find("A")] = style->tileset.find("a");
  problem.add(std::make_shared<Keys>(problem.topology(), open, keys, 0, "keys"));
  check_drawn_maps(problem);
}

}  // namespace
}  // namespace solitaire::tiles
