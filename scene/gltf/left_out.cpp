#include "scene/gltf/left_out.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace solitaire {
namespace {

bool is_deformed(const std::vector<double>& weights) {
  return std::ranges::any_of(weights, [](double weight) { return weight != 0; });
}

}  // namespace

std::string left_out(const AssetModel& model) {
  const tinygltf::Model& gltf = model.gltf;
  const bool deformed =
      std::ranges::any_of(gltf.meshes, [](const auto& mesh) { return is_deformed(mesh.weights); }) ||
      std::ranges::any_of(gltf.nodes, [](const auto& node) { return is_deformed(node.weights); });
  std::vector<std::string> lost;
  if (!gltf.lights.empty()) lost.emplace_back("its lights");
  if (gltf.extensions.contains("KHR_materials_variants"))
    lost.emplace_back("its further variants of materials");
  if (deformed) lost.emplace_back("the shape that its morph targets give it");
  return fmt::format("{}", fmt::join(lost, ", "));
}

}  // namespace solitaire
