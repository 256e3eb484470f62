#include "tracegraph/print.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <iterator>

#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// Returns the nodes on which the trace's effects depend, operands before what uses them.
std::vector<NodeId> nodes_of(const Graph& graph, const Trace& trace) {
  std::vector<NodeId> roots = trace.returned;
  const auto need = [&](NodeId node) { roots.push_back(node); };
  for (const auto& choice : trace.choices) need(choice.guard), need(choice.variable);
  for (const Term& term : trace.hard_terms) need(term.guard), need(term.node);
  for (const Term& term : trace.soft_terms) need(term.guard), need(term.node);
  for (const auto& blocker : trace.blockers) need(blocker.guard);
  for (const auto& error : trace.program_errors) need(error.guard);
  for (const auto& placed : trace.placed) {
    need(placed.guard);
    for (const NodeId node : placed.depends) need(node);
  }
  std::vector<NodeId> nodes = nodes_below(graph, roots);
  // A node is made after its operands, so the order of making is one of evaluation.
  std::sort(nodes.begin(), nodes.end(), [](NodeId a, NodeId b) { return a.index < b.index; });
  return nodes;
}

std::string constant_text(const Graph& graph, NodeId id) {
  const Scalar value = graph.scalar(id);
  if (graph.node(id).op == Op::kConstTable)
    return fmt::format("table of {}x{}", value.table->rows(), value.table->columns());
  switch (graph.node(id).type()) {
    case Type::kBool:
      return value.i != 0 ? "true" : "false";
    case Type::kInt:
      return fmt::format("{}", value.i);
    case Type::kFloat:
      return fmt::format("{}", value.f);
  }
  return "";
}

const char* requirement_text(ConstraintKind requirement) {
  switch (requirement) {
    case ConstraintKind::kAssert:
      return "assert";
    case ConstraintKind::kLowEnd:
      return "not below its range";
    case ConstraintKind::kHighEnd:
      return "not above its range";
    case ConstraintKind::kStep:
      return "on a step of its range";
    case ConstraintKind::kNotEmpty:
      return "something to choose from";
    case ConstraintKind::kIndex:
      return "an element at the index";
    case ConstraintKind::kDivisor:
      return "a divisor other than zero";
  }
  return "";
}

const char* soft_text(Term::Strength strength) {
  return strength == Term::Strength::kCost ? "cost" : "log_weight";
}

std::string domain_text(const Distribution& domain) {
  switch (domain.family) {
    case Distribution::Family::kFlip:
      return domain.a == 0.5 ? "flip()" : fmt::format("flip({})", domain.a);
    case Distribution::Family::kUniform:
      return fmt::format("uniform({}, {})", domain.a, domain.b);
    case Distribution::Family::kNormal:
      return fmt::format("normal({}, {})", domain.a, domain.b);
    case Distribution::Family::kNormalSharp:
      return fmt::format("normal({}, precision: {})", domain.a, domain.b);
    case Distribution::Family::kExponential:
      return fmt::format("exponential({})", domain.a);
    case Distribution::Family::kGamma:
      return fmt::format("gamma({}, {})", domain.a, domain.b);
    case Distribution::Family::kBeta:
      return fmt::format("beta({}, {})", domain.a, domain.b);
    case Distribution::Family::kPoisson:
      return fmt::format("poisson({})", domain.a);
    case Distribution::Family::kGeometric:
      return fmt::format("geometric({})", domain.a);
    case Distribution::Family::kRange:
    case Distribution::Family::kIndex:
      break;
  }
  if (domain.step != 1) return fmt::format("range({}, {}, {})", domain.lo, domain.hi, domain.step);
  return fmt::format("range({}, {})", domain.lo, domain.hi);
}

using ResultText = std::function<std::string(const NodeNames&)>;

class TextPrinter {
 public:
  TextPrinter(const Graph& graph, const AddressTable& addresses)
      : graph_(graph), addresses_(addresses), numbers_(graph.size(), 0) {}

  std::string run(const Trace& trace, const ResultText& result) {
    for (const NodeId node : nodes_of(graph_, trace)) {
      if (!graph_.node(node).is_constant()) define(node);
    }
    for (const Term& required : trace.hard_terms) {
      line(fmt::format("{}assert({});", condition(required.guard), name(required.node)),
           fmt::format("{}{}", addresses_.text(required.address),
                       required.requirement == ConstraintKind::kAssert
                           ? (required.message.empty() ? "" : ": " + required.message)
                           : fmt::format(": {}", requirement_text(required.requirement))));
    }
    for (const Term& term : trace.soft_terms)
      line(fmt::format("{}{}({});", condition(term.guard), soft_text(term.strength), name(term.node)),
           addresses_.text(term.address));
    for (const auto& error : trace.program_errors)
      line(fmt::format("{}error;", condition(error.guard)), error.message);
    for (const auto& blocker : trace.blockers) {
      const char* side = blocker.side.kind == BranchSide::Kind::kThen   ? "then side"
                         : blocker.side.kind == BranchSide::Kind::kElse ? "else side"
                                                                        : "cut";
      line(fmt::format("{}---;", condition(blocker.guard)),
           fmt::format("{} not explored: {}", addresses_.text(blocker.side.branch), side));
    }
    for (const auto& placed : trace.placed)
      line(fmt::format("{}place(...);", condition(placed.guard)), addresses_.text(placed.address));
    line(fmt::format("return {};", result([this](NodeId node) { return name(node); })), "");
    return std::move(text_);
  }

