#include "scene/gltf/source_json.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "scene/error.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Extensions that change only what materials look like are copied with the materials.
constexpr std::array<std::string_view, 5> kSupportedExtensions = {
    "KHR_materials_", "KHR_texture_transform", "KHR_lights_punctual", "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing"};

constexpr std::size_t kLongestShownUri = 80;

std::string shown(const std::string& uri) {
  return uri.size() <= kLongestShownUri ? uri : uri.substr(0, kLongestShownUri) + "...";
}

/// Visits the elements of an array of the file, if it has such an array.
template <typename Visit>
void for_each(Json& file, const char* name, const Visit& visit) {
  if (!file.contains(name) || !file[name].is_array()) return;
  for (Json& each : file[name]) visit(each);
}

void check_version(const Json& file) {
  const Json asset = file.value("asset", Json::object());
  const Json version = asset.is_object() ? asset.value("version", Json()) : Json();
  if (version.is_string() && version.get_ref<const std::string&>().starts_with("1"))
    throw SceneError("it is a file of glTF 1.0, and models have to be glTF 2.0: convert it");
}

void check_extensions(Json& file) {
  for_each(file, "extensionsRequired", [](const Json& name) {
    if (!name.is_string()) return;
    const auto& extension = name.get_ref<const std::string&>();
    const bool supported = std::ranges::any_of(
        kSupportedExtensions, [&](std::string_view known) { return extension.starts_with(known); });
    if (!supported)
      throw SceneError(fmt::format("it needs the extension {}, which is not supported", shown(extension)));
  });
}

// ---- numbers, which tinygltf takes as left out where they are none

bool is_list_of_numbers(const Json& value) {
  return value.is_array() && std::ranges::all_of(value, [](const Json& each) { return each.is_number(); });
}

void check_lists_of_numbers(Json& file, const char* kind, std::initializer_list<const char*> members) {
  for_each(file, kind, [&](const Json& each) {
    for (const char* member : members) {
      if (each.is_object() && each.contains(member) && !is_list_of_numbers(each[member]))
        throw SceneError(fmt::format("a {} in its {} is no list of numbers", member, kind));
    }
  });
}

void check_sizes(Json& file, const char* kind) {
  for_each(file, kind, [&](const Json& each) {
    for (const char* member : {"byteOffset", "byteLength", "byteStride", "count"}) {
      if (each.is_object() && each.contains(member) && !each[member].is_number_unsigned())
        throw SceneError(fmt::format("a {} in its {} is no whole number from 0", member, kind));
    }
  });
}

// ---- URIs

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Returns the text with its percent escapes decoded; a '%' that starts none stays.
std::string decoded(std::string_view text) {
  std::string made;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hex_value(text[i + 1]) : -1;
    const int low = high >= 0 ? hex_value(text[i + 2]) : -1;
    made += low >= 0 ? static_cast<char>(high * 16 + low) : text[i];
    if (low >= 0) i += 2;
  }
  return made;
}

std::string encoded(std::string_view name) {
  constexpr std::string_view kKept = "-_.~/";
  std::string made;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    made += plain || kKept.find(c) != std::string_view::npos
                ? std::string(1, c)
                : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return made;
}

/// Returns the data URI without its parameters. `media` is the type that it gets.
std::string plain_data_uri(const std::string& uri, std::string_view media) {
  const std::size_t comma = std::min(uri.find(','), uri.size());
  const std::string_view head = std::string_view(uri).substr(0, comma);
  if (comma == uri.size() || !head.ends_with(";base64"))
    throw SceneError(fmt::format("its data URI is not base64: {}", shown(uri)));
  return fmt::format("data:{};base64,{}", media, decoded(std::string_view(uri).substr(comma + 1)));
}

/// Returns the name, relative to the folder, of the file that a URI means.
std::string file_of(const std::string& uri, const fs::path& folder) {
  for (const std::string& name : {uri, decoded(uri)}) {
    if (!lies_within(folder, folder / name))
      throw SceneError(
          fmt::format("{} lies outside of the model's folder, where no file is read", shown(uri)));
    std::error_code error;
    if (fs::is_regular_file(folder / name, error)) return name;
  }
  throw SceneError(fmt::format("there is no file {}", shown(uri)));
}

std::string media_of_image(const std::string& uri) {
  return uri.starts_with("data:image/jpeg") ? "image/jpeg" : "image/png";  // what it is, its bytes say
}

bool prepare_uri(Json& holder, const fs::path& folder, bool is_image) {
  if (!holder.is_object() || !holder.contains("uri") || !holder["uri"].is_string()) return false;
  auto& uri = holder["uri"].get_ref<std::string&>();
  if (uri.starts_with("data:")) {
    uri = plain_data_uri(uri, is_image ? media_of_image(uri) : "application/octet-stream");
  } else {
    uri = encoded(file_of(uri, folder));
  }
  return true;
}

}  // namespace

bool lies_within(const fs::path& folder, const fs::path& file) {
  const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::canonical(folder));
  return !relative.empty() && *relative.begin() != "..";
}

bool prepare_json(Json& file, const fs::path& folder) {
  if (!file.is_object()) throw SceneError("its JSON is no object");
  check_version(file);
  check_extensions(file);
  check_lists_of_numbers(file, "nodes", {"translation", "rotation", "scale", "matrix"});
  check_lists_of_numbers(file, "accessors", {"min", "max"});
  check_sizes(file, "bufferViews");
  check_sizes(file, "accessors");
  bool changed = false;
  for_each(file, "buffers", [&](Json& buffer) { changed |= prepare_uri(buffer, folder, false); });
  for_each(file, "images", [&](Json& image) { changed |= prepare_uri(image, folder, true); });
  return changed;
}

}  // namespace solitaire
