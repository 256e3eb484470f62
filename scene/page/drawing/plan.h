#pragma once
#include <string>

#include "scene/page/drawing/levels.h"
#include "scene/scene.h"

namespace solitaire {

/// Returns the scene from above as an <svg> element for use within HTML, with a viewBox and no size of its
/// own, or "" if the scene has no objects. x runs to the right and y up. Higher and smaller things cover
/// lower and larger ones. It has names and heights where they fit, none over another, a mark at the front of
/// each asset that has one, and a scale bar in metres.
std::string svg_plan(const Scene& scene);

/// Returns the plan of one level of a scene, of the size that all its levels have. What hangs overhead is
/// outlined.
std::string svg_plan(const Scene& scene, const Level& level);

}  // namespace solitaire
