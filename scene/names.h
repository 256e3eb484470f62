#pragma once
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace solitaire {

/// Returns a name that no importer acts on: valid text without "$" and without the suffixes ("-col",
/// "_rigid",
/// "-loop", …) by which Godot takes a node, mesh or material for something else. "wall_col" becomes
/// "wall_col (1)".
std::string harmless_name(std::string_view wanted);

/// Hands out harmless names, each one once: "chair[0]", "chair[1]" where several were announced, and else
/// "chair", "chair[1]".
class UniqueNames {
 public:
  /// Says beforehand that somebody will ask for this name.
  void announce(std::string_view wanted);
  std::string take(std::string_view wanted);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> announced_, next_number_;
};

}  // namespace solitaire
