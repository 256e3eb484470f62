#include "engines/solve/executions/provenance.h"

#include <algorithm>
#include <unordered_map>

#include "engines/solve/executions/condition_solver.h"
#include "engines/solve/pins/wide_choices.h"
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
      if (choice == met.end()) continue;  // the execution does not take the choice's path
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
  if (solution.broken.empty()) return;
  Assignment assignment = assignment_of(solution);
  for (BrokenAssert& broken : solution.broken) {
    std::set<std::string> choices;
    for (const Term& part : solver_.trace().hard_terms) {
      if (part.span == broken.span && solver_.addresses().text(part.address) == broken.address)
        choices.merge(choices_below(part, assignment));
    }
    broken.choices.assign(choices.begin(), choices.end());
  }
}

/// The values of the choices that the solution meets; of others, which play no part in it, any.
Assignment Provenance::assignment_of(const Solution& solution) {
  std::unordered_map<std::string, Scalar> values;
  for (const ChosenValue& choice : solution.choices) values.emplace(choice.address, choice.value.scalar());
  std::vector<Scalar> by_variable;
  for (const auto& variable : solver_.graph().variables()) {
    const auto known = values.find(solver_.addresses().text(variable.address));
    by_variable.push_back(known != values.end() ? known->second : Scalar::of(variable.domain.lo));
  }
  return Assignment(solver_.graph(),
                    [by_variable](std::size_t variable) { return by_variable.at(variable); });
}

/// Returns the addresses of the choices that the broken conjuncts of an assert depend on; if that cannot be
/// seen, those of all of it.
std::set<std::string> Provenance::choices_below(const Term& part, Assignment& assignment) {
  AddressTable& addresses = solver_.addresses();
  std::vector<NodeId> broken = conjuncts(solver_.graph(), {part.node});
  std::erase_if(broken, [&](NodeId conjunct) { return assignment.holds(conjunct); });
  if (broken.empty()) broken.push_back(part.node);
  std::set<std::string> below;
  for (const std::size_t number : variables_below(solver_.graph(), broken))
    below.insert(addresses.text(solver_.graph().variables()[number].address));
  if (!below.empty()) return below;
  if (!wide_) wide_ = std::make_unique<WideTrace>(program_, params_, options_, pins_, addresses);
  const Condition condition{part.requirement, part.address, part.span, part.whole, "", "", nullptr, {}};
  for (const AddressId address : wide_->choices_below(condition)) below.insert(addresses.text(address));
  return below;
}

}  // namespace solitaire
