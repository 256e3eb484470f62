#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace solitaire {

/// Brings the JSON of a glTF file into the form that tinygltf reads rightly. URIs get the file's name, found
/// as it is written or percent-decoded, in an encoding that it decodes to the same name; data URIs lose their
/// parameters. Returns true if anything changed. Throws SceneError for what tinygltf would pass over or not
/// name: another version of glTF, extensions that are needed and not supported, files that are missing or lie
/// outside of `folder`, and numbers that are none.
bool prepare_json(nlohmann::json& file, const std::filesystem::path& folder);

/// Returns true if the file lies in the folder or below.
bool lies_within(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace solitaire
