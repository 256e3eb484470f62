#pragma once
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engines/solution.h"

namespace solitaire {

/// Returns true if a further argument of place() with this name shows, as "material" does.
bool is_look(std::string_view extra);

/// Returns what each placed thing looks like, as text, sorted: its model, place, size, turn, colour, and the
/// further arguments that show.
std::vector<std::string> looks_of(const Solution& solution);

/// Tells solutions apart by what they look like: the value and the scene, and not the choices that led to
/// them. Which of several like objects is which does not count.
class DistinctResults {
 public:
  explicit DistinctResults(Apart apart = Apart::kResult) : apart_(apart) {}

  /// Returns true if no solution before looked like this one; with Apart::kValue, if none had this value.
  bool add(const Solution& solution);
  /// Returns true if some solution looked like an earlier one, but things had other names or extras.
  bool names_differed() const { return names_differed_; }

  static std::string key(const Solution& solution, Apart apart = Apart::kResult);

 private:
  Apart apart_;
  std::unordered_map<std::string, std::uint64_t> seen_;  // with a hash of the names and extras
  std::atomic<bool> names_differed_ = false;             // other threads may ask
};

}  // namespace solitaire
