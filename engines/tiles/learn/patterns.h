#pragma once
#include <vector>

#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// How many patches of each number there are. Those that the index does not know are counted at [0].
struct PatchCounts {
  std::vector<double> count;  // by the patch's number
  double total = 0;
};

/// Packs the tiles of the patch whose first corner is at a place. Returns false if it leaves the grid or has
/// a hole.
bool patch_at(const Grid& grid, const Topology& topology, const Size& shape, const Point& at, unsigned bits,
              PatchCode& code);

/// Adds an exemplar's patches to the index.
void collect_patches(const Exemplar& exemplar, PatchIndex& patches);

/// Counts the patches of a map.
PatchCounts count_patches(const Grid& grid, const Topology& topology, const PatchIndex& patches);
/// Counts the patches of all positive exemplars of a zone.
PatchCounts count_patches(const Style& style, std::size_t zone, const PatchIndex& patches);

/// Learns which tiles may be beside each other and how frequent each is; `style` has tiles and exemplars.
void learn_pairs(Style& style);

/// Adds a soft factor of the paper's kind: a patch that some exemplar of its zone has weighs 1 + epsilon,
/// another one weighs 1.
void add_step_shape(Style& style, const Size& shape, double epsilon);

/// Adds factors of single tiles that multiply each occurrence of a tile by its bias.
void add_biases(Style& style);

}  // namespace solitaire::tiles
