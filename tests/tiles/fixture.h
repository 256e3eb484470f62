#pragma once
#include <memory>
#include <string>

#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/model/problem.h"
#include "engines/tiles/read/text.h"

namespace solitaire::tiles {

/// A style learned of one text exemplar.
inline std::shared_ptr<Style> style_of(const std::string& exemplar) {
  auto style = std::make_shared<Style>();
  Exemplar each;
  each.grid = read_text("exemplar.txt", exemplar, style->tileset, true);
  style->exemplars.push_back(each);
  learn_pairs(*style);
  return style;
}

inline Topology flat(int width, int height) { return {{{width, height, 1}}, {}}; }

/// Roads, parks and houses; small enough to list all maps of a few sites.
inline const char* const kStreets =
    "..|...\n"
    "##|.#.\n"
    "--+--.\n"
    "..|.|#\n"
    ".#|.|.\n"
    "--+-+-\n";

}  // namespace solitaire::tiles
