#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace solitaire {

class Value;
class Evaluator;
struct CallExpr;

/// A call of a builtin: its arguments by parameter, and where it stands.
struct BuiltinCall {
  std::span<const Value>
      arguments;  // one for each parameter, Unset where none was given; then the variadic ones
  const CallExpr& site;
  std::span<const std::pair<std::string_view, Value>>
      extras;  // named arguments that no parameter is called like
};

/// A function that the language brings along. The table of all of them is builtins().
struct Builtin {
  std::string_view name;
  std::vector<std::string_view> parameters;
  std::size_t required = 0;   // how many of the parameters must be given
  bool variadic = false;      // takes any number of further arguments by position
  bool takes_extras = false;  // takes further named arguments
  bool is_choice = false;     // its calls are choices: their labels are named after what they decide
  Value (*call)(Evaluator& evaluator, const BuiltinCall& call) = nullptr;
};

const std::vector<Builtin>& builtins();
std::optional<std::uint32_t> find_builtin(std::string_view name);

}  // namespace solitaire
