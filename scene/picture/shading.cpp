#include "scene/picture/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/color.h"

namespace solitaire {
namespace {

constexpr float kExposure = 0.58F;
constexpr Vector kReflectance{0.04F, 0.04F, 0.04F};  // of what is no metal, seen straight on

float luminance(const Vector& light) { return 0.2126F * light.x + 0.7152F * light.y + 0.0722F * light.z; }

float fifth_power(float x) { return x * x * x * x * x; }

/// Fresnel's reflectance after Schlick (1994); rough surfaces gain less of it at grazing angles.
Vector fresnel(const Vector& straight_on, float cosine, float roughness) {
  const float gain = fifth_power(1 - cosine) * (1 - roughness) * (1 - roughness);
  return straight_on + (Vector{1, 1, 1} - straight_on) * gain;
}

/// The share of the sun's light that a rough surface reflects to the viewer: the distribution of Trowbridge
/// and Reitz with Karis's visibility term.
float highlight(float normal_half, float sun_half, float roughness) {
  const float width = std::max(roughness * roughness, 0.03F), squared = width * width;
  const float spread = normal_half * normal_half * (squared - 1) + 1;
  const float distribution = squared / (std::numbers::pi_v<float> * spread * spread);
  return distribution / (4 * std::max(sun_half * sun_half, 0.1F) * (roughness + 0.5F));
}

float curve(float x) {
  const float mapped = x * (2.51F * x + 0.03F) / (x * (2.43F * x + 0.59F) + 0.14F);
  return std::clamp(mapped, 0.0F, 1.0F);
}

}  // namespace

Vector shaded(const Finish& finish, const Light& light, const Vector& normal, const Vector& to_viewer) {
  const Vector to_sun = Lighting::to_sun();
  const float facing_sun = std::max(dot(normal, to_sun), 0.0F);
  const float facing_viewer = std::clamp(dot(normal, to_viewer), 0.0F, 1.0F);
  const Vector sun = Lighting::sun_color() * (light.sun * facing_sun);
  const Vector diffuse = finish.color * (1 - finish.metallic) * (sun + light.ambient);

  const Vector straight_on = mixed(kReflectance, finish.color, finish.metallic);
  const Vector half = normalized(to_sun + to_viewer);
  const Vector mirrored = normal * (2 * dot(normal, to_viewer)) - to_viewer;
  const Vector seen = mixed(Lighting::sky(mirrored), Lighting::sky(normal), finish.roughness);
  // What hides the sky from the surface hides it from the mirror, too.
  const float open = std::min(luminance(light.ambient) / luminance(Lighting::sky(normal)), 1.0F);
  const Vector glint =
      fresnel(straight_on, std::max(dot(to_sun, half), 0.0F), finish.roughness) * sun *
      highlight(std::max(dot(normal, half), 0.0F), std::max(dot(to_sun, half), 0.0F), finish.roughness);
  const Vector reflection = fresnel(straight_on, facing_viewer, finish.roughness) * seen * open;
  return diffuse + glint + reflection + finish.glow;
}

Vector tone_mapped(const Vector& radiance) {
  const Vector exposed = radiance * kExposure;
  return {curve(exposed.x), curve(exposed.y), curve(exposed.z)};
}

std::uint8_t screen_byte(float linear) {
  // Finer steps than this change no byte by more than one.
  constexpr int kSteps = 1 << 14;
  static const std::vector<std::uint8_t> kTable = [] {
    std::vector<std::uint8_t> table;
    for (int i = 0; i <= kSteps; ++i)
      table.push_back(static_cast<std::uint8_t>(
          std::lround(255 * to_screen({static_cast<double>(i) / kSteps, 0, 0})[0])));
    return table;
  }();
  return kTable[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * kSteps + 0.5F)];
}

Vector background() { return {0.84F, 0.835F, 0.82F}; }

Vector ground_shown(const Light& light, const Light& in_the_open) {
  const float facing_sun = Lighting::to_sun().y;
  const auto received = [&](const Light& each) {
    return Lighting::sun_color() * (each.sun * facing_sun) + each.ambient;
  };
  const Vector now = received(light), open = received(in_the_open);
  return background() * Vector{now.x / open.x, now.y / open.y, now.z / open.z};
}

}  // namespace solitaire
