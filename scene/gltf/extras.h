#pragma once
#include <string>
#include <tiny_gltf.h>

#include "scene/placed_thing.h"

namespace solitaire {

/// Returns what a placed node tells about itself: "address", "source", "choices" ([{"at": address, "value":
/// v}, …]), and the program's further arguments. Blender refuses a whole file for extras that its custom
/// properties cannot hold (numbers beyond 32 bits, lists of strings, keys beyond 63 bytes): such values are
/// written as their JSON text.
tinygltf::Value make_extras(const PlacedThing& thing);

/// Returns the same and the name of the thing as the JSON text of an object, in which nothing has to be text.
std::string facts_text(const PlacedThing& thing, const std::string& name);

}  // namespace solitaire
