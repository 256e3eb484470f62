#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace solitaire {

/// A pattern over readable addresses: "wing[*]/room[0]/**". A `*` stands for any characters within a step's
/// name or within the number of a turn, a step `**` for any number of steps, also none; everything else for
/// itself.
class AddressPattern {
 public:
  explicit AddressPattern(std::string text);

  const std::string& text() const { return text_; }
  const std::vector<std::string>& steps() const { return steps_; }
  /// Returns true if it matches nothing but the address with its own text.
  bool is_exact() const { return text_.find('*') == std::string::npos; }
  /// Returns true if it matches an address with these steps, see AddressTable::steps.
  bool matches(const std::vector<std::string>& steps) const;

 private:
  std::string text_;
  std::vector<std::string> steps_;
};

}  // namespace solitaire
