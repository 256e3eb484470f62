#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/color.h"

namespace solitaire {

/// What the primary surface of a thing, or all of them, are made of in place of its own material.
struct Paint {
  struct Finish {
    double roughness = 1;
    double metallic = 0;
    double opacity = 1;  // share of the light from behind that it keeps back

    auto operator<=>(const Finish&) const = default;
  };

  std::string material;          // "oak", or "" for a mere colour
  Color color{};                 // as screens show it
  std::optional<Finish> finish;  // of a mere colour the surface's own
  bool tints = false;            // it colours all surfaces, over their own colours
  bool covers = false;           // it colours all surfaces, and nothing of their own colours is left

  /// Whether it is for all surfaces, and not the primary one alone.
  bool is_everywhere() const { return tints || covers; }

  /// Returns what becomes of a surface's own colour, as screens show it.
  Color over(const Color& own) const;

  /// Returns a text that differs for paints that look different: "#c08040" or "oak #c08040".
  std::string text() const;

  auto operator<=>(const Paint&) const = default;
};

/// Returns the paint of a material with this name, nothing if there is none.
std::optional<Paint> material_named(std::string_view name);

/// Returns the names of all materials.
const std::vector<std::string>& material_names();

}  // namespace solitaire
