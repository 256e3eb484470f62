#include "smt/write_smtlib.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <vector>

#include "smt/operation_rows.h"
#include "smt/unsupported_operation.h"
#include "tracegraph/interval.h"

namespace solitaire {
namespace {

/// Says how an operation is written in SMT-LIB. {0}, {1} and {2} stand for its operands. All ints among them
/// have the same width.
struct Form {
  Op op;
  const char* text;
  unsigned extra_bits = 0;  // needed beyond those that hold the operands and the result
};

/// The SMT-LIB column of the operation table. Leaves are written without it.
constexpr Form kRows[] = {
    {Op::kNot, "(not {0})"},
    {Op::kAnd, "(and {0} {1})"},
    {Op::kOr, "(or {0} {1})"},
    {Op::kEqBool, "(= {0} {1})"},
    {Op::kIteBool, "(ite {0} {1} {2})"},

    {Op::kAdd, "(bvadd {0} {1})"},
    {Op::kSub, "(bvsub {0} {1})"},
    {Op::kMul, "(bvmul {0} {1})"},
    // The remainder has the divisor's sign. The dividend minus the remainder is a multiple of the divisor,
    // which one more bit holds, as it holds the quotient of the least number by -1.
    {Op::kDiv, "(bvsdiv (bvsub {0} (bvsmod {0} {1})) {1})", 1},
    {Op::kMod, "(bvsmod {0} {1})"},
    {Op::kNeg, "(bvneg {0})"},
    {Op::kMin, "(ite (bvsle {0} {1}) {0} {1})"},
    {Op::kMax, "(ite (bvsle {0} {1}) {1} {0})"},
    {Op::kAbs, "(ite (bvsle {0} (bvneg {0})) (bvneg {0}) {0})"},
    {Op::kIteInt, "(ite {0} {1} {2})"},

    {Op::kEqInt, "(= {0} {1})"},
    {Op::kLtInt, "(bvslt {0} {1})"},
    {Op::kLeInt, "(bvsle {0} {1})"},
    {Op::kAllowed, ""},  // see Script::allowed()
};
static_assert(cover_all_operations(kRows), "every operation that bits can express has its SMT-LIB form");
constexpr std::array<Form, kOpCount> kForms = by_operation(kRows);

/// Returns the fewest bits that hold every value of the interval in two's complement.
unsigned signed_width(Interval interval) {
  const auto bits = [](std::int64_t value) {
    return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value))) + 1;
  };
  return std::max(bits(interval.lo), bits(interval.hi));
}

std::string number(std::int64_t value, unsigned width) {
  const std::uint64_t all = width < 64 ? (std::uint64_t{1} << width) - 1 : UINT64_MAX;
  return fmt::format("(_ bv{} {})", static_cast<std::uint64_t>(value) & all, width);
}

std::string resized(std::string term, unsigned from, unsigned to) {
  if (from == to) return term;
  if (from > to) return fmt::format("((_ extract {} 0) {})", to - 1, term);
  return fmt::format("((_ sign_extend {}) {})", to - from, term);
}

/// Returns a name between bars, which may hold every character but bars and backslashes.
std::string quoted(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == '|' || c == '\\'; }, '_');
  return '|' + name + '|';
}

class Script {
 public:
  Script(const Graph& graph, const AddressTable& addresses) : graph_(graph), addresses_(addresses) {}

  /// Operands are older than the nodes that use them, so the order of the graph defines each term before it
  /// is used.
  std::string write(std::span<const NodeId> conditions) {
    text_ = "(set-logic QF_BV)\n";
    const std::vector<bool> needed = nodes_below(conditions);
    for (std::uint32_t i = 0; i < needed.size(); ++i) {
      if (needed[i]) define({i});
    }
    for (const NodeId condition : conditions) append("(assert {})\n", name(condition));
    return text_ + "(check-sat)\n";
  }

 private:
  std::vector<bool> nodes_below(std::span<const NodeId> conditions) const {
    std::vector<bool> needed(graph_.size());
    for (const NodeId condition : conditions) needed[condition.index] = true;
    for (std::size_t i = needed.size(); i-- > 0;) {
      if (!needed[i]) continue;
      require_bits(graph_, {static_cast<std::uint32_t>(i)});
      for (const NodeId operand : graph_.node({static_cast<std::uint32_t>(i)}).args())
        needed[operand.index] = true;
    }
    return needed;
  }

