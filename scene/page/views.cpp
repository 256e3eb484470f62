#include "scene/page/views.h"

#include "scene/page/plan.h"

namespace solitaire {

std::vector<View> views_of(const Scene& scene) {
  if (scene.objects.empty()) return {};
  return {{"plan", "Plan", svg_plan(scene)}};
}

}  // namespace solitaire
