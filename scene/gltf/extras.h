#pragma once
#include <tiny_gltf.h>

#include "scene/placed_thing.h"

namespace solitaire {

/// Returns what a placed node tells about itself: "address", "source", "choices" ([{"at": address, "value":
/// v}, …]), and the program's further arguments. Blender refuses a whole file for extras that its custom
/// properties cannot hold (numbers beyond 32 bits, lists of strings, keys beyond 63 bytes): such values are
/// written as their JSON text.
tinygltf::Value make_extras(const PlacedThing& thing);

}  // namespace solitaire
