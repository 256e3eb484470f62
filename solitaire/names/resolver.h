#pragma once
#include "solitaire/names/program.h"

namespace solitaire {

/// Binds the names of one module, whose imports are resolved already. Fills in, throughout the module's tree:
/// NameExpr::binding, every slot, Function::slots and captured, the `assigned` slots of branches and loops,
/// the numbers of fields' names, and every Site. Reports unknown names, assignments to other functions'
/// variables, and statements out of place.
void resolve(Program& program, std::uint32_t module, Diagnostics& diagnostics);

}  // namespace solitaire
