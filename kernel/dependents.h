#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace solitaire {

/// Finds what depends on numbered things, where users have larger numbers than what they use.
class Dependents {
 public:
  explicit Dependents(std::size_t count) : users_(count), seen_(count, false) {}

  void add(std::uint32_t used, std::uint32_t user) {
    auto& users = users_[used];
    if (users.empty() || users.back() != user) users.push_back(user);
  }
  const std::vector<std::uint32_t>& users(std::uint32_t used) const { return users_[used]; }

  /// All that depends on some of these, in ascending order.
  std::vector<std::uint32_t> closure(std::span<const std::uint32_t> of) {
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> open(of.begin(), of.end());
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (const std::uint32_t user : users_[at]) {
        if (seen_[user]) continue;
        seen_[user] = true;
        found.push_back(user);
        open.push_back(user);
      }
    }
    for (const std::uint32_t user : found) seen_[user] = false;
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  std::vector<std::vector<std::uint32_t>> users_;
  std::vector<bool> seen_;
};

}  // namespace solitaire
