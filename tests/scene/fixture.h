#pragma once
// What the tests of scene/ have in common.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/build_scene.h"
#include "scene/error.h"

namespace solitaire {

namespace fs = std::filesystem;
using nlohmann::json;

inline const fs::path kAssets = fs::path(SOLITAIRE_SOURCE_DIR) / "assets";

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "solitaire-scene-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
};

inline std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline PlacedThing placed(const std::string& asset, std::array<double, 3> at, std::vector<double> size = {},
                          int turn = 0) {
  PlacedThing thing;
  thing.asset = asset;
  thing.at = at;
  thing.size = std::move(size);
  thing.turn = turn;
  thing.address = fmt::format("{}/{},{},{}/{}", asset, at[0], at[1], at[2], turn);
  thing.source = "test.sol:1:1";
  return thing;
}

inline std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

inline json json_of(const std::string& glb) { return json::parse(glb.substr(20, word(glb, 12))); }

inline std::string with_json(const std::string& glb, const json& changed) {
  std::string text = changed.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string rest = glb.substr(20 + word(glb, 12));
  std::string result = glb.substr(0, 20) + text + rest;
  const auto total = static_cast<std::uint32_t>(result.size()),
             length = static_cast<std::uint32_t>(text.size());
  std::memcpy(result.data() + 8, &total, 4);
  std::memcpy(result.data() + 12, &length, 4);
  return result;
}

/// Where a node's transform takes a point, in program coordinates (x, y, z up). The node may turn about +Y
/// only.
inline Vec3 in_program(const json& node, const Vec3& point) {
  const auto part = [&](const char* name, std::size_t i, double standard) {
    return node.contains(name) ? node[name][i].get<double>() : standard;
  };
  const double angle = 2 * std::atan2(part("rotation", 1, 0), part("rotation", 3, 1));
  const double x = point[0] * part("scale", 0, 1), y = point[1] * part("scale", 1, 1);
  const double z = point[2] * part("scale", 2, 1);
  const double gltf_x = x * std::cos(angle) + z * std::sin(angle) + part("translation", 0, 0);
  const double gltf_z = -x * std::sin(angle) + z * std::cos(angle) + part("translation", 2, 0);
  return {gltf_x, -gltf_z, y + part("translation", 1, 0)};
}

inline const json& node_named(const json& file, const std::string& name) {
  for (const json& node : file["nodes"]) {
    if (node.value("name", "") == name) return node;
  }
  FAIL("no node named ", name);
  return file;
}

inline void check_point(const Vec3& found, const Vec3& expected, double tolerance = 1e-6) {
  for (int axis = 0; axis < 3; ++axis)
    CHECK(std::abs(found[axis] - expected[axis]) < tolerance * (1 + std::abs(expected[axis])));
}

/// A .gltf with a .bin beside it: one triangle, 2 wide, 1 deep, 3 high, first corner at the left of its
/// front; with a texture, below a node that is turned, stretched and moved.
inline json triangle_file(const fs::path& folder) {
  const float corners[] = {-1, 0, 0.5, 1, 0, 0.5, 1, 3, -0.5};
  const float uv[] = {0, 0, 1, 0, 1, 1};
  const std::uint16_t indices[] = {0, 1, 2, 0};
  const std::string png = "\x89PNG\r\n\x1a\n and what else a PNG has, which nobody decodes here";
  std::string bin(reinterpret_cast<const char*>(corners), sizeof corners);
  bin.append(reinterpret_cast<const char*>(uv), sizeof uv);
  bin.append(reinterpret_cast<const char*>(indices), sizeof indices);
  write_file(folder / "triangle.bin", bin);
  write_file(folder / "a picture.png", png);
  return {{"asset", {{"version", "2.0"}}},
          {"buffers", {{{"uri", "triangle.bin"}, {"byteLength", bin.size()}}}},
          {"bufferViews",
           {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 36}},
            {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 24}},
            {{"buffer", 0}, {"byteOffset", 60}, {"byteLength", 8}}}},
          {"accessors",
           {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
            {{"bufferView", 1}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}},
            {{"bufferView", 2}, {"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}}}},
          {"images", {{{"uri", "a%20picture.png"}}}},
          {"samplers", {{{"wrapS", 33071}}}},
          {"textures", {{{"source", 0}, {"sampler", 0}}}},
          {"materials",
           {{{"name", "paper"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}},
            {{"name", "rim"}}}},
          {"meshes",
           {{{"name", "sail"},
             {"primitives",
              {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}, {"indices", 2}, {"material", 0}},
               {{"attributes", {{"POSITION", 0}}}, {"mode", 2}, {"material", 1}}}}}}},
          {"nodes", {{{"name", "sail"}, {"mesh", 0}}}},
          {"scenes", {{{"nodes", {0}}}}},
          {"scene", 0}};
}

inline AssetLibrary bundled() { return AssetLibrary(kAssets, "."); }

inline std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace solitaire
