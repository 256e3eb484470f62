#include "scene/names.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "scene/text.h"

namespace solitaire {
namespace {

// The suffixes that Godot 4's scene importer acts on: those of nodes and meshes first, then those of
// materials
// ("alpha", "vcol") and of animations.
constexpr std::array<std::string_view, 16> kGodotSuffixes = {
    "noimp",   "col",     "convcol", "colonly", "convcolonly", "rigid", "navmesh", "occ",
    "occonly", "vehicle", "wheel",   "loop",    "cycle",       "alpha", "vcol",    "skel"};

// Returns the name as Godot reads it: in lower case, with "_" for characters that a node's name cannot have,
// and without trailing numbers.
std::string as_godot_reads(std::string_view name) {
  std::string read;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      read += static_cast<char>(c - 'A' + 'a');
    } else {
      read += std::string_view("-.:@/%\"").find(c) == std::string_view::npos ? c : '_';
    }
  }
  const auto end = read.find_last_not_of("0123456789 _");
  return read.substr(0, end == std::string::npos ? 0 : end + 1);
}

bool godot_acts_on(std::string_view name) {
  const std::string read = as_godot_reads(name);
  return std::any_of(kGodotSuffixes.begin(), kGodotSuffixes.end(),
                     [&](std::string_view suffix) { return read.ends_with(fmt::format("_{}", suffix)); });
}

}  // namespace

std::string harmless_name(std::string_view wanted) {
  std::string name = clean_text(wanted);
  std::replace(name.begin(), name.end(), '$', '_');
  if (godot_acts_on(name)) name += " (1)";
  return name;
}

void UniqueNames::announce(std::string_view wanted) { ++announced_[harmless_name(wanted)]; }

std::string UniqueNames::take(std::string_view wanted) {
  const std::string base = harmless_name(wanted);
  const auto announced = announced_.find(base);
  const bool is_one_of_several = announced != announced_.end() && announced->second > 1;
  if (!is_one_of_several && taken_.insert(base).second) return base;
  int& number = next_number_.try_emplace(base, is_one_of_several ? 0 : 1).first->second;
  std::string name;
  do {
    name = fmt::format("{}[{}]", base, number++);
  } while (!taken_.insert(name).second);
  return name;
}

}  // namespace solitaire
