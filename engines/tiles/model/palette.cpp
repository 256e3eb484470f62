#include "engines/tiles/model/palette.h"

#include <cmath>

namespace solitaire::tiles {

Rgba palette_color(std::size_t number) {
  // Steps of the golden ratio around the circle of hues never come near to each other for long.
  const double hue = std::fmod(0.08 + 0.618033988749895 * static_cast<double>(number), 1.0) * 6;
  const double light = number % 3 == 0 ? 0.85 : number % 3 == 1 ? 0.6 : 0.4;
  const double chroma = 0.5 * light;
  const auto channel = [&](double shift) {
    const double place = std::fmod(hue + shift, 6.0);
    const double part = std::fmin(1.0, std::fmax(0.0, std::fabs(place - 3) - 1));
    return static_cast<std::uint8_t>(std::lround(255 * (light - chroma + chroma * part)));
  };
  return {channel(0), channel(4), channel(2), 255};
}

}  // namespace solitaire::tiles
