#include "scene/page/drawing/views.h"

#include <fmt/format.h>

#include "scene/page/drawing/levels.h"
#include "scene/page/drawing/paper.h"
#include "scene/page/drawing/plan.h"
#include "scene/page/drawing/solids.h"

namespace solitaire {
namespace {

constexpr std::size_t kMostDrawn = 5000;  // objects; drawings of more are large, and nobody can read them

std::string plan_title(const Level& level, bool is_only) {
  return is_only ? "Plan" : fmt::format("Plan from {}", length_text(level.floor));
}

}  // namespace

std::vector<View> views_of(const Scene& scene) {
  if (scene.objects.empty() || scene.objects.size() > kMostDrawn) return {};
  std::vector<View> views;
  const std::vector<Level> levels = levels_of(scene);
  for (const Level& level : levels) {
    views.push_back({"plan", plan_title(level, levels.size() == 1), svg_plan(scene, level)});
  }
  views.push_back({"front", "From the front", svg_elevation(scene, Side::kFront)});
  views.push_back({"side", "From the right", svg_elevation(scene, Side::kRight)});
  views.push_back({"isometric", "Isometric", svg_isometric(scene)});
  return views;
}

}  // namespace solitaire