  void define(NodeId id) {
    if (graph_.node(id).is_constant()) return;
    const std::string term = graph_.node(id).op == Op::kChoice ? choice(id) : application(id);
    append("(define-fun {} () {} {})\n", name(id), sort(id), term);
  }

  std::string sort(NodeId id) const { return is_int(id) ? fmt::format("(_ BitVec {})", width(id)) : "Bool"; }

  /// Declares the constant of a choice, which is its value or, where its step is not 1, the number of steps
  /// from its lowest value; returns its value.
  std::string choice(NodeId id) {
    const Interval values = graph_.node(id).interval;
    const std::int64_t step = graph_.variable(id).domain.step;
    const Interval numbers = step == 1 ? values : Interval{0, (values.hi - values.lo) / step};
    const unsigned bits = signed_width(numbers);
    const std::string constant =
        quoted(fmt::format("{}!{}", addresses_.text(graph_.variable(id).address), graph_.node(id).payload));
    append("(declare-const {} (_ BitVec {}))\n", constant, bits);
    append("(assert (and (bvsle {0} {1}) (bvsle {1} {2})))\n", number(numbers.lo, bits), constant,
           number(numbers.hi, bits));
    if (step == 1) return constant;
    const unsigned wide = std::max({bits, width(id), signed_width({step, step})});
    return resized(fmt::format("(bvadd {} (bvmul {} {}))", number(values.lo, wide), number(step, wide),
                               resized(constant, bits, wide)),
                   wide, width(id));
  }

  std::string application(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    if (has_table(node.op))
      return allowed(node.operands[0], node.operands[1], *graph_.scalar(node.operands[2]).table);
    const Form& form = kForms[static_cast<std::size_t>(node.op)];
    unsigned wide = is_int(id) ? width(id) : 0;
    for (const NodeId operand : node.args()) {
      if (is_int(operand)) wide = std::max(wide, width(operand));
    }
    wide += form.extra_bits;
    std::array<std::string, 3> operands;
    for (std::size_t i = 0; i < node.args().size(); ++i) {
      const NodeId operand = node.operands[i];
      operands[i] = is_int(operand) ? resized(name(operand), width(operand), wide) : name(operand);
    }
    const std::string term = fmt::format(fmt::runtime(form.text), operands[0], operands[1], operands[2]);
    return is_int(id) ? resized(term, wide, width(id)) : term;
  }

  /// Returns that a has some value and b one that goes with it.
  std::string allowed(NodeId a, NodeId b, const PairTable& pairs) const {
    std::string any = "(or false";
    for (std::size_t row = 0; row < pairs.rows(); ++row) {
      std::string other = "(or false";
      for (std::size_t column = 0; column < pairs.columns(); ++column) {
        if (pairs.allows(static_cast<std::int64_t>(row), static_cast<std::int64_t>(column)))
          other += is(b, column);
      }
      any += fmt::format(" (and true{} {}))", is(a, row), other);
    }
    return any + ")";
  }

  std::string is(NodeId node, std::size_t value) const {
    const auto constant = static_cast<std::int64_t>(value);
    if (!graph_.node(node).interval.contains(constant)) return " false";
    return fmt::format(" (= {} {})", name(node), number(constant, width(node)));
  }

  std::string name(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    if (node.op == Op::kConstBool) return node.interval.lo != 0 ? "true" : "false";
    if (node.op == Op::kConstInt) return number(node.interval.lo, width(id));
    return fmt::format("n{}", id.index);
  }

  bool is_int(NodeId id) const { return graph_.node(id).type() == Type::kInt; }
  unsigned width(NodeId id) const { return signed_width(graph_.node(id).interval); }

  template <class... Parts>
  void append(fmt::format_string<Parts...> format, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Parts>(parts)...);
  }

  const Graph& graph_;
  const AddressTable& addresses_;
  std::string text_;
};

}  // namespace

std::string to_smt2(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions) {
  return Script(graph, addresses).write(conditions);
}

}  // namespace solitaire