 private:
  std::string name(NodeId id) const {
    return graph_.node(id).is_constant() ? constant_text(graph_, id) : fmt::format("x{}", numbers_[id.index]);
  }
  std::string condition(NodeId guard) const {
    return guard == kTrue ? "" : fmt::format("if {}: ", name(guard));
  }

  void line(const std::string& code, const std::string& comment) {
    text_ += comment.empty() ? code + "\n" : fmt::format("{:<36} // {}\n", code, comment);
  }

  void define(NodeId id) {
    const Graph::Node& node = graph_.node(id);
    numbers_[id.index] = next_++;
    std::string comment;
    if (is_choice(node.op)) comment = addresses_.text(graph_.variable(id).address);
    line(fmt::format("x{} <- {};", numbers_[id.index], expression(id)), comment);
  }

  std::string expression(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    if (is_choice(node.op)) return domain_text(graph_.variable(id).domain);
    const Operation& row = operation(node.op);
    if (!row.symbol.empty() && row.arity == 2) {
      return fmt::format("{} {} {}", name(node.operands[0]), row.symbol, name(node.operands[1]));
    }
    if (!row.symbol.empty()) {
      return fmt::format("{}{}{}", row.symbol, row.symbol == "not" ? " " : "", name(node.operands[0]));
    }
    std::string arguments;
    for (const NodeId operand : node.args()) arguments += (arguments.empty() ? "" : ", ") + name(operand);
    return fmt::format("{}({})", row.name, arguments);
  }

  const Graph& graph_;
  const AddressTable& addresses_;
  std::vector<std::size_t> numbers_;
  std::size_t next_ = 0;
  std::string text_;
};

std::string dot_string(const std::string& text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return "\"" + quoted + "\"";
}

}  // namespace

std::string trace_text(const Graph& graph, const AddressTable& addresses, const Trace& trace,
                       const ResultText& result) {
  return TextPrinter(graph, addresses).run(trace, result);
}

std::string trace_dot(const Graph& graph, const AddressTable& addresses, const Trace& trace) {
  std::string text = "digraph trace {\n  rankdir=BT;\n  node [shape=box, fontname=\"sans-serif\"];\n";
  for (const NodeId id : nodes_of(graph, trace)) {
    const Graph::Node& node = graph.node(id);
    std::string label(operation(node.op).name);
    if (node.is_constant()) label = constant_text(graph, id);
    if (is_choice(node.op))
      label = addresses.text(graph.variable(id).address) + "\n" + domain_text(graph.variable(id).domain);
    text += fmt::format("  n{} [label={}{}];\n", id.index, dot_string(label),
                        is_choice(node.op) ? ", style=filled, fillcolor=lightblue" : "");
    const char* const roles[] = {"if", "then", "else"};
    std::size_t i = 0;
    for (const NodeId operand : node.args()) {
      text += fmt::format("  n{} -> n{}", operand.index, id.index);
      if (is_ite(node.op)) text += fmt::format(" [label={}]", roles[i]);
      text += ";\n";
      ++i;
    }
  }
  std::size_t number = 0;
  const auto effect = [&](const std::string& label, NodeId guard, NodeId condition, const char* color) {
    text += fmt::format("  e{} [label={}, shape=ellipse, style=filled, fillcolor={}];\n", number,
                        dot_string(label), color);
    if (condition != kTrue) text += fmt::format("  n{} -> e{};\n", condition.index, number);
    if (guard != kTrue)
      text += fmt::format("  n{} -> e{} [label=guard, style=dashed];\n", guard.index, number);
    ++number;
  };
  for (const Term& required : trace.hard_terms) {
    effect(fmt::format("{}\n{}", requirement_text(required.requirement), addresses.text(required.address)),
           required.guard, required.node, "palegreen");
  }
  for (const Term& term : trace.soft_terms)
    effect(fmt::format("{}\n{}", soft_text(term.strength), addresses.text(term.address)), term.guard,
           term.node, "plum");
  for (const auto& blocker : trace.blockers)
    effect("not explored\n" + addresses.text(blocker.side.branch), blocker.guard, kTrue, "lightgray");
  for (const auto& error : trace.program_errors)
    effect("error: " + error.message, error.guard, kTrue, "salmon");
  for (const auto& placed : trace.placed)
    effect("place\n" + addresses.text(placed.address), placed.guard, kTrue, "wheat");
  return text + "}\n";
}

}  // namespace solitaire
