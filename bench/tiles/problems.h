#pragma once
#include <memory>
#include <string>

#include "engines/tiles/model/problem.h"

namespace solitaire::tiles::bench {

/// The exemplars, in the folder of the sources. The facades are plainer than that of the examples. In the
/// second one the piers between windows are another tile than walls, so that a storey runs through the whole
/// house: it gets harder as it grows.
inline constexpr const char* kFacade = "bench/tiles/facade";
inline constexpr const char* kStoreys = "bench/tiles/facade_storeys";
inline constexpr const char* kSuburb = "examples/tiles/suburb";

/// Reads one of them, without weights.
std::shared_ptr<Style> style_named(const std::string& name);
/// The same with soft factors of the paper's kind.
std::shared_ptr<Style> step_style(const std::string& name, const std::vector<Size>& shapes, double epsilon);

/// Patches of four tiles, across and down: those that the paper measures facades by.
extern const Size kFourAcross, kFourDown;
/// Returns the mean divergence of patches of four tiles from the exemplars (Kullback-Leibler).
double divergence_of_fours(const Style& style, const std::vector<Grid>& maps);
double shannon_of_fours(const Style& style, const std::vector<Grid>& maps);

/// A facade that fills its map up to a sky of one row and column at the sides.
/// Its lowest row is ground.
Problem facade(std::shared_ptr<const Style> style, int width, int height);
/// A facade in the outline of an L: its upper right quarter is sky, its lowest row ground.
Problem facade_in_l(std::shared_ptr<const Style> style, int side);
/// A city with a crossroad at every twentieth site along both axes.
Problem city(std::shared_ptr<const Style> style, int side);

}  // namespace solitaire::tiles::bench
