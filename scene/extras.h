#pragma once
#include <tiny_gltf.h>

#include "solitaire/run/execution.h"

namespace solitaire {

/// What a placed node tells about itself: "address", "source", "choices" ([{"at": address, "value": v}, …]),
/// and the program's further arguments. Blender refuses a whole file for extras that its custom properties
/// cannot hold (numbers beyond 32 bits, lists of strings, keys beyond 63 bytes): such values are written as
/// their JSON text.
tinygltf::Value make_extras(const Placement& placement);

}  // namespace solitaire
