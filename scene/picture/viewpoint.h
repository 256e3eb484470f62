#pragma once

namespace solitaire {

/// From where a picture shows a scene.
enum class Viewpoint {
  kAbove,  // as its default camera sees it: from the front, the right and above
  kEye,    // as somebody who stands in it does
};

}  // namespace solitaire
