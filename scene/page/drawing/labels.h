#pragma once
#include <string>
#include <vector>

#include "scene/color.h"
#include "scene/page/drawing/paper.h"
#include "scene/page/drawing/thing.h"

namespace solitaire {

/// The drawing of an object, and where its name may stand.
struct LabelledShape {
  NamedObject named;
  std::string drawing;  // its elements
  Area covered;         // hides what was drawn before; empty for an outline
  Area label;           // in whose middle the name may stand; empty for none
  Color fill;           // under the name
};

/// Returns the shapes in the given order, each with its name where that fits into its place and no later
/// shape and no other name covers it.
std::string with_labels(const std::vector<LabelledShape>& shapes);

}  // namespace solitaire
