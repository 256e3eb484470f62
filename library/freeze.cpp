#include "library/freeze.h"

#include <filesystem>

namespace solitaire::api {
namespace {

/// Returns "file.sol:3:8", without the folder, so that files do not depend on where the program stands.
std::string place(Span span, const SourceSet& sources) {
  return std::filesystem::path(sources.place(span)).filename().string();
}

/// Makes the public form of each kind of value.
struct Freezer {
  Value operator()(const PlainValue::Nil&) const { return {Nil{}}; }
  Value operator()(const PlainValue::List& list) const {
    List made;
    made.items.reserve(list.items.size());
    for (const PlainValue& item : list.items) made.items.push_back(frozen(item));
    return {std::move(made)};
  }
  Value operator()(const PlainValue::Record& record) const {
    Record made{record.type, {}};
    for (std::size_t i = 0; i < record.values.size(); ++i)
      made.fields.push_back({record.names[i], frozen(record.values[i])});
    return {std::move(made)};
  }
  Value operator()(const PlainValue::Function& function) const { return {Function{function.name}}; }
  template <class Scalar>
  Value operator()(const Scalar& scalar) const {
    return {scalar};
  }
};

std::vector<Choice> frozen_choices(const ChosenValues& choices) {
  std::vector<Choice> made;
  made.reserve(choices.size());
  for (const ChosenValue& choice : choices) made.push_back(frozen(choice));
  return made;
}

Placement frozen(const PlacedObject& placement) {
  return {placement.asset,  placement.at,
          placement.size,   placement.turn,
          placement.angle,  placement.color,
          placement.name,   placement.address,
          placement.calls,  frozen_choices(placement.choices),
          placement.extras, placement.source,
          placement.folder};
}

BrokenAssert frozen(const solitaire::BrokenAssert& broken, const SourceSet& sources) {
  return {broken.address, place(broken.span, sources), std::string(sources.text(broken.span)), broken.message,
          broken.choices};
}

UnmetWish frozen(const solitaire::UnmetWish& wish, const SourceSet& sources) {
  return {wish.address, place(wish.span, sources), std::string(sources.text(wish.span)), wish.cost,
          wish.choices};
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

Value frozen(const PlainValue& value) { return std::visit(Freezer{}, value.is); }

ChoiceValue frozen(TypedScalar value) {
  switch (value.type()) {
    case Type::kBool:
      return value.as_int() != 0;
    case Type::kInt:
      return value.as_int();
    case Type::kFloat:
      break;
  }
  return value.as_float();
}

Choice frozen(const ChosenValue& choice) { return {choice.address, frozen(choice.value), choice.element}; }

TypedScalar scalar_of(const ChoiceValue& value) {
  return std::visit([](auto answer) { return TypedScalar::of(answer); }, value);
}

Solution frozen(const solitaire::Solution& solution, std::uint64_t number, const SourceSet& sources) {
  Solution made;
  made.number = number;
  made.value = frozen(solution.value);
  made.text = solitaire::to_text(solution.value);
  made.choices = frozen_choices(solution.choices);
  made.auxiliary = frozen_choices(solution.auxiliary);
  if (const auto& quality = solution.quality)
    made.quality = Quality{quality->broken,
                           quality->wishes,
                           quality->cost,
                           quality->proved,
                           solution.only_wish && sources.text(*solution.only_wish).starts_with("maximize"),
                           quality->least_cost};
  for (const solitaire::BrokenAssert& broken : solution.broken)
    made.broken.push_back(frozen(broken, sources));
  for (const solitaire::UnmetWish& wish : solution.unmet) made.unmet.push_back(frozen(wish, sources));
  for (const PlacedObject& object : solution.placements) made.placements.push_back(frozen(object));
  made.unit = solution.unit;
  made.printed = solution.printed;
  return made;
}

ChosenValues known_choices(const std::vector<Choice>& choices) {
  ChosenValues known;
  for (const Choice& choice : choices) {
    const TypedScalar value = scalar_of(choice.value);
    known.push_back({choice.address, family_of(value.type()), value});
  }
  return known;
}

}  // namespace solitaire::api
