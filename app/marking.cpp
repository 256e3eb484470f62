#include "app/marking.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/solution_json.h"

namespace solitaire {
namespace {

constexpr std::array<double, 3> kRed = {0.85, 0.1, 0.1};

bool concerns(const Rejection& broken, const Placement& placement) {
  return std::any_of(placement.choices.begin(), placement.choices.end(), [&](const AnsweredChoice& choice) {
    return std::find(broken.choices.begin(), broken.choices.end(), choice.address) != broken.choices.end();
  });
}

}  // namespace

std::vector<Placement> marked_placements(const Solution& solution, const SourceSet& sources) {
  std::vector<Placement> placements = solution.execution.placements;
  for (Placement& placement : placements) {
    nlohmann::json broken = nlohmann::json::array();
    for (const Rejection& each : solution.execution.broken) {
      if (concerns(each, placement)) broken.push_back(broken_text(each, sources));
    }
    if (broken.empty()) continue;
    placement.color = kRed;
    placement.extras.emplace_back("broken",
                                  broken.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return placements;
}

}  // namespace solitaire
