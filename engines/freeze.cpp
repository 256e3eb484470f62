#include "engines/freeze.h"

#include <utility>

#include "solitaire/value/plain_copy.h"
#include "solitaire/value/short_text.h"

namespace solitaire {
namespace {

BrokenAssert broken_of(Rejection rejection) {
  return {rejection.span, rejection.whole, std::move(rejection.address), std::move(rejection.message), {}};
}

}  // namespace

Solution solution_of(Execution execution, const AddressTable& addresses) {
  Solution solution;
  solution.value = plain(execution.value);
  if (!execution.before_output.is<Value::Unset>()) solution.before_output = plain(execution.before_output);
  solution.choices.reserve(execution.choices.size());
  for (const MetChoice& choice : execution.choices)
    (choice.auxiliary ? solution.auxiliary : solution.choices)
        .push_back(
            {addresses.text(choice.address), choice.domain.family, choice.value, short_text(choice.element)});
  solution.placements.reserve(execution.placements.size());
  for (Placement& placement : execution.placements)
    solution.placements.push_back({static_cast<PlacedItem&&>(placement), {}});
  for (Rejection& rejection : execution.broken) solution.broken.push_back(broken_of(std::move(rejection)));
  if (execution.wishes.size() == 1) solution.only_wish = execution.wishes.front().span;
  for (WishCost& wish : execution.wishes) {
    if (wish.cost > 0) solution.unmet.push_back({wish.span, std::move(wish.address), wish.cost, {}});
  }
  solution.unit = execution.unit;
  solution.printed = std::move(execution.printed);
  return solution;
}

ChosenValues all_choices(const Solution& solution) {
  ChosenValues all = solution.choices;
  all.insert(all.end(), solution.auxiliary.begin(), solution.auxiliary.end());
  return all;
}

}  // namespace solitaire
