#include "tracegraph/scalar.h"

#include <fmt/format.h>

namespace solitaire {

const char* in_words(Type type) {
  switch (type) {
    case Type::kBool:
      return "a bool";
    case Type::kInt:
      return "an int";
    case Type::kFloat:
      break;
  }
  return "a float";
}

std::string to_text(TypedScalar value) {
  switch (value.type()) {
    case Type::kBool:
      return value.as_int() != 0 ? "true" : "false";
    case Type::kInt:
      return fmt::to_string(value.as_int());
    case Type::kFloat:
      return fmt::format("{:#}", value.as_float());
  }
  return "";
}

std::optional<TypedScalar> converted(TypedScalar value, Type type) {
  if (value.type() == type) return value;
  if (value.type() != Type::kInt) return std::nullopt;
  if (type == Type::kFloat) return TypedScalar::of(value.as_float());
  if (value.as_int() != 0 && value.as_int() != 1) return std::nullopt;
  return TypedScalar::of(value.as_int() == 1);
}

}  // namespace solitaire
