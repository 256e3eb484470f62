#include "solitaire/names/lookup.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <string_view>

#include "base/nearest_name.h"
#include "solitaire/builtins/builtin.h"

namespace solitaire {
namespace {

struct ForeignName {
  std::string_view name, help;
};

/// What other languages call like this, and what to write for it.
constexpr ForeignName kForeignNames[] = {
    {"None", "the value for nothing is nil"},
    {"null", "the value for nothing is nil"},
    {"undefined", "the value for nothing is nil"},
    {"True", "the bools are true and false"},
    {"False", "the bools are true and false"},
    {"len", "write length(list)"},
    {"size", "write length(list)"},
    {"int", "floor(x) makes an int of a float, and 1.0 * x a float of an int"},
    {"float", "floor(x) makes an int of a float, and 1.0 * x a float of an int"},
    {"round", "floor(x + 0.5) rounds a number"},
    {"ceil", "-floor(-x) rounds a number up"},
    {"random", "range(lo, hi) chooses an int"},
    {"randint", "range(lo, hi) chooses an int"},
    {"randrange", "range(lo, hi) chooses an int"},
    {"rand", "range(lo, hi) chooses an int"},
    {"shuffle", "a list in any order is one of choices that differ: assert(distinct(list))"},
    {"unique", "distinct(list) is true where all elements differ"},
    {"find", "index_of(list, value) is where it stands first"},
    {"index", "index_of(list, value) is where it stands first"},
    {"append", "list + [value] is a list with one element more"},
    {"push", "list + [value] is a list with one element more"},
    {"mean", "1.0 * sum(list) / length(list) is the mean"},
    {"average", "1.0 * sum(list) / length(list) is the mean"},
    {"reduce", "go through the list in a loop: for x in list: total = total * x"},
    {"fold", "go through the list in a loop: for x in list: total = total * x"},
    {"product", "go through the list in a loop: for x in list: total = total * x"},
};

/// Returns "" for a name that is not known.
std::string help_for_foreign_name(std::string_view name) {
  const auto known = std::ranges::find(kForeignNames, name, &ForeignName::name);
  return known == std::end(kForeignNames) ? "" : std::string(known->help);
}

bool was_skipped(const Module& module, const std::string& name) {
  const std::vector<std::string>& skipped = module.tree.skipped_names;
  return std::binary_search(skipped.begin(), skipped.end(), name);
}

}  // namespace

Binding Lookup::find(Scope& scope, const std::string& name) const {
  std::uint32_t level = 0;
  for (Scope* at = &scope; at != nullptr; at = at->outer, ++level) {
    const auto slot = at->find(name);
    if (!slot) continue;
    if (level == 0) return {Binding::Kind::kLocal, 0, *slot};
    at->read_inside.insert(*slot);
    if (at->outer == nullptr) return {Binding::Kind::kModule, module_, *slot};
    return {Binding::Kind::kOuter, level, *slot};
  }
  // The last import of a name wins, as the last assignment does.
  const std::vector<std::uint32_t>& imports = program_.modules[module_].imports;
  for (auto module = imports.rbegin(); module != imports.rend(); ++module) {
    const auto& names = program_.modules[*module].names;
    const auto it = names.find(name);
    if (it != names.end()) return {Binding::Kind::kModule, *module, it->second};
  }
  if (const auto builtin = find_builtin(name)) return {Binding::Kind::kBuiltin, *builtin, 0};
  return {};
}

std::optional<Span> Lookup::definition(const Scope& scope, const Binding& binding) const {
  const bool is_here = binding.kind == Binding::Kind::kModule && binding.level == module_;
  if (binding.kind != Binding::Kind::kOuter && !is_here) return std::nullopt;
  const Scope* at = &scope;
  for (std::uint32_t level = 0; at->outer != nullptr && (is_here || level < binding.level); ++level)
    at = at->outer;
  return at->definitions[binding.slot];
}

void Lookup::report_unknown(const Scope& scope, const NameExpr& node, Diagnostics& diagnostics) const {
  if (may_be_unread(node.name) || diagnostics.is_full()) return;
  std::string help = help_for_foreign_name(node.name);
  if (!help.empty()) {
    // it says what to write
  } else if (const std::string nearest = nearest_name(node.name, visible_names(scope)); !nearest.empty()) {
    help = fmt::format("did you mean '{}'?", nearest);
  }
  diagnostics.add("unknown-name", node.span, fmt::format("there is no '{}' here", node.name), help);
}

/// Returns true if the name may be defined in text that could not be read: in what recovery skipped here or
/// in an imported file, or in a file that is missing.
bool Lookup::may_be_unread(const std::string& name) const {
  const Module& module = program_.modules[module_];
  return !module.imports_known || was_skipped(module, name) ||
         std::any_of(module.imports.begin(), module.imports.end(),
                     [&](std::uint32_t imported) { return was_skipped(program_.modules[imported], name); });
}

std::vector<std::string> Lookup::visible_names(const Scope& scope) const {
  std::vector<std::string> names;
  for (const Scope* at = &scope; at != nullptr; at = at->outer) {
    for (const auto& [name, slot] : at->names) names.push_back(name);
    for (const auto& [name, slot] : at->inner) names.push_back(name);
  }
  for (const std::uint32_t module : program_.modules[module_].imports) {
    for (const auto& [name, slot] : program_.modules[module].names) names.push_back(name);
  }
  for (const Builtin& builtin : builtins()) names.emplace_back(builtin.name);
  return names;
}

}  // namespace solitaire
