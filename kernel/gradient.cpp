#include "kernel/gradient.h"

namespace solitaire {
namespace {

/// Writes the code, from the last result to the first.
class Adjoints {
 public:
  Adjoints(const ScoreProgram& program, std::size_t floats, Slice& slice)
      : numbers_(program.slope_numbers),
        slice_(slice),
        first_(static_cast<Cell>(program.cells.size())),
        first_result_(static_cast<Cell>(first_ + floats)),
        sums_(slice.changes.size()) {}

  void write() {
    for (const Slice::Changed& term : slice_.terms) count(term.proposed, {one_, false});
    for (std::size_t i = slice_.changes.size(); i-- > first_result_ - first_;) {
      const Instruction step = slice_.code[first_ + i - first_result_];
      result_ = sum(step.result);
      if (result_.cell != kNoCell) hand_down(step);
    }
  }
  Cell of(Cell cell) const { return sum(cell).cell == kNoCell ? zero_ : sum(cell).cell; }

 private:
  /// By how much the difference grows with a cell.
  struct Sum {
    Cell cell = kNoCell;
    /// Where nothing selects the cell this is 0, and what is made of it has to be 0, too, however large or
    /// undefined the other factors are.
    bool guarded = false;
  };

  bool depends(Cell cell) const { return cell >= first_; }
  const Sum& sum(Cell cell) const { return sums_[cell - first_]; }

  Cell emit(Op op, Cell a, Cell b = 0, Cell c = 0) {
    const auto result = static_cast<Cell>(first_result_ + slice_.code.size());
    slice_.code.push_back({op, result, {a, b, c}});
    return result;
  }
  Cell product(Cell a, Cell b) {
    if (a == one_) return b;
    return b == one_ ? a : emit(Op::kMulFloat, a, b);
  }
  Cell negated(Cell a) { return emit(Op::kNegFloat, a); }

  void count(Cell cell, Sum more) {
    Sum& all = sums_[cell - first_];
    all.cell = all.cell == kNoCell ? more.cell : emit(Op::kAddFloat, all.cell, more.cell);
    all.guarded = all.guarded || more.guarded;
  }
  /// Counts a multiple of the result's sum, which `make` writes; for operands that depend on the floats.
  template <class Make>
  void give(Cell operand, Make make) {
    if (!depends(operand)) return;
    Cell made = make();
    if (result_.guarded) made = emit(Op::kIteFloat, emit(Op::kEqFloat, result_.cell, zero_), zero_, made);
    count(operand, {made, result_.guarded});
  }
  /// Of operands that a condition selects.
  void give_selected(Cell condition, Cell a, Cell b) {
    if (depends(a)) count(a, {emit(Op::kIteFloat, condition, result_.cell, zero_), true});
    if (depends(b)) count(b, {emit(Op::kIteFloat, condition, zero_, result_.cell), true});
  }

  void hand_down(const Instruction& step) {
    const Cell d = result_.cell, r = step.result;
    const auto [a, b, c] = step.operands;
    switch (step.op) {
      case Op::kAddFloat:
        if (depends(a)) count(a, result_);
        if (depends(b)) count(b, result_);
        return;
      case Op::kSubFloat:
        if (depends(a)) count(a, result_);
        if (depends(b)) count(b, {negated(d), result_.guarded});
        return;
      case Op::kNegFloat:
        return count(a, {negated(d), result_.guarded});
      case Op::kMulFloat:
        give(a, [&, b = b] { return product(d, b); });
        return give(b, [&, a = a] { return product(d, a); });
      case Op::kDivFloat:
        give(a, [&, b = b] { return emit(Op::kDivFloat, d, b); });
        return give(b, [&, b = b] { return negated(product(emit(Op::kDivFloat, d, b), r)); });
      case Op::kMinFloat:
        return give_selected(emit(Op::kLtFloat, b, a), b, a);
      case Op::kMaxFloat:
        return give_selected(emit(Op::kLtFloat, a, b), b, a);
      case Op::kIteFloat:
        return give_selected(a, b, c);
      case Op::kPow:
        give(a, [&, a = a, b = b] { return product(d, slope_of_power(a, b)); });
        return give(b, [&, a = a] { return product(d, slope_of_exponent(a, r)); });
      case Op::kAtan2:
        give(a, [&, a = a, b = b] { return emit(Op::kDivFloat, product(d, b), square_sum(a, b)); });
        return give(
            b, [&, a = a, b = b] { return negated(emit(Op::kDivFloat, product(d, a), square_sum(a, b))); });
      case Op::kToFloat:
        return;  // what ints are made of is flat
      default:
        return give(a, [&] { return of_function(step); });
    }
  }

