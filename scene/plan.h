#pragma once
#include <string>

#include "scene/scene.h"

namespace solitaire {

/// The scene from above as an <svg> element for use within HTML (it has a viewBox and no size of its own): x
/// to the right, y up, lower and larger things under higher and smaller ones, names where they fit, a mark at
/// the front of assets that have one, a scale bar in metres. "" if the scene has no objects.
std::string svg_plan(const Scene& scene);

}  // namespace solitaire
