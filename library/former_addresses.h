#pragma once
#include <solitaire/program.h>
#include <solitaire/solution.h>
#include <vector>

namespace solitaire::api {

/// Gives the choices of a solution's file the addresses that they have today, if an earlier version wrote it
/// and named choices in another way. A run of the program with these names meets the same choices in the same
/// order. Leaves the addresses as they are where today's run meets them all, or none does.
void name_as_today(const Program& program, std::vector<Choice>& choices);

}  // namespace solitaire::api
