#include "engines/sample/draw_table.h"

#include <limits>

namespace solitaire {
namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::size_t DrawTable::column_number(const std::string& name) {
  const auto [it, added] = numbers_.try_emplace(name, names_.size());
  if (added) {
    names_.push_back(name);
    columns_.emplace_back();
  }
  return it->second;
}

void DrawTable::add(const std::vector<std::string>& names, const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool as_before = i < names_.size() && names_[i] == names[i];  // which nearly all rows are
    std::vector<double>& column = columns_[as_before ? i : column_number(names[i])];
    column.resize(rows_, kAbsent);
    column.push_back(numbers[i]);
  }
  ++rows_;
}

std::vector<double> DrawTable::column(const std::string& name) const {
  const auto found = numbers_.find(name);
  std::vector<double> column;
  if (found != numbers_.end()) column = columns_[found->second];
  column.resize(rows_, kAbsent);
  return column;
}

}  // namespace solitaire
