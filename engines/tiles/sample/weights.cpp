#include "engines/tiles/sample/weights.h"

#include <cmath>

namespace solitaire::tiles {

Weights::Weights(const Style& style, double power)
    : style_(&style), power_(power), tables_(style.shapes.size()) {}

void Weights::set_power(double power) {
  power_ = power;
  for (std::size_t shape = 0; shape < tables_.size(); ++shape) {
    for (auto& [zones, table] : tables_[shape]) fill(shape, table);
  }
}

const std::vector<double>& Weights::of(std::size_t shape, ZoneSet zones) {
  const auto [place, is_new] = tables_[shape].try_emplace(zones);
  if (is_new) {
    place->second.zones = zones;
    fill(shape, place->second);
  }
  return place->second.multipliers;
}

void Weights::fill(std::size_t shape, Table& table) const {
  const SoftShape& soft = style_->shapes[shape];
  table.multipliers.resize(soft.patches.size() + 1);
  for (std::uint32_t patch = 0; patch < table.multipliers.size(); ++patch) {
    table.multipliers[patch] = std::exp(power_ * soft.log_weight(table.zones, patch));
  }
}

}  // namespace solitaire::tiles
