#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/camera.h"
#include "scene/picture/image.h"
#include "scene/picture/picture_size.h"
#include "scene/picture/traced_shapes.h"
#include "scene/picture/viewpoint.h"
#include "scene/scene.h"

namespace solitaire {

struct Picture {
  static constexpr std::int32_t kNothing = -1;

  Image image;
  std::vector<std::int32_t>
      objects;  // for each pixel, in rows from above: the index of the object, or kNothing
};

/// Draws scenes. It keeps what it knows of their assets, which must live as long, for the next one. Only one
/// thread at a time may use it.
class Painter {
 public:
  /// A picture is drawn by so many threads at a time; it does not depend on their number.
  explicit Painter(std::size_t threads = 1) : threads_(threads) {}

  /// Draws the scene from above, or as the given camera sees it, with the walls cut low that hide something;
  /// or from eye height, with nothing cut. The same scene gives the same picture, on all processors. Throws
  /// SceneError.
  Picture draw(const Scene& scene, const PictureSize& size, Viewpoint from = Viewpoint::kAbove);
  Picture draw(const Scene& scene, const PictureSize& size, const Camera& camera);

 private:
  Picture draw_at_eye_height(const Scene& scene, const PictureSize& size);

  std::size_t threads_;
  TracedShapes shapes_;
};

}  // namespace solitaire
