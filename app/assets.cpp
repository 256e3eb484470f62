#include <algorithm>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/session.h"

namespace solitaire::app {
namespace {

bool is_asked_for(const Model& model, const std::vector<std::string>& names) {
  return names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
           return name == model.name || name == model.set;
         });
}

std::vector<Model> asked_models(const Options& options) {
  std::vector<Model> found = models(files_of(options));
  for (const std::string& name : options.models) {
    if (std::none_of(found.begin(), found.end(),
                     [&](const Model& each) { return is_asked_for(each, {name}); }))
      throw Error(Error::Kind::kUsage, fmt::format("there is no model and no set of models '{}'", name));
  }
  std::erase_if(found, [&](const Model& each) { return !is_asked_for(each, options.models); });
  return found;
}

/// Bricks are millimetres large.
std::string size_text(const Model& model) {
  const auto& [width, depth, height] = model.size;
  const int digits = std::max({width, depth, height}) < 0.1 ? 4 : 2;
  return fmt::format("{:.{}f} x {:.{}f} x {:.{}f}", width, digits, depth, digits, height, digits);
}

std::string model_table(const std::vector<Model>& models) {
  std::string text = fmt::format("{:<12} {:<22} {:<24} {}\n", "set", "name", "size in metres", "front");
  for (const Model& model : models) {
    text += fmt::format("{:<12} {:<22} {:<24} {}\n", model.set, model.name, size_text(model),
                        model.has_front ? "yes" : "no");
  }
  return text;
}

std::string json_lines(const std::vector<Model>& models) {
  std::string text;
  for (const Model& model : models) text += to_json(model) + "\n";
  return text;
}

}  // namespace

/// Lists models, and draws them if pictures are asked for.
ExitStatus assets_command(const Options& options, Watchdog& watchdog) {
  const std::vector<Model> models = asked_models(options);
  std::vector<std::filesystem::path> sheets;
  if (options.pictures)
    sheets = draw_models(models, options.output, options.pictures->size, files_of(options));
  const auto lock = watchdog.delivering();
  print_result(options.json ? json_lines(models) : model_table(models));
  for (const auto& sheet : sheets) {
    if (!options.quiet) tell(fmt::format("see {}\n", sheet.string()));
  }
  return watchdog.conclude(kDelivered);
}

}  // namespace solitaire::app
