#include "scene/page/page_files.h"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/page/deflate.h"
#include "scene/page/drawing/views.h"
#include "scene/picture/cutaway.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kBeside = "page";  // the folder of what the page needs
constexpr std::array kProgram = {"page.css", "page.js", "stage.js"};

/// Returns a script that hands a value, given as JSON text, to the page under a key.
std::string delivery(const std::string& key, std::string_view json) {
  return fmt::format("solitaire.deliver({}, {});\n",
                     Json(key).dump(-1, ' ', true, Json::error_handler_t::replace), json);
}

/// The addresses of the walls, which are cut off where they hide something.
Json walls_of(const Scene& scene) {
  Json walls = Json::array();
  for (const SceneObject& object : scene.objects) {
    if (is_like_wall(object)) walls.push_back(object.thing.address);
  }
  return walls;
}

/// Adds the drawings to what is said of a solution.
void say(const std::vector<View>& views, Json& said) {
  Json& json = said["views"];
  if (json.is_null()) json = Json::array();
  for (const View& view : views)
    json.push_back({{"kind", view.kind}, {"title", view.title}, {"svg", view.svg}});
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw SceneError(fmt::format("{}: cannot be read; is the installation whole?", file.string()));
  return bytes;
}

}  // namespace

PageFiles::PageFiles(fs::path folder, fs::path program)
    : folder_(std::move(folder)), program_(std::move(program)) {
  if (fs::exists(folder_ / kBeside)) remove_abandoned_files(folder_ / kBeside);
}

SolutionFiles PageFiles::add(const std::string& name, const Scene* scene, std::string_view glb,
                             const std::string& about) {
  if (!has_program_) copy_program();
  SolutionFiles files{fmt::format("{}/{}.js", kBeside, name), ""};
  Json said = Json::parse(about);
  if (scene) {
    const std::vector<View> views = views_of(*scene);
    if (!views.empty()) {
      files.drawing = fmt::format("{}/{}.svg", kBeside, name);
      write_file_atomically(folder_ / files.drawing, views.back().svg);
    }
    say(views, said);
    said["walls"] = walls_of(*scene);
  }
  Json packed{{"about", deflated_base64(text_of(said))}};
  if (!glb.empty()) packed["glb"] = deflated_base64(glb);
  write_file_atomically(folder_ / files.script, delivery(name, packed.dump()));
  return files;
}

fs::path PageFiles::close(const GalleryInfo& info, const std::vector<GalleryEntry>& entries,
                          std::string_view choices) const {
  write_file_atomically(folder_ / kBeside / "choices.js", delivery("choices", choices));
  const fs::path page = folder_ / "index.html";
  write_file_atomically(page, gallery_html(info, entries));
  return page;
}

/// Puts the scripts and the style sheet beside the page: before the first solution, so that the page of a run
/// that ends early has them.
void PageFiles::copy_program() {
  std::error_code error;
  fs::create_directory(folder_ / kBeside, error);
  if (error) throw SceneError(fmt::format("{}: {}", (folder_ / kBeside).string(), error.message()));
  for (const char* file : kProgram) {
    write_file_atomically(folder_ / kBeside / file, bytes_of(program_ / file));
  }
  has_program_ = true;
}

}  // namespace solitaire
