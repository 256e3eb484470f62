#include "engines/tiles/sample/block_shapes.h"

#include <utility>

namespace solitaire::tiles {

std::vector<Size> block_shapes(int set) {
  // Each shape with the first set that has it.
  static const std::pair<int, Size> kShapes[] = {{1, {{1, 1, 1}}}, {2, {{2, 1, 1}}}, {2, {{1, 2, 1}}},
                                                 {3, {{2, 2, 1}}}, {4, {{4, 1, 1}}}, {4, {{1, 4, 1}}},
                                                 {5, {{3, 3, 1}}}, {6, {{4, 4, 1}}}};
  std::vector<Size> shapes;
  for (const auto& [first, shape] : kShapes) {
    if (first <= set) shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace solitaire::tiles
