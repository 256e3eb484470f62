#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace solitaire {

/// Numbers names from 0 in the order in which they are first met, so that later code compares and stores
/// numbers instead of texts.
class NameTable {
 public:
  NameTable() = default;
  NameTable(NameTable&&) = default;
  NameTable& operator=(NameTable&&) = default;

  /// Returns the number of a name, which gets one if it has none yet.
  std::uint32_t number(std::string_view name);
  std::optional<std::uint32_t> find(std::string_view name) const;
  const std::string& operator[](std::uint32_t number) const { return names_[number]; }
  std::size_t size() const { return names_.size(); }

 private:
  std::deque<std::string> names_;  // a deque, so that the views in numbers_ stay valid
  std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

}  // namespace solitaire
