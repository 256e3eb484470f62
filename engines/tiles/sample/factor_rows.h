#pragma once
#include <memory>
#include <unordered_map>
#include <vector>

#include "engines/tiles/model/patch_index.h"

namespace solitaire::tiles {

/// What the patches of a shape multiply a map's probability by, as rows: a row has the multipliers of all
/// tiles at one place of the shape while the tiles at the other places are given. Rows are made when they are
/// asked for.
class FactorRows {
 public:
  /// `multipliers` are those of the patches by their numbers; both outlive this.
  FactorRows(const PatchIndex& patches, std::size_t own, std::size_t tiles,
             const std::vector<double>& multipliers);

  /// Returns the row for a code whose own place is left at 0. It stays where it is until forget().
  const double* row(PatchCode others) {
    if (dense_.empty()) return sparse_row(others);
    const double*& known = dense_[dense_place(others)];
    if (known == nullptr) known = new_row(others);
    return known;
  }
  /// Says that the multipliers have changed.
  void forget();

 private:
  struct Hash {
    std::size_t operator()(PatchCode code) const;
  };

  const double* sparse_row(PatchCode others);
  const double* new_row(PatchCode others);
  /// Leaves the bits of the own place out.
  std::size_t dense_place(PatchCode others) const {
    const auto code = static_cast<std::uint64_t>(others);
    const std::uint64_t low = code & ((std::uint64_t{1} << shift_) - 1);
    return static_cast<std::size_t>(low | (code >> (shift_ + bits_)) << shift_);
  }

  const PatchIndex& patches_;
  const std::vector<double>& multipliers_;
  unsigned shift_, bits_;  // of the own place in a code
  std::size_t tiles_;
  std::vector<const double*> dense_;  // by the others' code where that is short; else empty
  std::unordered_map<PatchCode, const double*, Hash> sparse_;
  std::vector<PatchCode> used_;                   // codes with a row, for dense_
  std::vector<std::unique_ptr<double[]>> store_;  // many rows each
  std::size_t free_ = 0;                          // rows left in the last
};

}  // namespace solitaire::tiles
