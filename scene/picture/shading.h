#pragma once
#include <cstdint>

#include "scene/picture/lighting.h"

namespace solitaire {

/// Returns the radiance that a surface sends to the viewer. All vectors have length 1.
Vector shaded(const Finish& finish, const Light& light, const Vector& normal, const Vector& to_viewer);

/// Returns what a screen shows of a radiance, still as linear light but within 0..1: bright colours lose
/// their differences bit by bit instead of at once (the curve of Narkowicz, 2015, after ACES).
Vector tone_mapped(const Vector& radiance);

/// Returns what a screen shows of the ground, of which the pictures see only its shadows: without them it has
/// the colour of the background.
Vector ground_shown(const Light& light, const Light& in_the_open);

/// Returns the byte that makes a screen show this linear light of 0..1.
std::uint8_t screen_byte(float linear);

/// The background, as linear light.
Vector background();

}  // namespace solitaire
