#pragma once
#include <optional>

#include "base/random.h"
#include "kernel/forms.h"
#include "kernel/kernel.h"

namespace solitaire {

/// A value drawn from a choice's distribution given all other choices, exactly. Nothing where the numbers of
/// the form are none of a distribution: far from where the density lies, rounding can hide them.
///
/// `form` is the one in which the density depends on the choice, and not unknown. The numbers are found from
/// how the score differs at a few other values.
std::optional<Scalar> draw_of_form(Kernel& kernel, ChoiceNumber choice, Form form, RandomStream& stream);

/// The same of a choice with few values, by comparing all of them. `distribution` is finite, and has
/// at most kMostValuesCompared values; its weights are not looked at.
Scalar draw_of_few(Kernel& kernel, ChoiceNumber choice, const Distribution& distribution,
                   RandomStream& stream);

}  // namespace solitaire
