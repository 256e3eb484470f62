#include "scene/paint.h"

#include <algorithm>
#include <array>

namespace solitaire {
namespace {

struct Material {
  std::string_view name;
  Color color;
  Paint::Finish finish;
};

constexpr std::array<Material, 25> kMaterials{{
    {"oak", {0.76, 0.58, 0.38}, {0.65, 0}},     {"walnut", {0.45, 0.30, 0.20}, {0.6, 0}},
    {"birch", {0.87, 0.77, 0.62}, {0.65, 0}},   {"pine", {0.85, 0.68, 0.45}, {0.7, 0}},
    {"cherry", {0.60, 0.32, 0.20}, {0.55, 0}},  {"steel", {0.66, 0.68, 0.71}, {0.35, 1}},
    {"brass", {0.88, 0.71, 0.38}, {0.3, 1}},    {"copper", {0.85, 0.54, 0.40}, {0.35, 1}},
    {"iron", {0.30, 0.30, 0.32}, {0.6, 1}},     {"concrete", {0.62, 0.61, 0.59}, {0.95, 0}},
    {"plaster", {0.91, 0.89, 0.85}, {0.95, 0}}, {"brick", {0.62, 0.31, 0.24}, {0.95, 0}},
    {"stone", {0.55, 0.53, 0.50}, {0.9, 0}},    {"marble", {0.93, 0.92, 0.90}, {0.2, 0}},
    {"tiles", {0.86, 0.88, 0.88}, {0.25, 0}},   {"glass", {0.66, 0.82, 0.90}, {0.05, 0, 0.35}},
    {"leather", {0.36, 0.22, 0.15}, {0.5, 0}},  {"fabric", {0.46, 0.52, 0.58}, {0.95, 0}},
    {"plastic", {0.85, 0.85, 0.85}, {0.35, 0}}, {"rubber", {0.13, 0.13, 0.14}, {0.9, 0}},
    {"grass", {0.42, 0.58, 0.28}, {1, 0}},      {"soil", {0.40, 0.30, 0.22}, {1, 0}},
    {"sand", {0.86, 0.78, 0.58}, {1, 0}},       {"asphalt", {0.27, 0.27, 0.29}, {0.95, 0}},
    {"water", {0.25, 0.48, 0.62}, {0.08, 0}},
}};

}  // namespace

Color Paint::over(const Color& own) const {
  if (!tints) return color;
  const Color linear = to_linear(own), tint = to_linear(color);
  return to_screen({linear[0] * tint[0], linear[1] * tint[1], linear[2] * tint[2]});
}

std::string Paint::text() const {
  if (tints) return "tint " + hex(color);
  if (covers) return "all " + hex(color);
  return material.empty() ? hex(color) : material + " " + hex(color);
}

std::optional<Paint> material_named(std::string_view name) {
  const auto found = std::ranges::find(kMaterials, name, &Material::name);
  if (found == kMaterials.end()) return std::nullopt;
  return Paint{std::string(name), found->color, found->finish};
}

const std::vector<std::string>& material_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Material& material : kMaterials) all.emplace_back(material.name);
    return all;
  }();
  return names;
}

}  // namespace solitaire
