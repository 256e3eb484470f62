#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "scene/assets.h"
#include "scene/outline.h"
#include "scene/picture/vector.h"

namespace solitaire {

/// How a surface takes light. Textures are not looked at: a textured surface has its material's factors.
struct Finish {
  Vector color{0.8F, 0.8F, 0.8F};  // linear
  Vector glow;                     // linear light that it sends out
  float metallic = 0;
  float roughness = 1;
  float opacity = 1;        // share of the light from behind that it keeps back
  bool is_primary = false;  // a thing's colour replaces this one's
};

/// The triangles of a model, in its own frame.
struct Shape {
  struct Triangle {
    std::array<std::uint32_t, 3> corners;  // indices into points and normals
    std::uint32_t finish;                  // index into finishes
  };

  std::vector<Vector> points;
  std::vector<Vector> normals;
  std::vector<Triangle> triangles;  // those of clear finishes come last
  std::size_t clear_from = 0;       // the first of them, once the shape is prepared
  std::vector<Finish> finishes;
};

/// Returns the triangles of an asset. Its lines and points are left out, and so are textures.
Shape shape_of(const Asset& asset);

/// Returns the unit box, which stands on the ground around the origin.
Shape box_shape();

/// Returns the body that stands on an outline and fills the unit box, in the finish of boxes.
Shape body_over(const Outline& outline);

/// Returns blocks of one finish, which is the primary one.
Shape blocks(const std::vector<Box3>& boxes, const Finish& finish);

/// Returns the part of the mapped shape below the height y. Where one of the boxes, which together hold the
/// shape, reaches above it, the cut is closed with the dark fill that plans give to cut walls.
Shape cut_below(const Shape& shape, const std::vector<Box3>& boxes, const Affine& map, double height);

}  // namespace solitaire
