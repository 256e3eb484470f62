#pragma once
#include <doctest/doctest.h>

#include "engines/tiles/sample/sampler.h"
#include "tests/tiles/enumeration.h"

namespace solitaire::tiles {

/// Checks that maps made by windows come as often as enumeration says. The problem has more than 20 maps.
inline void check_drawn_maps(const Problem& problem) {
  Enumeration all(problem);
  REQUIRE(all.size() > 20);
  SamplerOptions options;
  options.anneal = 4;
  options.sweeps = 14;
  for (std::uint64_t number = 0; number < 800; ++number) {
    const Sample made = draw_sample(problem, consistent_domains(problem), options, number, StopSignal());
    REQUIRE(made.outcome == Outcome::kFound);
    all.draw(made.map);
  }
  CHECK(all.strangers() == 0);
  CHECK(all.chi_squared() < 1.5);
}

}  // namespace solitaire::tiles
