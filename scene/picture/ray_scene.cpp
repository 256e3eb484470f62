#include "scene/picture/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/openings.h"
#include "scene/picture/cutaway.h"

namespace solitaire {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

RTCRay to_embree(const Ray& ray) {
  RTCRay traced{};
  traced.org_x = ray.origin.x, traced.org_y = ray.origin.y, traced.org_z = ray.origin.z;
  traced.dir_x = ray.direction.x, traced.dir_y = ray.direction.y, traced.dir_z = ray.direction.z;
  traced.tfar = kInfinity;
  traced.mask = ~0U;
  return traced;
}

Vector towards(const Vector& normal, const Vector& viewer) {
  return dot(normal, viewer) < 0 ? -normal : normal;
}

void paint_over(Finish& finish, const Paint& paint) {
  const Vector color = to_vector(to_linear(paint.color));
  finish.color = paint.tints ? finish.color * color : color;
  if (!paint.finish) return;
  finish.roughness = static_cast<float>(paint.finish->roughness);
  finish.metallic = static_cast<float>(paint.finish->metallic);
  finish.opacity = static_cast<float>(paint.finish->opacity);
}

}  // namespace

RayScene::RayScene(TracedShapes& shapes, const Scene& scene, const std::vector<std::optional<double>>& cut)
    : scene_(rtcNewScene(shapes.device())) {
  measure(scene);
  objects_.reserve(scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) add(shapes, scene.objects[i], cut[i]);
  rtcCommitScene(scene_.get());
  check_embree(shapes.device());
}

void RayScene::measure(const Scene& scene) {
  const Box3 all = bounds(scene);  // in the program's axes
  if (all.empty()) return;
  middle_ = {(all.low[0] + all.high[0]) / 2, (all.low[2] + all.high[2]) / 2, -(all.low[1] + all.high[1]) / 2};
  const Vec3 size = all.size();
  radius_ = static_cast<float>(std::sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]) / 2);
  ground_ = static_cast<float>(all.low[2] - middle_[1]);
}

const std::vector<Finish>& RayScene::finishes(const Shape& shape, const std::optional<Paint>& paint) {
  if (!paint) return shape.finishes;
  const auto [place, is_new] = painted_.try_emplace({&shape, *paint}, shape.finishes);
  if (is_new) {
    for (Finish& finish : place->second) {
      if (finish.is_primary || paint->is_everywhere()) paint_over(finish, *paint);
    }
  }
  return place->second;
}

void RayScene::add(TracedShapes& shapes, const SceneObject& object, std::optional<double> cut) {
  const Affine move = to_affine({{-middle_[0], -middle_[1], -middle_[2]}, {0, 0, 0, 1}, {1, 1, 1}});
  const Affine map = move * to_affine(object.node_transform);
  const std::vector<Box3> parts = solid_parts(object.asset ? object.asset->box : unit_box(), object.openings);
  const TracedShape* shape = &shapes.of(object.asset);
  if (!object.openings.empty()) shape = &own(shapes.prepare(blocks(parts, shape->shape.finishes.front())));
  if (!object.outline.empty()) shape = &own(shapes.prepare(body_over(object.outline)));
  shape = &with_clearness(shapes, *shape, object.paint);
  if (!cut) return attach(shapes.device(), *shape, map, object.paint);
  const bool is_solid = is_like_wall(object);  // one looks into anything else where it is cut
  Shape below = cut_below(shape->shape, is_solid ? parts : std::vector<Box3>{}, map, *cut - middle_[1]);
  attach(shapes.device(), own(shapes.prepare(std::move(below))), Affine{}, object.paint);
}

