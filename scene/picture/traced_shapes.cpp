#include "scene/picture/traced_shapes.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "scene/error.h"

namespace solitaire {
namespace {

/// One instruction set for all processors, so that all of them compute the same picture; and one thread, so
/// that trees are always built alike.
constexpr const char* kConfiguration = "isa=sse4.2,threads=1";

template <typename Element>
void fill(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count,
          const Element& element) {
  using Stored = decltype(element(0));
  auto* to = static_cast<Stored*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Stored), count));
  if (to == nullptr) throw SceneError("there is not enough memory for a picture");
  for (std::size_t i = 0; i < count; ++i) to[i] = element(i);
}

/// Clear surfaces cast no shadows.
void let_pass(const RTCFilterFunctionNArguments* met) { std::fill_n(met->valid, met->N, 0); }

/// Lets a ray pass a clear surface that is nearer than those that it asks for.
void let_pass_if_near(const RTCFilterFunctionNArguments* met) {
  const float nearest = reinterpret_cast<const TracedShape::Question*>(met->context)->clear_beyond;
  if (RTCRayN_tfar(met->ray, met->N, 0) <= nearest) *met->valid = 0;
}

}  // namespace

void check_embree(RTCDevice device) {
  switch (rtcGetDeviceError(device)) {
    case RTC_ERROR_NONE:
      return;
    case RTC_ERROR_OUT_OF_MEMORY:
      throw SceneError("there is not enough memory for a picture");
    case RTC_ERROR_UNSUPPORTED_CPU:
      throw SceneError("pictures need a processor with SSE4.2");
    default:
      throw SceneError("Embree could not trace the scene");
  }
}

TracedShapes::TracedShapes() : device_(rtcNewDevice(kConfiguration)) { check_embree(device_.get()); }

const TracedShape& TracedShapes::of(const Asset* asset) {
  const auto known = known_.find(asset);
  if (known != known_.end()) return known->second;
  return known_.emplace(asset, prepare(asset == nullptr ? box_shape() : shape_of(*asset))).first->second;
}

TracedShape TracedShapes::prepare(Shape shape) const {
  const auto is_solid = [&](const Shape::Triangle& each) { return shape.finishes[each.finish].opacity >= 1; };
  const auto clear = std::stable_partition(shape.triangles.begin(), shape.triangles.end(), is_solid);
  shape.clear_from = static_cast<std::size_t>(clear - shape.triangles.begin());
  TracedShape traced{std::move(shape), Embree<RTCScene>(rtcNewScene(device()))};
  attach(traced, 0, traced.shape.clear_from, 0);
  attach(traced, traced.shape.clear_from, traced.shape.triangles.size(), TracedShape::kClear);
  rtcCommitScene(traced.scene.get());
  check_embree(device());
  return traced;
}

void TracedShapes::attach(const TracedShape& traced, std::size_t begin, std::size_t end,
                          unsigned number) const {
  if (begin == end) return;
  const Embree<RTCGeometry> geometry(rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE));
  check_embree(device());
  fill(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, traced.shape.points.size(),
       [&](std::size_t i) { return traced.shape.points[i]; });
  fill(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, end - begin,
       [&](std::size_t i) { return traced.shape.triangles[begin + i].corners; });
  if (number == TracedShape::kClear) {
    rtcSetGeometryOccludedFilterFunction(geometry.get(), let_pass);
    rtcSetGeometryIntersectFilterFunction(geometry.get(), let_pass_if_near);
  }
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(traced.scene.get(), geometry.get(), number);
}

}  // namespace solitaire
