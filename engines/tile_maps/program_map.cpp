#include "engines/tile_maps/program_map.h"

#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace solitaire {
namespace {

/// A condition with more nodes is about more than a site.
constexpr std::size_t kMostNodes = 600;

/// Returns the only choice that a condition depends on, if there is just one.
std::optional<NodeId> only_choice(const Graph& graph, NodeId condition) {
  std::optional<NodeId> found;
  std::unordered_set<NodeId> seen;
  std::vector<NodeId> waiting{condition};
  while (!waiting.empty()) {
    const NodeId node = waiting.back();
    waiting.pop_back();
    if (!seen.insert(node).second) continue;
    if (seen.size() > kMostNodes) return std::nullopt;
    if (is_choice(graph.node(node).op)) {
      if (found) return std::nullopt;
      found = node;
    }
    for (const NodeId operand : graph.node(node).args()) waiting.push_back(operand);
  }
  return found;
}

Scalar scalar_of(tiles::Tile tile) { return Scalar::of(static_cast<std::int64_t>(tile)); }

/// Returns the tiles with which a condition holds that depends on a single site.
tiles::TileMask allowed_tiles(LiveConditions& conditions, std::size_t condition, NodeId variable,
                              tiles::Tile now, std::size_t tiles) {
  tiles::TileMask allowed;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    conditions.set(variable, scalar_of(static_cast<tiles::Tile>(tile)));
    conditions.settle();
    if (conditions.holds(condition)) allowed.insert(static_cast<tiles::Tile>(tile));
  }
  conditions.set(variable, scalar_of(now));
  conditions.settle();
  return allowed;
}

}  // namespace

std::uint64_t ProgramRule::violation(const tiles::Grid& map) const {
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (map[site] == shown_[site]) continue;
    shown_[site] = map[site];
    conditions_.set(variables_[site], scalar_of(map[site]));
  }
  derived_.settle(conditions_);
  return conditions_.broken();
}

void add_conditions_on_sites(const Graph& graph, LiveConditions& conditions,
                             const std::vector<NodeId>& variables, const tiles::Grid& map,
                             tiles::Problem& problem) {
  std::unordered_map<NodeId, std::uint32_t> sites;
  for (std::uint32_t site = 0; site < variables.size(); ++site) {
    if (is_choice(graph.node(variables[site]).op)) {
      sites.emplace(variables[site], site);
    } else {
      problem.add({"", {site}, tiles::TileMask::of(map[site])});
    }
  }
  const std::size_t tiles = problem.style().tileset.size();
  for (std::size_t condition = 0; condition < conditions.conditions().size(); ++condition) {
    const auto choice = only_choice(graph, conditions.conditions()[condition]);
    const auto site = choice ? sites.find(*choice) : sites.end();
    if (site == sites.end()) continue;
    problem.add(
        {"", {site->second}, allowed_tiles(conditions, condition, site->first, map[site->second], tiles)});
  }
  conditions.take_broken();  // what was tried is as it was
}

}  // namespace solitaire
