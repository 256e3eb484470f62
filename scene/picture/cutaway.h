#pragma once
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace solitaire {

/// Returns true for a thing that may be cut: its model or name says that it is a wall ("wall", "back wall"),
/// or it is a plain box as thin and tall as a wall.
bool is_like_wall(const SceneObject& object);

/// Returns for each object the height in metres above which it is left out of a picture, or nothing for an
/// object that is shown whole. Walls that stand between the camera and something else are cut off low, so
/// that one sees into rooms, and with each wall the doors, windows and other things in it. What stands at
/// such a wall and is taller than a table is cut at the height of one, so that it does not hide the room.
/// What hangs at such a wall goes with it.
///
/// A scene in which more than twenty million pairs of a wall and a thing would have to be compared is shown
/// whole.
std::vector<std::optional<double>> cut_heights(const Scene& scene, const Vec3& to_camera);

}  // namespace solitaire
