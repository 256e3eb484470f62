#pragma once
#include <array>
#include <filesystem>
#include <solitaire/export.h>
#include <solitaire/output.h>
#include <solitaire/program.h>
#include <string>
#include <vector>

namespace solitaire::api {

/// A model that programs place by its name.
struct Model {
  std::string name;
  std::string set;               // what it belongs to, such as "kitchen"; "" if its file does not say
  std::array<double, 3> size{};  // width, depth and height in metres, seen from its front
  bool has_front = false;
  bool keeps_proportions = false;
};

/// Returns the models of `files.assets` and the bundled ones, by set and name. Throws Error (kFile).
SOLITAIRE_API std::vector<Model> models(const Files& files = {});

/// Draws each of the models into a file NAME.png of the folder, and for each set a contact sheet, in the
/// models' order, into models-SET.png. Returns the sheets. Throws Error (kFile).
SOLITAIRE_API std::vector<std::filesystem::path> draw_models(const std::vector<Model>& models,
                                                             const std::filesystem::path& folder,
                                                             const PictureSize& size,
                                                             const Files& files = {});

/// Returns the model as a JSON object, on one line.
SOLITAIRE_API std::string to_json(const Model& model);

}  // namespace solitaire::api
