#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <solitaire/models.h>

#include "library/json.h"
#include "library/known_models.h"
#include "library/translate.h"
#include "scene/assets.h"
#include "scene/atomic_file.h"
#include "scene/build_scene.h"
#include "scene/picture/picture_files.h"
#include "scene/picture/png.h"
#include "scene/picture/sheet.h"

namespace solitaire::api {
namespace {

namespace fs = std::filesystem;

AssetLibrary library_of(const Files& files) {
  const fs::path data = files.data.empty() ? installed_data() : files.data;
  return {data / "assets", ".", files.assets};
}

Model model_of(const Asset& asset) {
  Model model{asset.name, asset.set, natural_size(asset), asset.has_front, asset.keeps_proportions};
  for (double& length : model.size) length = rounded(length, 4);
  return model;
}

Scene scene_with(const Model& model, AssetLibrary& assets) {
  PlacedThing thing;
  thing.asset = thing.address = model.name;
  return build_scene({thing}, 1, model.name, assets);
}

std::string sheet_name(const std::string& set) {
  return set.empty() ? "models.png" : fmt::format("models-{}.png", set);
}

}  // namespace

std::vector<Model> models(const Files& files) {
  return translated({}, [&] {
    AssetLibrary assets = library_of(files);
    std::vector<Model> found;
    for (const std::string& name : assets.names()) found.push_back(model_of(*assets.find(name)));
    std::stable_sort(found.begin(), found.end(),
                     [](const Model& a, const Model& b) { return a.set < b.set; });
    return found;
  });
}

std::vector<fs::path> draw_models(const std::vector<Model>& models, const fs::path& folder,
                                  const PictureSize& size, const Files& files) {
  return translated({}, [&] {
    fs::create_directories(folder);
    AssetLibrary assets = library_of(files);
    PictureFiles pictures(folder, solitaire::PictureSize{size.width, size.height}, 1);
    std::map<std::string, std::vector<fs::path>> sets;
    for (const Model& model : models)
      sets[model.set].push_back(folder / pictures.draw(scene_with(model, assets), model.name));
    std::vector<fs::path> sheets;
    for (const auto& [set, files_of_set] : sets) {
      sheets.push_back(folder / sheet_name(set));
      write_file_atomically(sheets.back(), png_bytes(contact_sheet(files_of_set)));
    }
    return sheets;
  });
}

std::string to_json(const Model& model) {
  const Json json{{"name", model.name},
                  {"set", model.set},
                  {"size", model.size},
                  {"front", model.has_front},
                  {"keeps_proportions", model.keeps_proportions}};
  return json_text(json);
}

}  // namespace solitaire::api