/// A paint that one looks through, or that covers what one did, decides which triangles cast shadows: such
/// a shape is prepared anew, once for each paint.
const TracedShape& RayScene::with_clearness(TracedShapes& shapes, const TracedShape& shape,
                                            const std::optional<Paint>& paint) {
  if (!paint || !paint->finish) return shape;
  const auto [place, is_new] = clear_.try_emplace({&shape.shape, *paint}, &shape);
  if (!is_new) return *place->second;
  Shape painted = shape.shape;
  bool differs = false;
  for (Finish& finish : painted.finishes) {
    if (!finish.is_primary && !paint->is_everywhere()) continue;
    differs = differs || (finish.opacity < 1) != (paint->finish->opacity < 1);
    finish.opacity = static_cast<float>(paint->finish->opacity);
  }
  if (differs) place->second = &own(shapes.prepare(std::move(painted)));
  return *place->second;
}

const TracedShape& RayScene::own(TracedShape shape) {
  return *own_shapes_.emplace_back(std::make_unique<TracedShape>(std::move(shape)));
}

void RayScene::attach(RTCDevice device, const TracedShape& shape, const Affine& map,
                      const std::optional<Paint>& paint) {
  objects_.push_back({&shape.shape, NormalMap(map), &finishes(shape.shape, paint)});
  const Embree<RTCGeometry> instance(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(instance.get(), shape.scene.get());
  std::array<float, 12> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<float>(map.rows[i / 4][i % 4]);
  rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows.data());
  rtcCommitGeometry(instance.get());
  rtcAttachGeometryByID(scene_.get(), instance.get(), static_cast<unsigned>(objects_.size()) - 1);
}

std::optional<Hit> RayScene::trace(const Ray& ray, float beyond, float clear_beyond) const {
  RTCRayHit found{};
  found.ray = to_embree(ray);
  found.ray.tnear = beyond;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  TracedShape::Question question{{}, clear_beyond};
  rtcInitIntersectContext(&question.context);
  rtcIntersect1(scene_.get(), &question.context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return hit_of(ray, found);
}

std::array<bool, 4> RayScene::are_free(const Vector& origin, const std::array<Vector, 4>& directions) const {
  alignas(16) constexpr std::array<int, 4> kAll{-1, -1, -1, -1};
  RTCRay4 rays{};
  for (std::size_t i = 0; i < 4; ++i) {
    rays.org_x[i] = origin.x, rays.org_y[i] = origin.y, rays.org_z[i] = origin.z;
    rays.dir_x[i] = directions[i].x, rays.dir_y[i] = directions[i].y, rays.dir_z[i] = directions[i].z;
    rays.tfar[i] = kInfinity;
    rays.mask[i] = ~0U;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded4(kAll.data(), scene_.get(), &context, &rays);
  return {rays.tfar[0] >= 0, rays.tfar[1] >= 0, rays.tfar[2] >= 0, rays.tfar[3] >= 0};
}

Hit RayScene::hit_of(const Ray& ray, const RTCRayHit& found) const {
  Hit hit;
  hit.object = found.hit.instID[0];
  hit.distance = found.ray.tfar;
  const Object& object = objects_[hit.object];
  const Shape& shape = *object.shape;
  const std::size_t before = found.hit.geomID == TracedShape::kClear ? shape.clear_from : 0;
  const Shape::Triangle& triangle = shape.triangles[before + found.hit.primID];
  const auto& [a, b, c] = triangle.corners;
  const Vector flat =
      object.normals.apply(cross(shape.points[b] - shape.points[a], shape.points[c] - shape.points[a]));
  const float u = found.hit.u, v = found.hit.v;
  const Vector smooth = shape.normals[a] * (1 - u - v) + shape.normals[b] * u + shape.normals[c] * v;
  hit.from_behind = dot(flat, ray.direction) > 0;
  hit.flat_normal = towards(flat, -ray.direction);
  hit.normal = towards(object.normals.apply(smooth), hit.flat_normal);
  hit.finish = &(*object.finishes)[triangle.finish];
  hit.point = ray.origin + ray.direction * hit.distance;
  return hit;
}

}  // namespace solitaire
