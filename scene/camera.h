#pragma once
#include <vector>

#include "scene/geometry.h"
#include "scene/scene.h"

namespace solitaire {

/// A perspective camera in glTF's axes and metres: x right, y up, z towards the front.
struct Camera {
  Vec3 position{};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  // of length 1, at right angles to each other
  double half_height = 0;                               // of what it sees at a distance of 1
  double aspect = 1;                                    // width divided by height
  double nearest = 0, farthest = 0;                     // of the points that it was fitted to, how far ahead
};

/// Returns the unit vector from a scene to the camera that looks at it: from its front, its right and above,
/// so that three sides of everything are seen.
Vec3 three_quarter_view();

/// Returns the camera that sees all of these points from the direction `to_camera`, as near as it can be with
/// a small margin around them. Without points it sees the cube of one metre around the origin.
Camera fitted_camera(const std::vector<Vec3>& points, const Vec3& to_camera, double aspect);

/// Returns the camera that a scene is shown from unless somebody moves it.
Camera default_camera(const Scene& scene, double aspect);

}  // namespace solitaire
