// Simulation-based calibration: see calibration.h.
#include "tests/sample/calibration.h"

#include <doctest/doctest.h>

#include "tests/sample/calibrated_models.h"

namespace solitaire {
namespace {

using Engine = SamplingOptions::Engine;

/// One in 10,000 with 7 degrees of freedom.
constexpr double kMostChiSquared = 29.9;

TEST_CASE("calibration: ranks of unknowns among draws of their posterior are uniform, on traces (slow)") {
  for (const CalibratedModel& model : kCalibratedModels) {
    CAPTURE(model.prior);
    CHECK(calibration(model, Engine::kShred, 1, 100) < kMostChiSquared);
  }
}

TEST_CASE("calibration: the same with the lightweight engine") {
  for (const std::size_t number : {1UL, 3UL}) {
    CAPTURE(number);
    CHECK(calibration(kCalibratedModels[number], Engine::kLightweight, 7, 80) < kMostChiSquared);
  }
}

}  // namespace
}  // namespace solitaire
