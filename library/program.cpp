#include <solitaire/program.h>

#include "base/installation.h"
#include "library/program_state.h"
#include "library/translate.h"

namespace solitaire::api {
namespace {

template <class Load>
std::shared_ptr<const Program::State> load_with(const std::filesystem::path& script, const Files& files,
                                                const Load& load) {
  auto state = std::make_shared<Program::State>();
  state->script = script;
  state->data = files.data.empty() ? installed_data() : files.data;
  const LoadOptions options{{state->data, state->data / "solitaire"}};
  state->load_again = [load, options] {
    SourceSet sources_on_error;
    return translated(sources_on_error, [&] { return load(options, sources_on_error); });
  };
  state->program = state->load_again();
  return state;
}

}  // namespace

std::filesystem::path installed_data() {
  return translated({}, [] { return find_data_folder(); });
}

Program Program::load(const std::filesystem::path& script, const Files& files) {
  return Program(load_with(script, files, [script](const LoadOptions& options, SourceSet& sources) {
    return load_program(script, options, sources);
  }));
}

Program Program::from_text(const std::string& name, const std::string& text, const Files& files) {
  return Program(load_with(name, files, [name, text](const LoadOptions& options, SourceSet& sources) {
    return load_program_text(name, text, options, sources);
  }));
}

Program::Program(std::shared_ptr<const State> state) : state_(std::move(state)) {}
Program::~Program() = default;
Program::Program(const Program&) = default;
Program& Program::operator=(const Program&) = default;

void Program::set(const std::string& param, const std::string& value) {
  std::vector<std::pair<std::string, std::string>> settings = settings_;
  settings.emplace_back(param, value);
  values_of_params(*state_, settings);
  settings_ = std::move(settings);
}

std::vector<std::string> Program::params() const {
  std::vector<std::string> names;
  for (const ParamStmt* param : state_->program.params()) names.push_back(param->name);
  return names;
}

std::string Program::name() const { return state_->script.stem().string(); }
std::string Program::file_name() const { return state_->script.filename().string(); }

std::vector<std::shared_ptr<const OwnProgram>> programs_for_workers(const Program& program,
                                                                    std::size_t number) {
  std::vector<std::shared_ptr<const OwnProgram>> programs;
  for (std::size_t i = 0; i < number; ++i) {
    auto own = std::make_shared<OwnProgram>();
    own->program = program.state().load_again();
    own->params = values_of_params(program.state(), program.settings());
    programs.push_back(std::move(own));
  }
  return programs;
}

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
