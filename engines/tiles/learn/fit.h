#pragma once
#include <functional>
#include <span>

#include "base/stop_signal.h"
#include "engines/tiles/model/problem.h"
#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// Returns the shapes that weights are fitted for by default: single tiles, pairs, and squares of 2x2 along
/// every two axes that the exemplars have.
std::vector<Size> default_shapes(const Style& style);

/// Adds soft factors whose weights make patches as frequent in maps as they are in the exemplars, as nearly
/// as can be. This is maximum likelihood: at its optimum the expected frequencies of patches equal those of
/// the exemplars. Their gradient is estimated by chains of windows that go on while the weights change
/// (persistent contrastive divergence, Tieleman 2008), and the answer is the mean of the second half of all
/// steps.
///
/// `add_rules` adds what holds of maps of any size to those of the chains, such as what is at their borders:
/// the weights then make up for it. It is left out where it leaves such a map no tiles, and in styles of
/// several zones.
///
/// Throws std::runtime_error where the tiles fit no map of the size that is used, and Interrupted.
void fit_weights(Style& style, std::span<const Size> shapes, std::uint64_t seed, const StopSignal& stop,
                 const std::function<void(Problem&)>& add_rules = {});

}  // namespace solitaire::tiles
