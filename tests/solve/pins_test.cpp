// Which pins belong to a choice, whether they name one address or are patterns.
#include "engines/solve/pins/pins.h"

#include <doctest/doctest.h>

namespace solitaire {
namespace {

Pin value_pin(const char* pattern, std::int64_t value, bool forbidden = false) {
  return {AddressPattern(pattern), TypedScalar::of(value), forbidden, pattern};
}

std::vector<std::string> sources_of_pins(const std::vector<const Pin*>& pins) {
  std::vector<std::string> texts;
  for (const Pin* each : pins) texts.push_back(each->source);
  return texts;
}

}  // namespace

TEST_CASE("pins: those that match stand in the order in which they were given, and the first value counts") {
  AddressTable addresses;
  const AddressId x = addresses.address("a[1]/x");
  Pins pins({value_pin("a[1]/x", 9, true), value_pin("a[*]/x", 1), value_pin("a[1]/x", 2),
             value_pin("a/x", 3), value_pin("**/x", 4)},
            addresses);
  CHECK(sources_of_pins(pins.at(x)) == std::vector<std::string>{"a[1]/x", "a[*]/x", "a[1]/x", "**/x"});
  CHECK(pins.fixing(x)->value == TypedScalar::of(std::int64_t{1}));
  Pins turned({value_pin("a[1]/x", 2), value_pin("a[*]/x", 1)}, addresses);
  CHECK(turned.fixing(x)->value == TypedScalar::of(std::int64_t{2}));
  CHECK(pins.fixing(addresses.address("a[1]/y")) == nullptr);
  CHECK(Pins({value_pin("**", 1, true)}, addresses).fixing(x) == nullptr);
}

TEST_CASE("pins: those that match nothing are known") {
  AddressTable addresses;
  const std::vector<AddressId> all = {addresses.address("a[0]/x"), addresses.address("b"),
                                      addresses.address("c")};
  Pins pins({value_pin("a[0]/x", 1), value_pin("a[1]/x", 1), value_pin("b", 1), value_pin("b/*", 1),
             value_pin("*", 1)},
            addresses);
  CHECK(sources_of_pins(pins.unmatched(all)) == std::vector<std::string>{"a[1]/x", "b/*"});
}

TEST_CASE("pins: a value stands for one of a choice's type, or for none") {
  const TypedScalar two = TypedScalar::of(std::int64_t{2});
  CHECK(converted(two, Type::kInt) == two);
  CHECK(converted(two, Type::kFloat) == TypedScalar::of(2.0));
  CHECK(!converted(two, Type::kBool));
  CHECK(converted(TypedScalar::of(std::int64_t{0}), Type::kBool) == TypedScalar::of(false));
  CHECK(converted(TypedScalar::of(std::int64_t{1}), Type::kBool) == TypedScalar::of(true));
  CHECK(!converted(TypedScalar::of(true), Type::kInt));
  CHECK(!converted(TypedScalar::of(2.0), Type::kInt));
  CHECK(!converted(TypedScalar::of(true), Type::kFloat));
}

}  // namespace solitaire
