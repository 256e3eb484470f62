#include "scene/assets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <utility>

#include "base/nearest_name.h"
#include "scene/error.h"
#include "scene/gltf/accessor_view.h"
#include "scene/gltf/asset_model.h"
#include "scene/gltf/left_out.h"
#include "scene/gltf/reader.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

Box3 measured_box(const AssetModel& model) {
  Box3 box;
  for_each_mesh(model, model.roots, Affine{}, [&](const tinygltf::Mesh& mesh, const Affine& map) {
    for (const auto& primitive : mesh.primitives) {
      const AccessorView positions(model.gltf, primitive.attributes.at("POSITION"));
      for (std::size_t i = 0; i < positions.count(); ++i) box.include(map.apply(positions.point(i)));
    }
  });
  return box;
}

/// Beyond it 32-bit floats no longer tell centimetres apart, as in scenes.
bool is_measurable(const Box3& box) {
  constexpr double kLargest = 1e7;  // metres
  const auto near = [](double number) { return std::abs(number) <= kLargest; };
  return std::ranges::all_of(box.low, near) && std::ranges::all_of(box.high, near);
}

int first_material(const AssetModel& model) {
  int material = -1;
  bool found = false;
  for_each_mesh(model, model.roots, Affine{}, [&](const tinygltf::Mesh& mesh, const Affine&) {
    if (!std::exchange(found, true)) material = mesh.primitives.front().material;
  });
  return material;
}

Color material_color(const AssetModel& model) {
  if (model.primary_material == -1) return {1, 1, 1};
  const auto& material = model.gltf.materials[static_cast<std::size_t>(model.primary_material)];
  const auto& factor = material.pbrMetallicRoughness.baseColorFactor;
  return to_screen({factor[0], factor[1], factor[2]});
}

// An author of an asset may state its front in the extras of its root node: "+Z" (glTF's own rule, and what
// goes without saying), "+X", "-Z", "-X", or "none" for a thing that looks the same from all sides.
void read_front(const AssetModel& model, Asset& asset) {
  const auto& extras = model.gltf.nodes[static_cast<std::size_t>(model.roots.front())].extras;
  if (!extras.Has("front") || !extras.Get("front").IsString()) return;
  const auto& front = extras.Get("front").Get<std::string>();
  constexpr std::array<std::string_view, 4> kByTurns = {"+Z", "-X", "-Z", "+X"};
  const auto side = std::find(kByTurns.begin(), kByTurns.end(), front);
  asset.has_front = side != kByTurns.end();
  if (asset.has_front) asset.front_turns = static_cast<int>(side - kByTurns.begin());
}

/// An author may also state that a model keeps its proportions ("keeps_proportions": true), that it is a
/// wall or what opens walls ("role": "wall" or "opening"), and the set that it belongs to ("set": "kitchen").
void read_use(const AssetModel& model, Asset& asset) {
  const auto& extras = model.gltf.nodes[static_cast<std::size_t>(model.roots.front())].extras;
  if (extras.Has("keeps_proportions") && extras.Get("keeps_proportions").IsBool())
    asset.keeps_proportions = extras.Get("keeps_proportions").Get<bool>();
  if (extras.Has("set") && extras.Get("set").IsString()) asset.set = extras.Get("set").Get<std::string>();
  if (!extras.Has("role") || !extras.Get("role").IsString()) return;
  const auto& role = extras.Get("role").Get<std::string>();
  if (role == "wall") asset.role = Asset::Role::kWall;
  if (role == "opening") asset.role = Asset::Role::kOpening;
}

/// Scenes that Solitaire writes have a ground, which is no part of what they show.
bool is_ground(const AssetModel& model, int root) {
  const auto& extras = model.gltf.nodes[static_cast<std::size_t>(root)].extras;
  return extras.Has("role") && extras.Get("role").IsString() &&
         extras.Get("role").Get<std::string>() == "ground";
}

Asset load_asset(const fs::path& file) {
  auto model = std::make_shared<AssetModel>();
  model->gltf = read_gltf(file);
  model->roots = root_nodes(model->gltf);
  std::erase_if(model->roots, [&](int root) { return is_ground(*model, root); });
  model->primary_material = first_material(*model);

  Asset asset;
  asset.name = file.stem().string();
  asset.box = measured_box(*model);
  if (asset.box.empty()) throw SceneError(fmt::format("cannot use {}: it shows nothing", file.string()));
  if (!is_measurable(asset.box))
    throw SceneError(fmt::format("cannot use {}: it reaches further than 10,000 km", file.string()));
  asset.color = material_color(*model);
  asset.left_out = left_out(*model);
  read_front(*model, asset);
  read_use(*model, asset);
  asset.model = std::move(model);
  return asset;
}

