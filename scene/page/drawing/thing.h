#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace solitaire {

/// An object of a scene, and its node's name, which is unique in it.
struct NamedObject {
  const SceneObject* object;
  const std::string* name;
};

/// Returns the objects with these indices, in the order of the scene's tree.
std::vector<NamedObject> named_objects(const Scene& scene, const std::vector<std::size_t>& indices);

/// Returns all of a scene's objects.
std::vector<NamedObject> named_objects(const Scene& scene);

/// Returns an element for the drawing of an object, which says its name, address, height and what it breaks
/// to whoever points at it.
std::string thing_element(const SceneObject& object, std::string_view unique_name, std::string_view content);

}  // namespace solitaire