  /// What the operand of a function of one float counts.
  Cell of_function(const Instruction& step) {
    const Cell d = result_.cell, r = step.result, a = step.operands[0];
    switch (step.op) {
      case Op::kSqrt:
        return emit(Op::kDivFloat, d, emit(Op::kAddFloat, r, r));
      case Op::kExp:
        return product(d, r);
      case Op::kLog:
        return emit(Op::kDivFloat, d, a);
      case Op::kLgamma:
        return product(d, digamma(a));
      case Op::kSin:
        return product(d, emit(Op::kCos, a));
      case Op::kCos:
        return negated(product(d, emit(Op::kSin, a)));
      default:
        return kNoCell;  // which no operation comes to
    }
  }
  Cell slope_of_power(Cell base, Cell exponent) {
    return product(exponent, emit(Op::kPow, base, emit(Op::kSubFloat, exponent, one_)));
  }
  /// Where the base is 0 or negative, the power is only defined for some exponents, and counts as flat.
  Cell slope_of_exponent(Cell base, Cell power) {
    const Cell slope = product(power, emit(Op::kLog, base));
    return emit(Op::kIteFloat, emit(Op::kLtFloat, zero_, base), slope, zero_);
  }
  /// The derivative of lgamma, for operands above -4 to full precision: by the recurrence up to 10 more, and
  /// from there by the asymptotic series.
  Cell digamma(Cell a) {
    Cell below = zero_, x = a;
    for (int i = 0; i < 10; ++i) {
      below = emit(Op::kAddFloat, below, emit(Op::kDivFloat, one_, x));
      x = emit(Op::kAddFloat, x, one_);
    }
    const Cell t = emit(Op::kDivFloat, one_, emit(Op::kMulFloat, x, x));
    Cell series = numbers_.back();
    for (std::size_t i = numbers_.size() - 1; i-- > 3;)
      series = emit(Op::kAddFloat, numbers_[i], emit(Op::kMulFloat, t, series));
    const Cell rest =
        emit(Op::kAddFloat, emit(Op::kDivFloat, numbers_[2], x), emit(Op::kMulFloat, t, series));
    return emit(Op::kSubFloat, emit(Op::kSubFloat, emit(Op::kLog, x), rest), below);
  }
  Cell square_sum(Cell a, Cell b) {
    return emit(Op::kAddFloat, emit(Op::kMulFloat, a, a), emit(Op::kMulFloat, b, b));
  }

  const std::vector<Cell>& numbers_;
  Cell zero_ = numbers_[0], one_ = numbers_[1];
  Slice& slice_;
  Cell first_;
  Cell first_result_;
  std::vector<Sum> sums_;  // of the slice's changes
  Sum result_;             // of the step that is looked at
};

}  // namespace

std::vector<Cell> add_gradient(const ScoreProgram& program, std::size_t floats, Slice& slice) {
  Adjoints adjoints(program, floats, slice);
  adjoints.write();
  std::vector<Cell> slopes;
  for (std::size_t i = 0; i < floats; ++i) slopes.push_back(adjoints.of(slice.changes[i].proposed));
  return slopes;
}

}  // namespace solitaire
