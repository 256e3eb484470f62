#include "smt/z3/encode.h"

#include <array>
#include <string>
#include <utility>

#include "smt/operation_rows.h"
#include "smt/unsupported_operation.h"
#include "smt/z3/choice_too_wide.h"
#include "tracegraph/post_order.h"

namespace solitaire {

/// The column of the operation table that says how each operation is written for Z3. Choices are encoded
/// elsewhere.
struct Encodings {
  using Encoding = z3::expr (*)(const Encoder&, unsigned width, const NodeId* operands);

  template <class Function>
  static z3::expr on_sized(const Encoder& e, unsigned width, const NodeId* a, Function f) {
    return f(e.sized(a[0], width), e.sized(a[1], width));
  }

  static z3::expr choose(const Encoder& e, unsigned width, NodeId a, NodeId b, bool first) {
    return z3::ite(e.less(a, b, true), e.sized(first ? a : b, width), e.sized(first ? b : a, width));
  }

  using E = const Encoder&;
  using N = const NodeId*;

  struct Row {
    Op op;
    Encoding encoding;
  };

  static constexpr Row kRows[] = {
      {Op::kConstBool, [](E e, unsigned, N a) { return e.context_.bool_val(e.interval(*a).lo != 0); }},
      {Op::kConstInt, [](E e, unsigned w, N a) { return e.context_.bv_val(e.interval(*a).lo, w); }},

      {Op::kNot, [](E e, unsigned, N a) { return !e.term(a[0]); }},
      {Op::kAnd, [](E e, unsigned, N a) { return e.term(a[0]) && e.term(a[1]); }},
      {Op::kOr, [](E e, unsigned, N a) { return e.term(a[0]) || e.term(a[1]); }},
      {Op::kEqBool, [](E e, unsigned, N a) { return e.term(a[0]) == e.term(a[1]); }},
      {Op::kIteBool, [](E e, unsigned, N a) { return z3::ite(e.term(a[0]), e.term(a[1]), e.term(a[2])); }},

      {Op::kAdd,
       [](E e, unsigned w, N a) { return on_sized(e, w, a, [](auto x, auto y) { return x + y; }); }},
      {Op::kSub,
       [](E e, unsigned w, N a) { return on_sized(e, w, a, [](auto x, auto y) { return x - y; }); }},
      {Op::kMul,
       [](E e, unsigned w, N a) { return on_sized(e, w, a, [](auto x, auto y) { return x * y; }); }},
      {Op::kDiv, [](E e, unsigned, N a) { return e.floor_divide(a[0], a[1]); }},
      {Op::kMod, [](E e, unsigned, N a) { return e.floor_modulo(a[0], a[1]); }},
      {Op::kNeg, [](E e, unsigned w, N a) { return -e.sized(a[0], w); }},
      {Op::kMin, [](E e, unsigned w, N a) { return choose(e, w, a[0], a[1], true); }},
      {Op::kMax, [](E e, unsigned w, N a) { return choose(e, w, a[0], a[1], false); }},
      {Op::kAbs,
       [](E e, unsigned w, N a) {
         const z3::expr negative = e.term(a[0]) < e.context_.bv_val(0, e.width(a[0]));
         return z3::ite(negative, -e.sized(a[0], w), e.sized(a[0], w));
       }},
      {Op::kIteInt,
       [](E e, unsigned w, N a) { return z3::ite(e.term(a[0]), e.sized(a[1], w), e.sized(a[2], w)); }},

      {Op::kEqInt,
       [](E e, unsigned, N a) {
         return on_sized(e, e.common_width(a[0], a[1]), a, [](auto x, auto y) { return x == y; });
       }},
      {Op::kLtInt, [](E e, unsigned, N a) { return e.less(a[0], a[1], false); }},
      {Op::kLeInt, [](E e, unsigned, N a) { return e.less(a[0], a[1], true); }},
      {Op::kAllowed, [](E e, unsigned, N a) { return e.allowed(a[0], a[1], *e.graph_.scalar(a[2]).table); }},
  };
};
static_assert(cover_all_operations(Encodings::kRows),
              "every operation that bits can express has its encoding");

namespace {

constexpr std::array<Encodings::Row, kOpCount> kEncodings = by_operation(Encodings::kRows);

}  // namespace

Encoder::Encoder(z3::context& context, const Graph& graph, const AddressTable& addresses,
                 unsigned fixed_width)
    : context_(context), graph_(graph), addresses_(addresses), fixed_width_(fixed_width) {}

bool Encoder::fits(Interval values) const {
  if (fixed_width_ == 0) return true;
  const std::int64_t end = std::int64_t{1} << (fixed_width_ - 1);
  return -end <= values.lo && values.hi < end;
}

z3::expr Encoder::condition(NodeId node) {
  encode(node);
  return term(node);
}

void Encoder::encode(NodeId node) {
  terms_.resize(graph_.size());
  const auto push_needed = [this](NodeId at, std::vector<NodeId>& pending) {
    require_bits(graph_, at);
    for (const NodeId operand : graph_.node(at).args()) {
      const bool is_table = graph_.node(operand).op == Op::kConstTable;
      if (!is_table && !terms_[operand.index]) pending.push_back(operand);
    }
  };
  in_post_order(
      node, [this](NodeId at) { return terms_[at.index].has_value(); }, push_needed,
      [this](NodeId at) { terms_[at.index] = encode_node(at); });
}

z3::expr Encoder::encode_node(NodeId id) {
  const Graph::Node& node = graph_.node(id);
  if (node.op == Op::kChoice) return encode_choice(id);
  const Encodings::Encoding encoding = kEncodings[static_cast<std::size_t>(node.op)].encoding;
  const unsigned result_width = node.type() == Type::kInt ? width(id) : 0;
  if (node.type() == Type::kInt && !fits(node.interval)) exact_ = false;
  const z3::expr made = encoding(*this, result_width, node.is_constant() ? &id : node.operands.data());
  if (node.type() != Type::kInt) return made;
  // Division computes at its operands' width; the interval says how much of it can be in use.
  const unsigned have = made.get_sort().bv_size();
  if (have > result_width) return made.extract(result_width - 1, 0);
  if (have == result_width) return made;
  return is_signed(id) ? z3::sext(made, result_width - have) : z3::zext(made, result_width - have);
}

void Encoder::check_fits(const ChoiceVariable& variable, Interval values) const {
  if (fits(values)) return;
  throw ChoiceTooWide("the values of " + addresses_.text(variable.address) + " go from " +
                      std::to_string(values.lo) + " to " + std::to_string(values.hi) +
                      ", which is more than the " + std::to_string(fixed_width_) +
                      " bits hold that this engine has for every int");
}

/// A choice of step 1 is a vector with bounds; one of a larger step counts its steps from the lower end.
z3::expr Encoder::encode_choice(NodeId id) {
  const std::size_t number = graph_.node(id).payload;
  const ChoiceVariable& variable = graph_.variable(id);
  const Distribution& domain = variable.domain;
  const std::string name = addresses_.text(variable.address);
  choices_.resize(std::max(choices_.size(), number + 1));
  const Interval values = interval(id);
  check_fits(variable, values);
  if (domain.step == 1) {
    const unsigned bits = width(id);
    const z3::expr term = context_.bv_const((name + "!" + std::to_string(number)).c_str(), bits);
    const z3::expr lo = context_.bv_val(values.lo, bits);
    const z3::expr hi = context_.bv_val(values.hi, bits);
    const std::int64_t top = (std::int64_t{1} << (is_signed(id) ? bits - 1 : bits)) - 1;
    const std::int64_t bottom = is_signed(id) ? -top - 1 : 0;
    if (values.lo != bottom) domains_.push_back(is_signed(id) ? lo <= term : z3::ule(lo, term));
    if (values.hi != top) domains_.push_back(is_signed(id) ? term <= hi : z3::ule(term, hi));
    choices_[number] = term;
    return term;
  }
  const std::int64_t last = (values.hi - values.lo) / domain.step;
  const unsigned step_bits = width({0, last});
  const z3::expr steps = context_.bv_const((name + "!" + std::to_string(number)).c_str(), step_bits);
  domains_.push_back(z3::ule(steps, context_.bv_val(last, step_bits)));
  choices_[number] = steps;
  const unsigned bits = width(id);
  const z3::expr wide = step_bits < bits ? z3::zext(steps, bits - step_bits) : steps;
  return wide * context_.bv_val(domain.step, bits) + context_.bv_val(values.lo, bits);
}

std::vector<z3::expr> Encoder::take_domains() { return std::exchange(domains_, {}); }

std::optional<z3::expr> Encoder::choice_term(std::size_t variable) const {
  return variable < choices_.size() ? choices_[variable] : std::nullopt;
}

std::int64_t Encoder::decode(std::size_t variable, std::uint64_t bits) const {
  const Distribution& domain = graph_.variables()[variable].domain;
  if (domain.step != 1) return domain.lo + static_cast<std::int64_t>(bits) * domain.step;
  const unsigned used = width({domain.lo, domain.hi});
  const bool negative = domain.lo < 0 && ((bits >> (used - 1)) & 1U) != 0;
  return static_cast<std::int64_t>(negative && used < 64 ? bits - (std::uint64_t{1} << used) : bits);
}

z3::expr Encoder::sized(NodeId node, unsigned wanted) const {
  const z3::expr& vector = term(node);
  const unsigned have = vector.get_sort().bv_size();
  if (have > wanted) return vector.extract(wanted - 1, 0);
  if (have == wanted) return vector;
  return is_signed(node) ? z3::sext(vector, wanted - have) : z3::zext(vector, wanted - have);
}

unsigned Encoder::common_width(NodeId a, NodeId b) const {
  if (fixed_width_ != 0) return fixed_width_;
  if (!either_signed(a, b)) return std::max(width(a), width(b));
  return std::max(width(a) + (is_signed(a) ? 0 : 1), width(b) + (is_signed(b) ? 0 : 1));
}

z3::expr Encoder::less(NodeId a, NodeId b, bool or_equal) const {
  const unsigned bits = common_width(a, b);
  const z3::expr x = sized(a, bits);
  const z3::expr y = sized(b, bits);
  if (either_signed(a, b)) return or_equal ? x <= y : x < y;
  return or_equal ? z3::ule(x, y) : z3::ult(x, y);
}

/// Uses Z3's truncating division, and corrects the result where the remainder has the wrong sign. One more
/// bit keeps the smallest value divided by -1 from wrapping.
z3::expr Encoder::floor_divide(NodeId a, NodeId b) const {
  const unsigned bits = common_width(a, b) + (either_signed(a, b) && fixed_width_ == 0 ? 1 : 0);
  const z3::expr x = sized(a, bits);
  const z3::expr y = sized(b, bits);
  if (!either_signed(a, b)) return z3::udiv(x, y);
  const z3::expr zero = context_.bv_val(0, bits);
  const z3::expr quotient = x / y;
  const z3::expr remainder = z3::srem(x, y);
  const z3::expr wrong = remainder != zero && ((remainder < zero) != (y < zero));
  return z3::ite(wrong, quotient - context_.bv_val(1, bits), quotient);
}

z3::expr Encoder::is(NodeId node, std::size_t value) const {
  const auto number = static_cast<std::int64_t>(value);
  if (!interval(node).contains(number)) return context_.bool_val(false);
  return term(node) == context_.bv_val(number, width(node));
}

/// Returns that a has some value and b one that goes with it.
z3::expr Encoder::allowed(NodeId a, NodeId b, const PairTable& pairs) const {
  z3::expr any = context_.bool_val(false);
  for (std::size_t row = 0; row < pairs.rows(); ++row) {
    z3::expr other = context_.bool_val(false);
    for (std::size_t column = 0; column < pairs.columns(); ++column) {
      if (pairs.allows(static_cast<std::int64_t>(row), static_cast<std::int64_t>(column)))
        other = other || is(b, column);
    }
    any = any || (is(a, row) && other);
  }
  return any;
}

z3::expr Encoder::floor_modulo(NodeId a, NodeId b) const {
  const unsigned bits = common_width(a, b);
  if (!either_signed(a, b)) return z3::urem(sized(a, bits), sized(b, bits));
  return z3::smod(sized(a, bits), sized(b, bits));
}

}  // namespace solitaire
