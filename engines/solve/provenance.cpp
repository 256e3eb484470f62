#include "engines/solve/provenance.h"

#include <algorithm>
#include <unordered_map>

#include "engines/solve/condition_solver.h"
#include "engines/solve/wide_choices.h"
#include "engines/tuning.h"
#include "tracegraph/cone.h"

namespace solitaire {

/// A trace in which choices may lie outside of their ranges. Within them, intervals can decide a condition,
/// and then no node tells any more on which choices it depends.
class Provenance::WideTrace {
 public:
  WideTrace(const Program& program, const ParamValues& params, const TracingOptions& options, Pins& pins,
            AddressTable& addresses)
      : choices_(nullptr, tuning::kProvenanceReach, pins),
        solver_(program, params, options.exact(), choices_, addresses, pins) {}

  std::set<AddressId> choices_below(const Condition& condition) { return solver_.choices_below({condition}); }

 private:
  WideChoices choices_;
  ConditionSolver solver_;
};

Provenance::Provenance(const Program& program, const ParamValues& params, const TracingOptions& options,
                       Pins& pins, ExecutionSolver& solver)
    : program_(program), params_(params), options_(options), pins_(pins), solver_(solver) {}

Provenance::~Provenance() = default;

void Provenance::add_object_choices(Solution& solution) {
  if (solution.placements.empty()) return;
  std::unordered_map<std::string, PlacedObject*> objects;
  for (PlacedObject& object : solution.placements) objects.emplace(object.address, &object);
  std::unordered_map<std::string, const ChosenValue*> met;
  for (const ChosenValue& choice : solution.choices) met.emplace(choice.address, &choice);

  const AddressTable& addresses = solver_.addresses();
  for (const TracePlaced& placed : solver_.trace().placed) {
    const auto object = objects.find(addresses.text(placed.address));
    if (object == objects.end()) continue;
    ChosenValues& choices = object->second->choices;
    for (const std::size_t number : variables_below(solver_.graph(), placed.depends)) {
      const auto choice = met.find(addresses.text(solver_.graph().variables()[number].address));
      if (choice == met.end()) continue;  // of a path that this execution does not take
      if (std::ranges::find(choices, *choice->second) == choices.end()) choices.push_back(*choice->second);
    }
  }
}

void Provenance::add_wish_choices(Solution& solution) {
  if (solution.unmet.empty()) return;
  const AddressTable& addresses = solver_.addresses();
  std::unordered_map<std::string, UnmetWish*> unmet;
  for (UnmetWish& wish : solution.unmet) unmet.emplace(wish.address, &wish);
  for (const Term& term : solver_.trace().soft_terms) {
    const auto wish = unmet.find(addresses.text(term.address));
    if (wish == unmet.end()) continue;
    std::set<std::string> choices(wish->second->choices.begin(), wish->second->choices.end());
    for (const std::size_t number : variables_below(solver_.graph(), {&term.node, 1}))
      choices.insert(addresses.text(solver_.graph().variables()[number].address));
    wish->second->choices.assign(choices.begin(), choices.end());
  }
}

void Provenance::add_broken_choices(Solution& solution) {
  for (BrokenAssert& broken : solution.broken) {
    std::set<std::string> choices;
    for (const Term& part : solver_.trace().hard_terms) {
      if (part.span == broken.span && solver_.addresses().text(part.address) == broken.address)
        choices.merge(choices_below(part));
    }
    broken.choices.assign(choices.begin(), choices.end());
  }
}

/// Returns the addresses of the choices that an assert depends on.
std::set<std::string> Provenance::choices_below(const Term& part) {
  AddressTable& addresses = solver_.addresses();
  std::set<std::string> below;
  for (const std::size_t number : variables_below(solver_.graph(), {&part.node, 1}))
    below.insert(addresses.text(solver_.graph().variables()[number].address));
  if (!below.empty()) return below;
  if (!wide_) wide_ = std::make_unique<WideTrace>(program_, params_, options_, pins_, addresses);
  const Condition condition{part.requirement, part.address, part.span, part.whole, "", nullptr, {}};
  for (const AddressId address : wide_->choices_below(condition)) below.insert(addresses.text(address));
  return below;
}

}  // namespace solitaire
