#pragma once
#include <string>

#include "scene/gltf/asset_model.h"

namespace solitaire {

/// Says what a model has that placing it loses, such as "its lights"; "" if there is nothing.
std::string left_out(const AssetModel& model);

}  // namespace solitaire
