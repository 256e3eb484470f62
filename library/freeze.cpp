#include "library/freeze.h"

#include <filesystem>

namespace solitaire::api {
namespace {

/// Returns "file.sol:3:8", without the folder, so that files do not depend on where the program stands.
std::string place(Span span, const SourceSet& sources) {
  return std::filesystem::path(sources.place(span)).filename().string();
}

List frozen_list(const solitaire::List& list) {
  List made;
  made.items.reserve(list.items.size());
  for (const solitaire::Value& item : list.items) made.items.push_back(frozen(item));
  return made;
}

Record frozen_record(const solitaire::Record& record) {
  Record made{record.type->name, {}};
  for (std::size_t i = 0; i < record.fields.size(); ++i)
    made.fields.push_back({record.type->fields[i].name, frozen(record.fields[i])});
  return made;
}

std::vector<Choice> frozen_choices(const std::vector<AnsweredChoice>& choices) {
  std::vector<Choice> made;
  made.reserve(choices.size());
  for (const AnsweredChoice& choice : choices) made.push_back(frozen(choice));
  return made;
}

Placement frozen(const solitaire::Placement& placement) {
  return {placement.asset,  placement.at,
          placement.size,   placement.turn,
          placement.angle,  placement.color,
          placement.name,   placement.address,
          placement.calls,  frozen_choices(placement.choices),
          placement.extras, placement.source};
}

BrokenAssert frozen(const Rejection& broken, const SourceSet& sources) {
  return {broken.address, place(broken.span, sources), std::string(sources.text(broken.span)), broken.message,
          broken.choices};
}

/// Returns a family of that type; which one is not known of a choice whose value alone was kept.
Distribution::Family family_of(Type type) {
  switch (type) {
    case Type::kBool:
      return Distribution::Family::kFlip;
    case Type::kInt:
      return Distribution::Family::kRange;
    case Type::kFloat:
      break;
  }
  return Distribution::Family::kUniform;
}

}  // namespace

Value frozen(const solitaire::Value& value) {
  using Kind = solitaire::Value::Kind;
  switch (value.kind()) {
    case Kind::kUnset:
    case Kind::kNil:
      return {Nil{}};
    case Kind::kBool:
      return {*value.get<bool>()};
    case Kind::kInt:
      return {*value.get<std::int64_t>()};
    case Kind::kFloat:
      return {*value.get<double>()};
    case Kind::kString:
      return {value.object<String>()->text};
    case Kind::kList:
      return {frozen_list(*value.as_list())};
    case Kind::kRecord:
      return {frozen_record(*value.object<solitaire::Record>())};
    default:
      return {Function{solitaire::to_text(value)}};
  }
}

Choice frozen(const AnsweredChoice& choice) {
  switch (choice.value.type()) {
    case Type::kBool:
      return {choice.address, choice.value.as_int() != 0};
    case Type::kInt:
      return {choice.address, choice.value.as_int()};
    case Type::kFloat:
      break;
  }
  return {choice.address, choice.value.as_float()};
}

Solution frozen(const solitaire::Solution& solution, std::uint64_t number, const SourceSet& sources) {
  const Execution& execution = solution.execution;
  Solution made;
  made.number = number;
  made.value = frozen(execution.value);
  made.text = solitaire::to_text(execution.value);
  made.choices = frozen_choices(solution.answers);
  if (solution.quality) {
    made.quality = Quality{solution.quality->broken, execution.wishes.size(), solution.quality->cost,
                           solution.quality->proved};
  }
  for (const Rejection& broken : execution.broken) made.broken.push_back(frozen(broken, sources));
  for (const solitaire::Placement& placement : execution.placements)
    made.placements.push_back(frozen(placement));
  made.unit = execution.unit;
  made.printed = execution.printed;
  return made;
}

KnownChoices known_choices(const std::vector<Choice>& choices) {
  KnownChoices known;
  for (const Choice& choice : choices) {
    const auto value = std::visit([](auto answer) { return TypedScalar::of(answer); }, choice.value);
    known.push_back({choice.address, family_of(value.type()), value});
  }
  return known;
}

}  // namespace solitaire::api
