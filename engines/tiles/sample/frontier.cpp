#include "engines/tiles/sample/frontier.h"

#include <algorithm>

#include "base/hash.h"
#include "engines/tiles/model/uniform.h"

namespace solitaire::tiles {
namespace {

constexpr std::size_t kSmallTable = 64;
/// Where all keys are lower than this, they are the places in the table.
constexpr std::size_t kDirectKeys = 1024;

}  // namespace

unsigned Frontier::bits_of(const Problem& problem) {
  return PatchIndex::bits_for(problem.style().tileset.size());
}

std::size_t Frontier::redraw(Grid& map, std::span<const std::uint32_t> sites, Weights& weights,
                             RandomStream& random) {
  if (plan_.lay_out(map, sites, weights) && sum_up()) {
    draw_back(map, random);
    return 0;
  }
  if (sites.size() == 1) return 1;
  const std::size_t half = sites.size() / 2;
  const std::size_t left = redraw(map, sites.first(half), weights, random);
  return left + redraw(map, sites.subspan(half), weights, random);
}

bool Frontier::sum_up() {
  states_.assign(1, {0, 1.0, kNone});
  edges_.clear();
  std::size_t first = 0;
  for (const PlanStep& step : plan_.steps()) {
    const std::size_t end = states_.size();
    const FrontierKey bits = step.kept | (step.needed ? FrontierKey{(1U << tile_bits_) - 1} << step.slot : 0);
    direct_ = bits < kDirectKeys;
    table_.assign(direct_ ? static_cast<std::size_t>(bits) + 1 : kSmallTable, kNone);
    for (std::size_t from = first; from < end; ++from) {
      advance(step, static_cast<std::uint32_t>(from), end);
      if (states_.size() - end > kMostStates) return false;
    }
    if (states_.size() == end) return false;
    normalize(end);
    first = end;
  }
  return true;
}

/// Extends a state by every tile that the step allows.
void Frontier::advance(const PlanStep& step, std::uint32_t from, std::size_t first) {
  const State before = states_[from];
  TileMask tiles = step.tiles;
  for (const ClosingPair& pair : step.pairs) {
    tiles &= pair.rules->beside(tile_in(before.key, pair.slot), pair.axis, pair.step);
  }
  FrontierKey kept = before.key & step.kept;
  for (const NarrowedSlot& narrowed : step.narrowed) {
    const Tile tile = tile_in(kept, narrowed.slot);
    kept ^= FrontierKey{static_cast<Tile>(tile ^ narrowed.classes[tile])} << narrowed.slot;
  }
  find_weights(step, before.key);
  tiles.for_each([&](Tile tile) {
    const double factor = before.weight * weights_[tile];
    if (!(factor > 0)) return;
    const Tile known = step.classes == nullptr ? tile : step.classes[tile];
    const std::uint32_t to = state_of(step.needed ? kept | FrontierKey{known} << step.slot : kept, first);
    State& state = states_[to];
    edges_.push_back({from, state.edges, factor, tile});
    state.edges = static_cast<std::uint32_t>(edges_.size() - 1);
    state.weight += factor;
  });
}

/// Multiplies, for each tile, the step's factors that the state's tiles and the tile close.
void Frontier::find_weights(const PlanStep& step, FrontierKey key) {
  weights_ = step.own;
  for (const ClosingFactor& factor : step.factors) {
    PatchCode code = factor.standing;
    for (const ClosingFactor::Part& part : plan_.parts(factor)) {
      code |= PatchCode{tile_in(key, part.slot)} << part.shift;
    }
    const double* const row = factor.rows->row(code);
    for (std::size_t tile = 0; tile < weights_.size(); ++tile) weights_[tile] *= row[tile];
  }
}

/// Returns the state with a key after the present step, whose states begin at `first`.
std::uint32_t Frontier::state_of(FrontierKey key, std::size_t first) {
  if (direct_) return state_at(table_[static_cast<std::size_t>(key)], key);
  if (2 * (states_.size() - first) > table_.size()) {
    table_.assign(2 * table_.size(), kNone);
    for (std::size_t state = first; state < states_.size(); ++state) {
      std::size_t at = mix(static_cast<std::uint64_t>(states_[state].key),
                           static_cast<std::uint64_t>(states_[state].key >> 64U)) &
                       (table_.size() - 1);
      while (table_[at] != kNone) at = (at + 1) & (table_.size() - 1);
      table_[at] = static_cast<std::uint32_t>(state);
    }
  }
  std::size_t at =
      mix(static_cast<std::uint64_t>(key), static_cast<std::uint64_t>(key >> 64U)) & (table_.size() - 1);
  while (table_[at] != kNone && states_[table_[at]].key != key) at = (at + 1) & (table_.size() - 1);
  return state_at(table_[at], key);
}

/// Returns the state whose number stands at an entry of the table, a new one if none does.
std::uint32_t Frontier::state_at(std::uint32_t& entry, FrontierKey key) {
  if (entry == kNone) {
    entry = static_cast<std::uint32_t>(states_.size());
    states_.push_back({key, 0.0, kNone});
  }
  return entry;
}

/// Divides the weights from a state on by their largest, so that long windows do not leave the range of a
/// double.
void Frontier::normalize(std::size_t first) {
  double most = 0;
  for (std::size_t state = first; state < states_.size(); ++state)
    most = std::max(most, states_[state].weight);
  for (std::size_t state = first; state < states_.size(); ++state) states_[state].weight /= most;
}

void Frontier::draw_back(Grid& map, RandomStream& random) const {
  const State* state = &states_.back();
  const auto steps = plan_.steps();
  for (std::size_t place = steps.size(); place-- > 0;) {
    double sum = 0;
    for (std::uint32_t edge = state->edges; edge != kNone; edge = edges_[edge].next)
      sum += edges_[edge].weight;
    double left = uniform(random) * sum;
    std::uint32_t drawn = state->edges;
    for (std::uint32_t edge = state->edges; edge != kNone && left >= 0; edge = edges_[edge].next) {
      drawn = edge;
      left -= edges_[edge].weight;
    }
    map[steps[place].site] = edges_[drawn].tile;
    state = &states_[edges_[drawn].from];
  }
}

}  // namespace solitaire::tiles
