#include "scene/color.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

#include "scene/geometry.h"

namespace solitaire {
namespace {

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

// Six digits are finer than any screen, and hide the last bit in which one libm's pow differs from another's.
Color map_channels(const Color& color, double (*curve)(double)) {
  Color mapped;
  std::transform(color.begin(), color.end(), mapped.begin(),
                 [&](double channel) { return rounded(curve(std::clamp(channel, 0.0, 1.0)), 6); });
  return mapped;
}

Color from_hue(double hue, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue * 6, 6);
    return value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace

Color color_of_name(std::string_view name) {
  if (name.empty()) return {0.78, 0.76, 0.72};
  const std::uint64_t hash = fnv1a(name);
  const double hue = static_cast<double>(hash >> 40) / static_cast<double>(1u << 24);
  const double saturation = 0.32 + 0.05 * static_cast<double>(hash % 4);
  const double value = 0.76 + 0.04 * static_cast<double>(hash / 4 % 4);
  return from_hue(hue, saturation, value);
}

Color to_linear(const Color& screen) {
  return map_channels(screen,
                      [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
}

Color to_screen(const Color& linear) {
  return map_channels(
      linear, [](double c) { return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055; });
}

std::string hex(const Color& color) {
  const auto byte = [](double channel) { return std::lround(std::clamp(channel, 0.0, 1.0) * 255); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color[0]), byte(color[1]), byte(color[2]));
}

double luminance(const Color& color) {
  const Color linear = to_linear(color);
  return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
}

Color mixed(const Color& a, const Color& b, double share_of_b) {
  Color color;
  for (int i = 0; i < 3; ++i) color[i] = a[i] + (b[i] - a[i]) * share_of_b;
  return color;
}

}  // namespace solitaire
