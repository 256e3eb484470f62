#include "library/former_addresses.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "base/random.h"
#include "library/freeze.h"
#include "library/program_files.h"
#include "library/program_state.h"
#include "solitaire/names/analyze.h"
#include "solitaire/run/choices.h"
#include "solitaire/run/evaluator.h"

namespace solitaire::api {
namespace {

using Known = std::map<std::string, TypedScalar>;

/// Answers choices with known values, and others by chance, and notes the order in which they come.
class Noted : public Choices {
 public:
  Noted(const AddressTable& addresses, const Known& known) : addresses_(addresses), known_(known) {}

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    met.push_back(addresses_.text(address));
    const auto it = known_.find(met.back());
    const auto value = it == known_.end() ? std::nullopt : converted(it->second, domain.type());
    if (value && domain.contains(*value)) {
      ++used;
      values.push_back(*value);
    } else {
      values.push_back(domain.sample(random_));
    }
    return values.back();
  }
  bool weighs() const override { return true; }

  std::vector<std::string> met;
  std::vector<TypedScalar> values;
  std::size_t used = 0;

 private:
  const AddressTable& addresses_;
  const Known& known_;
  RandomStream random_{0, Purpose::kSuggest, 0};
};

/// Answers choices with values in their order, and notes their addresses.
class InOrder : public Choices {
 public:
  InOrder(const AddressTable& addresses, const std::vector<TypedScalar>& values)
      : addresses_(addresses), values_(values) {}

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    met.push_back(addresses_.text(address));
    const std::size_t number = met.size() - 1;
    return number < values_.size() ? values_[number] : domain.sample(random_);
  }
  bool weighs() const override { return true; }

  std::vector<std::string> met;

 private:
  const AddressTable& addresses_;
  const std::vector<TypedScalar>& values_;
  RandomStream random_{0, Purpose::kSuggest, 0};
};

/// Runs the program as far as it goes: what it makes does not count here, and neither does how it ends.
void run(const solitaire::Program& program, const ParamValues& params, AddressTable& addresses,
         Choices& choices) {
  Limits limits;
  limits.keep_going = true;
  try {
    execute(program, params, choices, addresses, limits);
  } catch (const ProgramError&) {
  }
}

/// A run of a program with a solution's choices, by their addresses.
Noted run_with(const solitaire::Program& program, const ParamValues& params, const Known& known) {
  AddressTable addresses;
  Noted noted(addresses, known);
  run(program, params, addresses, noted);
  return noted;
}

std::optional<solitaire::Program> loaded(const Program& program, Naming naming) {
  LoadOptions options = load_options(program.state());
  options.naming = naming;
  solitaire::Analysis analysis = solitaire::analyze(ProgramFiles({}), program.state().script, options);
  if (analysis.has_errors()) return std::nullopt;
  return std::move(analysis.program);
}

}  // namespace

void name_as_today(const Program& program, std::vector<Choice>& choices) {
  Known known;
  for (const Choice& choice : choices) known.emplace(choice.address, scalar_of(choice.value));
  const auto params = [&] { return values_of_params(program.state(), program.settings()); };
  if (run_with(program.state().program, params(), known).used == known.size()) return;
  for (const Naming naming : {Naming::kWithWrappers, Naming::kAfterFunctions}) {
    const auto former = loaded(program, naming);
    if (!former) return;
    const Noted noted = run_with(*former, params(), known);
    if (noted.used != known.size()) continue;
    AddressTable addresses;
    InOrder today(addresses, noted.values);
    run(program.state().program, params(), addresses, today);
    std::map<std::string, std::string> names;
    for (std::size_t i = 0; i < std::min(noted.met.size(), today.met.size()); ++i)
      names.emplace(noted.met[i], today.met[i]);
    for (Choice& choice : choices) choice.address = names[choice.address];
    return;
  }
}

}  // namespace solitaire::api
