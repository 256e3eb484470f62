#include "engines/tiles/sample/factor_rows.h"

#include "base/hash.h"

namespace solitaire::tiles {
namespace {

/// Up to so many bits of the other places' tiles, rows are found by a table.
constexpr std::size_t kDenseBits = 16;
constexpr std::size_t kRowsAtOnce = 64;

}  // namespace

FactorRows::FactorRows(const PatchIndex& patches, std::size_t own, std::size_t tiles,
                       const std::vector<double>& multipliers)
    : patches_(patches),
      multipliers_(multipliers),
      shift_(static_cast<unsigned>(own) * patches.bits()),
      bits_(patches.bits()),
      tiles_(tiles) {
  const std::size_t bits = (patches.shape().volume() - 1) * patches.bits();
  if (bits <= kDenseBits) dense_.resize(std::size_t{1} << bits);
}

std::size_t FactorRows::Hash::operator()(PatchCode code) const {
  return mix(static_cast<std::uint64_t>(code), static_cast<std::uint64_t>(code >> 64U));
}

void FactorRows::forget() {
  for (const PatchCode code : used_) dense_[dense_place(code)] = nullptr;
  used_.clear();
  sparse_.clear();
  store_.clear();
  free_ = 0;
}

const double* FactorRows::sparse_row(PatchCode others) {
  const auto [entry, is_new] = sparse_.try_emplace(others);
  if (is_new) entry->second = new_row(others);
  return entry->second;
}

const double* FactorRows::new_row(PatchCode others) {
  if (free_ == 0) {
    store_.push_back(std::make_unique<double[]>(kRowsAtOnce * tiles_));
    free_ = kRowsAtOnce;
  }
  double* const row = store_.back().get() + (kRowsAtOnce - free_--) * tiles_;
  for (std::size_t tile = 0; tile < tiles_; ++tile) {
    row[tile] = multipliers_[patches_.find(others | PatchCode{tile} << shift_)];
  }
  if (!dense_.empty()) used_.push_back(others);
  return row;
}

}  // namespace solitaire::tiles
