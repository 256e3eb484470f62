#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "scene/picture/normal_map.h"
#include "scene/picture/traced_shapes.h"
#include "scene/scene.h"

namespace solitaire {

/// A ray starts at `origin`. Its direction has length 1.
struct Ray {
  Vector origin, direction;
};

/// What a ray meets first.
struct Hit {
  std::size_t object = 0;  // index into Scene::objects
  float distance = 0;
  Vector point;
  Vector normal;             // of the smooth surface, of length 1, on the side that the ray comes from
  Vector flat_normal;        // of the triangle, likewise
  bool from_behind = false;  // the ray comes from the inside of the solid
  const Finish* finish = nullptr;
};

/// A scene as the ray tracer sees it, moved so that its middle is at the origin, where floats are finest.
/// Several threads may ask it at a time.
class RayScene {
 public:
  /// `cut` holds a height for each object, as cut_heights returns it.
  RayScene(TracedShapes& shapes, const Scene& scene, const std::vector<std::optional<double>>& cut);

  /// Returns what the ray meets first further away than `beyond`; clear surfaces only if they are further
  /// away than `clear_beyond`, too.
  std::optional<Hit> trace(const Ray& ray, float beyond = 0, float clear_beyond = 0) const;
  /// Returns for each of four directions whether a ray from the origin meets nothing but clear surfaces.
  std::array<bool, 4> are_free(const Vector& origin, const std::array<Vector, 4>& directions) const;

  const Vec3& middle() const { return middle_; }  // in the scene's own frame
  float radius() const { return radius_; }        // of a sphere around the middle that holds everything
  float ground() const { return ground_; }        // the height of what everything stands on

 private:
  struct Object {
    const Shape* shape;
    NormalMap normals;
    const std::vector<Finish>* finishes;
  };

  void measure(const Scene& scene);
  const std::vector<Finish>& finishes(const Shape& shape, const std::optional<Paint>& paint);
  void add(TracedShapes& shapes, const SceneObject& object, std::optional<double> cut);
  const TracedShape& own(TracedShape shape);
  const TracedShape& with_clearness(TracedShapes& shapes, const TracedShape& shape,
                                    const std::optional<Paint>& paint);
  void attach(RTCDevice device, const TracedShape& shape, const Affine& map,
              const std::optional<Paint>& paint);
  Hit hit_of(const Ray& ray, const RTCRayHit& found) const;

  Vec3 middle_{};
  float radius_ = 1;
  float ground_ = 0;
  std::vector<Object> objects_;
  std::vector<std::unique_ptr<TracedShape>> own_shapes_;  // of objects that are cut or opened
  std::map<std::pair<const Shape*, Paint>, std::vector<Finish>> painted_;
  std::map<std::pair<const Shape*, Paint>, const TracedShape*> clear_;
  Embree<RTCScene> scene_;
};

}  // namespace solitaire
