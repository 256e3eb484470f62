#pragma once
#include <functional>

namespace solitaire {

/// Runs `work` to its end on a stack that is large enough for the deepest recursion that --max-depth allows
/// by default. Exceptions must not leave `work`.
void run_on_large_stack(const std::function<void()>& work);

}  // namespace solitaire
