#pragma once
#include <optional>

#include "base/random.h"
#include "kernel/kernel.h"

namespace solitaire {

/// A value drawn from a choice's distribution given all other choices, exactly. Its form is known. Nothing
/// where the numbers of the form are none of a distribution.
std::optional<Scalar> draw_of_form(Kernel& kernel, ChoiceNumber choice, RandomStream& stream);

/// The same of a choice with few values, whose form is not known, by comparing all of them. `distribution` is
/// finite, and has at most kMostValuesCompared values; its weights are not looked at.
Scalar draw_of_few(Kernel& kernel, ChoiceNumber choice, const Distribution& distribution,
                   RandomStream& stream);

}  // namespace solitaire
