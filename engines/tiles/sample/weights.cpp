#include "engines/tiles/sample/weights.h"

#include <cmath>

namespace solitaire::tiles {

Weights::Weights(const Style& style, double power)
    : style_(&style),
      power_(power),
      tables_(style.shapes.size()),
      last_zones_(style.shapes.size()),
      last_(style.shapes.size()) {}

void Weights::set_power(double power) {
  power_ = power;
  for (std::size_t shape = 0; shape < tables_.size(); ++shape) {
    for (auto& [zones, table] : tables_[shape]) fill(shape, zones, table);
  }
}

void Weights::find(std::size_t shape, ZoneSet zones) {
  const auto [entry, is_new] = tables_[shape].try_emplace(zones);
  Table& table = entry->second;
  if (is_new) {
    fill(shape, zones, table);
    const PatchIndex& patches = style_->shapes[shape].patches;
    for (std::size_t place = 0; place < patches.shape().volume(); ++place) {
      table.rows.emplace_back(patches, place, style_->tileset.size(), table.multipliers);
    }
  }
  last_zones_[shape] = zones;
  last_[shape] = &table;
}

void Weights::fill(std::size_t shape, ZoneSet zones, Table& table) const {
  const SoftShape& soft = style_->shapes[shape];
  table.multipliers.resize(soft.patches.size() + 1);
  for (std::uint32_t patch = 0; patch < table.multipliers.size(); ++patch) {
    table.multipliers[patch] = std::exp(power_ * soft.log_weight(zones, patch));
  }
  for (FactorRows& rows : table.rows) rows.forget();
}

}  // namespace solitaire::tiles
