#pragma once
#include <map>

#include "scene/picture/embree.h"
#include "scene/picture/shape.h"

namespace solitaire {

/// A shape together with what Embree knows of it.
struct TracedShape {
  /// The number of the geometry with the clear triangles; that of the others is 0.
  static constexpr unsigned kClear = 1;

  /// What a single ray that looks for the nearest surface is asked with. Embree hands on the context, which
  /// therefore comes first.
  struct Question {
    RTCIntersectContext context;
    float clear_beyond;  // clear triangles count only if they are further away
  };

  Shape shape;
  Embree<RTCScene> scene;
};

/// Prepares shapes for the ray tracer, each asset's once. Only one thread at a time may use it.
class TracedShapes {
 public:
  /// Throws SceneError if there is no ray tracer for this processor.
  TracedShapes();

  /// Returns the shape of the asset, or that of the unit box for nullptr. It lives as long as this.
  const TracedShape& of(const Asset* asset);

  TracedShape prepare(Shape shape) const;
  RTCDevice device() const { return device_.get(); }

 private:
  void attach(const TracedShape& traced, std::size_t begin, std::size_t end, unsigned number) const;

  Embree<RTCDevice> device_;
  std::map<const Asset*, TracedShape> known_;  // looked up only: its order never shows
};

}  // namespace solitaire
