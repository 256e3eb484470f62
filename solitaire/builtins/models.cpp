#include "solitaire/builtins/models.h"

#include <cmath>
#include <fmt/format.h>

#include "base/nearest_name.h"
#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

/// A size that is a whole number of units but for this share counts as one: 0.9 m are 3 units of 0.3 m.
constexpr double kSlack = 1e-6;

[[noreturn]] void no_such_model(Evaluator& evaluator, const std::string& name, Span span) {
  const Models* models = evaluator.program().models.get();
  const std::string nearest = models == nullptr ? "" : nearest_name(name, models->names());
  evaluator.program_error(span, fmt::format("there is no model '{}'", name),
                          nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest));
}

/// use(facts) of the model that the first argument names; of each, merged, if it is chosen.
template <class Use>
Value of_model(Evaluator& evaluator, const BuiltinCall& call, const Use& use) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& name) -> Value {
    const String* text = name.object<String>();
    if (text == nullptr)
      evaluator.program_error(span, "the name of a model is a string, not " + describe(name));
    const Models* models = evaluator.program().models.get();
    const auto facts = models == nullptr ? std::nullopt : models->find(text->text);
    if (!facts) no_such_model(evaluator, text->text, span);
    return use(*facts);
  });
}

/// The length of a unit in metres; nothing where none is given.
std::optional<double> given_unit(Evaluator& evaluator, const BuiltinCall& call) {
  const Value& unit = call.arguments[1];
  if (!given(unit)) return std::nullopt;
  double metres = 0;
  if (const auto* i = unit.get<std::int64_t>()) metres = static_cast<double>(*i);
  if (const auto* d = unit.get<double>()) metres = *d;
  if (!(metres > 0 && std::isfinite(metres)))
    evaluator.program_error(call.site.span,
                            "a unit is a positive number of metres that no choice decides about");
  return metres;
}

}  // namespace

Value size_of(Evaluator& evaluator, const BuiltinCall& call) {
  const std::optional<double> unit = given_unit(evaluator, call);
  return of_model(evaluator, call, [&](const ModelFacts& facts) {
    std::vector<Value> size;
    for (const double length : facts.size) {
      if (unit) {
        size.emplace_back(static_cast<std::int64_t>(std::ceil(length / *unit * (1 - kSlack))));
      } else {
        size.emplace_back(length);
      }
    }
    return evaluator.make_list(std::move(size), call.site.span);
  });
}

Value has_front(Evaluator& evaluator, const BuiltinCall& call) {
  return of_model(evaluator, call, [](const ModelFacts& facts) { return Value(facts.has_front); });
}

}  // namespace solitaire
