#pragma once
#include <string>
#include <unordered_map>
#include <vector>

namespace solitaire {

/// Draws of named numbers, a row each. A number that a draw does not have is NaN in its row.
class DrawTable {
 public:
  void add(const std::vector<std::string>& names, const std::vector<double>& numbers);

  std::size_t rows() const { return rows_; }
  /// In the order in which they were first met.
  const std::vector<std::string>& names() const { return names_; }
  /// The column of that name, of NaN alone if there is none.
  std::vector<double> column(const std::string& name) const;

 private:
  std::size_t column_number(const std::string& name);

  std::size_t rows_ = 0;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<std::vector<double>> columns_;  // each as long as its last number
};

}  // namespace solitaire
