#pragma once
#include "scene/camera.h"
#include "scene/picture/ray_scene.h"
#include "scene/scene.h"

namespace solitaire {

/// Returns the camera of somebody who stands in the scene, or beside it, where much of it is seen at eye
/// height. In a scene of less than four metres stands somebody smaller. `traced` is the scene with nothing
/// cut off.
Camera eye_view(const Scene& scene, const RayScene& traced, double aspect);

}  // namespace solitaire