bool is_path(const std::string& name) {
  std::string extension = fs::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".glb" || extension == ".gltf";
}

bool can_be_bundled(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

constexpr std::size_t kMostNamed = 12;  // in a note
constexpr std::size_t kLongestNamed = 60;

std::string shortened(const std::string& name) {
  return name.size() <= kLongestNamed ? name : name.substr(0, kLongestNamed) + "...";
}

}  // namespace

Vec3 natural_size(const Asset& asset) {
  const Vec3 size = asset.box.size();
  return asset.front_turns % 2 == 0 ? Vec3{size[0], size[2], size[1]} : Vec3{size[2], size[0], size[1]};
}

AssetLibrary::AssetLibrary(fs::path bundled, fs::path script_folder, std::vector<fs::path> own)
    : folders_(std::move(own)), script_folder_(std::move(script_folder)) {
  folders_.push_back(std::move(bundled));
}

std::vector<std::string> AssetLibrary::names() const {
  std::set<std::string> names;
  for (const fs::path& folder : folders_) {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() == ".glb" && can_be_bundled(name)) names.insert(name);
    }
    if (missing) throw SceneError(fmt::format("cannot read {}: {}", folder.string(), missing.message()));
  }
  return {names.begin(), names.end()};
}

const Asset* AssetLibrary::find(const std::string& name, const std::string& folder) {
  const std::pair key(name, folder);
  if (const auto known = by_name_.find(key); known != by_name_.end()) return known->second;
  const Asset* asset = nullptr;
  if (is_path(name)) {
    asset = load(name, file_of(name, folder));
  } else if (can_be_bundled(name)) {
    const auto has_it = [&](const fs::path& each) {
      std::error_code none;
      return fs::exists(each / (name + ".glb"), none);
    };
    const auto found = std::find_if(folders_.begin(), folders_.end(), has_it);
    if (found != folders_.end()) asset = load(name, *found / (name + ".glb"));
  }
  return by_name_[key] = asset;
}

const Asset& AssetLibrary::made(const std::string& name, const std::function<Asset()>& make) {
  if (const auto known = made_.find(name); known != made_.end()) return known->second;
  const Asset& asset = made_.emplace(name, make()).first->second;
  by_name_[{name, ""}] = &asset;
  return asset;
}

fs::path AssetLibrary::file_of(const std::string& name, const std::string& folder) const {
  std::error_code none;
  const fs::path beside = script_folder_ / folder / name;
  return !folder.empty() && fs::exists(beside, none) ? beside : script_folder_ / name;
}

std::vector<std::string> AssetLibrary::notes() const {
  std::vector<std::string> notes;
  if (std::string boxes = boxes_note(); !boxes.empty()) notes.push_back(std::move(boxes));
  for (const auto& [file, asset] : by_file_) {
    if (!asset.left_out.empty())
      notes.push_back(fmt::format("{} is shown without {}", file.filename().string(), asset.left_out));
  }
  return notes;
}

/// Says which names have no model, and what those that are nearly a model's were perhaps meant to be.
std::string AssetLibrary::boxes_note() const {
  std::vector<std::string> boxes, models;
  for (const auto& [key, asset] : by_name_) {
    const std::string& name = key.first;
    if (asset != nullptr || name.empty() || name == "box") continue;
    if (std::ranges::find(boxes, name) != boxes.end()) continue;
    if (models.empty()) models = names();
    boxes.push_back(name);
  }
  const std::size_t count = boxes.size();
  boxes.resize(std::min(count, kMostNamed));
  for (std::string& name : boxes) {
    const std::string meant = misspelled_name(name, models);
    name = shortened(name) + (meant.empty() ? "" : fmt::format(" (did you mean {}?)", meant));
  }
  if (count == 0) return "";
  return fmt::format("{}{}: no model is called so, and boxes stand there", fmt::join(boxes, ", "),
                     count > kMostNamed ? fmt::format(" and {} others", count - kMostNamed) : "");
}

const Asset* AssetLibrary::load(const std::string& name, const fs::path& file) {
  std::error_code missing;
  const fs::path canonical = fs::canonical(file, missing);
  if (missing)
    throw SceneError(
        fmt::format("cannot read the asset \"{}\": {}: {}", name, file.string(), missing.message()));
  const auto known = by_file_.find(canonical);
  if (known != by_file_.end()) return &known->second;
  return &by_file_.emplace(canonical, load_asset(canonical)).first->second;
}

}  // namespace solitaire
