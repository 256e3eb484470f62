#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace solitaire {

/// Which values of two ints go together: those of the first are the rows of a table, those of the second its
/// columns, both from 0 on. What lies beyond goes with nothing.
class PairTable {
 public:
  PairTable(std::size_t rows, std::size_t columns) : columns_(columns), allowed_(rows * columns) {}

  void allow(std::size_t row, std::size_t column) { allowed_[row * columns_ + column] = true; }
  bool allows(std::int64_t first, std::int64_t second) const {
    if (first < 0 || second < 0) return false;
    const auto row = static_cast<std::uint64_t>(first), column = static_cast<std::uint64_t>(second);
    return row < rows() && column < columns_ && allowed_[row * columns_ + column];
  }
  std::size_t rows() const { return columns_ == 0 ? 0 : allowed_.size() / columns_; }
  std::size_t columns() const { return columns_; }

  friend bool operator==(const PairTable&, const PairTable&) = default;

 private:
  std::size_t columns_;
  std::vector<bool> allowed_;
};

}  // namespace solitaire
