#include "tracegraph/scalar.h"

#include <fmt/format.h>

namespace solitaire {

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

}  // namespace solitaire
