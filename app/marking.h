#pragma once
#include "base/source.h"
#include "engines/engine.h"

namespace solitaire {

/// The solution's placed things, those red that a broken assert is about: one of the choices it depends on
/// decides about the thing. They carry the assert's place and condition as an extra, "broken".
std::vector<Placement> marked_placements(const Solution& solution, const SourceSet& sources);

}  // namespace solitaire
