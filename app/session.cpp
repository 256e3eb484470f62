#include "app/session.h"

#include <cstdlib>
#include <fmt/format.h>

#include "app/signals.h"

namespace solitaire::app {
namespace {

std::filesystem::path data_folder() {
  const char* const folder = std::getenv("SOLITAIRE_DATA");
  if (folder == nullptr || *folder == '\0') return installed_data();
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw Error(Error::Kind::kFile, fmt::format("SOLITAIRE_DATA names no folder: '{}'", folder));
  return folder;
}

Program load(const Options& options) {
  Program program = Program::load(options.script, files_of(options));
  for (const std::string& setting : options.settings) {
    const std::size_t sign = setting.find('=');
    program.set(setting.substr(0, sign), setting.substr(sign + 1));
  }
  for (const std::string& data : options.data) {
    const std::size_t sign = data.find('=');
    program.set_from_file(data.substr(0, sign), data.substr(sign + 1));
  }
  return program;
}

SearchOptions asked(const Options& options) {
  SearchOptions search = options.search;
  for (const std::string& text : options.pins)
    search.pins.push_back(parse_pin(text, false, fmt::format("--pin '{}'", text)));
  for (const std::string& text : options.forbidden)
    search.pins.push_back(parse_pin(text, true, fmt::format("--forbid '{}'", text)));
  search.stop = stop_source().token();
  return search;
}

}  // namespace

Files files_of(const Options& options) { return {.data = data_folder(), .assets = options.assets}; }

Session::Session(const Options& options) : program(load(options)), search(asked(options)) {}

}  // namespace solitaire::app
