#pragma once
#include <array>
#include <string>
#include <string_view>

namespace solitaire {

/// Red, green, blue, each 0..1, as a screen shows them (sRGB): what programs, plans and style sheets write.
using Color = std::array<double, 3>;

/// Returns a soft colour, on which labels stay legible. A name has the same colour in every scene.
Color color_of_name(std::string_view name);

/// Convert between what screens show (sRGB) and linear light, in which glTF writes its factors.
Color to_linear(const Color& screen);
Color to_screen(const Color& linear);

std::string hex(const Color& color);   // "#c08040"
double luminance(const Color& color);  // 0 black .. 1 white
Color mixed(const Color& a, const Color& b, double share_of_b);

}  // namespace solitaire
