#pragma once
#include <embree3/rtcore.h>
#include <memory>
#include <type_traits>

namespace solitaire {

struct ReleaseEmbree {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

/// An Embree object, released at the end.
template <typename Handle>
using Embree = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseEmbree>;

/// Throws SceneError if Embree has failed since the last call.
void check_embree(RTCDevice device);

}  // namespace solitaire
