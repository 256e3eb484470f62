#pragma once
#include <cstdint>

#include "base/diagnostic.h"
#include "solitaire/names/naming.h"
#include "solitaire/names/program.h"

namespace solitaire {

/// Binds the names of one module; the modules that it imports have to be resolved already. Fills in,
/// throughout the module's tree: NameExpr::binding, every slot, Function::slots and captured, the `assigned`
/// slots of branches and loops, the positions of fields, and every Site. Reports unknown names,
/// assignments to other functions' variables, and statements out of place. Trees with syntax errors are
/// resolved as far as they go.
void resolve(Program& program, std::uint32_t module, Naming naming, Diagnostics& diagnostics);

}  // namespace solitaire
