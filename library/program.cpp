#include <fmt/format.h>
#include <solitaire/program.h>

#include "base/installation.h"
#include "library/data_file.h"
#include "library/known_models.h"
#include "library/known_tile_files.h"
#include "library/program_files.h"
#include "library/program_state.h"
#include "library/translate.h"

namespace solitaire::api {
namespace {

/// Returns a state without its program.
std::shared_ptr<Program::State> state_of(const std::filesystem::path& script, const Files& files) {
  auto state = std::make_shared<Program::State>();
  state->script = script;
  state->data = files.data.empty() ? installed_data() : files.data;
  state->assets = files.assets;
  return state;
}

std::shared_ptr<const Program::State> loaded(const std::filesystem::path& script, const Files& files,
                                             const ProgramFiles& texts) {
  const auto state = state_of(script, files);
  SourceSet sources_on_error;
  state->program = translated(
      sources_on_error, [&] { return load_program(texts, script, load_options(*state), sources_on_error); });
  return state;
}

/// Throws Error (kUsage) unless the program has a param of that name.
void require_known(const Program::State& state, const std::string& param) {
  try {
    require_param(state.program, param);
  } catch (const UnknownParam& error) {
    throw Error(Error::Kind::kUsage, error.what());
  }
}

}  // namespace

LoadOptions load_options(const Program::State& state) {
  return {{state.data, state.data / "solitaire"},
          std::make_shared<KnownModels>(state.asset_library()),
          std::make_shared<KnownTileFiles>(DiskFiles().canonical(state.script).parent_path())};
}

std::filesystem::path installed_data() {
  return translated({}, [] { return find_data_folder(); });
}

Program Program::load(const std::filesystem::path& script, const Files& files) {
  return Program(loaded(script, files, ProgramFiles(files.buffer)));
}

Program Program::from_text(const std::string& name, const std::string& text, const Files& files) {
  ProgramFiles texts(files.buffer);
  texts.set(name, text);
  return Program(loaded(name, files, texts));
}

Analysis analyze(const std::filesystem::path& script, const Files& files) {
  const ProgramFiles texts(files.buffer);
  const auto state = state_of(script, files);
  solitaire::Analysis analysis = solitaire::analyze(texts, script, load_options(*state));
  Analysis made{{}, public_diagnostics(analysis.diagnostics, analysis.program.sources)};
  if (analysis.has_errors()) return made;
  state->program = std::move(analysis.program);
  made.program = Program(state);
  return made;
}

AssetLibrary Program::State::asset_library() const {
  return {data / "assets", DiskFiles().canonical(script).parent_path(), assets};
}

Program::Program(std::shared_ptr<const State> state) : state_(std::move(state)) {}
Program::~Program() = default;
Program::Program(const Program&) = default;
Program& Program::operator=(const Program&) = default;

void Program::set(const std::string& param, const std::string& value) {
  require_known(*state_, param);
  std::vector<std::pair<std::string, std::string>> settings = settings_;
  settings.emplace_back(param, value);
  values_of_params(*state_, settings);
  settings_ = std::move(settings);
}

void Program::set_from_file(const std::string& param, const std::filesystem::path& path) {
  require_known(*state_, param);
  const std::string value = constant_of_file(path);
  try {
    set(param, value);
  } catch (const Error& error) {  // tells the file instead of showing all that it holds as one line
    throw Error(error.kind(), fmt::format("{}: {}", path.string(), error.diagnostics().front().message));
  }
}

std::vector<std::string> Program::params() const {
  std::vector<std::string> names;
  for (const ParamStmt* param : state_->program.params()) names.push_back(param->name);
  return names;
}

std::string Program::name() const { return state_->script.stem().string(); }
std::string Program::file_name() const { return state_->script.filename().string(); }

ParamValues values_of_params(const Program::State& state,
                             const std::vector<std::pair<std::string, std::string>>& settings) {
  SourceSet sources = state.program.sources;
  try {
    return read_params(state.program, settings, sources);
  } catch (const ProgramError& error) {
    throw error_of(Error::Kind::kUsage, error, sources);
  }
}

}  // namespace solitaire::api
