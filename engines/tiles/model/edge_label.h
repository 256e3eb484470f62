#pragma once
#include <algorithm>
#include <string>

namespace solitaire::tiles {

/// Returns a side's label read the other way round: its parts between | in the opposite order.
inline std::string reversed_label(const std::string& label) {
  std::string result;
  for (std::size_t from = 0; from <= label.size();) {
    const std::size_t bar = std::min(label.find('|', from), label.size());
    const std::string part = label.substr(from, bar - from);
    result = from == 0 ? part : part + '|' + result;
    from = bar + 1;
  }
  return result;
}

}  // namespace solitaire::tiles
