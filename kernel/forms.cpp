#include "kernel/forms.h"

#include <optional>

namespace solitaire {
namespace {

using Family = Distribution::Family;

/// A set of functions of c.
using Basis = std::uint8_t;
constexpr Basis kC = 1;
constexpr Basis kSquare = 2;
constexpr Basis kLogC = 4;
constexpr Basis kLogRest = 8;  // log(1 - c)

/// What is known of a float as a function of c. Each part may be unknown by itself; "constant" stands for
/// whatever does not depend on c.
struct Shape {
  /// It is a constant plus a combination of these.
  std::optional<Basis> sum = std::nullopt;
  /// It is a constant times c^(power/2) (1 - c)^(rest/2).
  struct Powers {
    int power = 0;
    int rest = 0;
    friend bool operator==(const Powers&, const Powers&) = default;
  };
  std::optional<Powers> product = std::nullopt;
  /// Its logarithm is a constant plus a combination of these.
  std::optional<Basis> log = std::nullopt;
};

Shape constant() { return {Basis{0}, Shape::Powers{}, Basis{0}}; }

/// Adds what follows of a sum from it being a product, and of a logarithm.
Shape of_powers(Shape::Powers powers) {
  Shape shape;
  shape.product = powers;
  shape.log = static_cast<Basis>((powers.power != 0 ? kLogC : 0) | (powers.rest != 0 ? kLogRest : 0));
  if (powers == Shape::Powers{0, 0}) shape.sum = Basis{0};
  if (powers == Shape::Powers{2, 0} || powers == Shape::Powers{0, 2}) shape.sum = kC;
  if (powers == Shape::Powers{4, 0}) shape.sum = kSquare;
  return shape;
}

bool is_constant(const Shape& shape) { return shape.sum == Basis{0}; }

std::optional<Basis> joined(std::optional<Basis> a, std::optional<Basis> b) {
  if (!a || !b) return std::nullopt;
  return static_cast<Basis>(*a | *b);
}

Shape add(const Shape& a, const Shape& b) { return {joined(a.sum, b.sum), std::nullopt, std::nullopt}; }

Shape multiply(const Shape& a, const Shape& b) {
  Shape made;
  if (a.product && b.product)
    made = of_powers({a.product->power + b.product->power, a.product->rest + b.product->rest});
  if (!made.log) made.log = joined(a.log, b.log);
  if (is_constant(a)) made.sum = b.sum;
  if (is_constant(b)) made.sum = a.sum;
  if (!made.sum && a.sum == kC && b.sum == kC) made.sum = kC | kSquare;
  return made;
}

Shape divide(const Shape& a, const Shape& b) {
  Shape inverse;
  if (b.product) inverse = of_powers({-b.product->power, -b.product->rest});
  inverse.log = b.log;
  if (is_constant(b)) inverse.sum = Basis{0};
  return multiply(a, inverse);
}

Shape square_root(const Shape& a) {
  Shape made;
  if (a.product && a.product->power % 2 == 0 && a.product->rest % 2 == 0)
    made = of_powers({a.product->power / 2, a.product->rest / 2});
  made.log = a.log;
  return made;
}

/// A selection by a condition that does not depend on c.
Shape select(const Shape& a, const Shape& b) {
  Shape made{joined(a.sum, b.sum), std::nullopt, joined(a.log, b.log)};
  if (a.product == b.product) made.product = a.product;
  return made;
}

/// Follows the shapes of floats through a slice.
class Shapes {
 public:
  Shapes(const ScoreProgram& program, const Slice& slice)
      : program_(program), first_(static_cast<Cell>(program.cells.size())) {
    shapes_.push_back(of_powers({2, 0}));
    for (const Instruction& step : slice.code) shapes_.push_back(made_by(step));
  }

  Shape of(Cell cell) const { return cell < first_ ? constant() : shapes_[cell - first_]; }

 private:
  bool depends(Cell cell) const { return cell >= first_; }
  /// Of cells that are no constants the program has no value yet: 0.
  bool is_one(Cell cell) const {
    return !depends(cell) && program_.types[cell] == Type::kFloat && program_.cells[cell].f == 1;
  }

  Shape made_by(const Instruction& step) const {
    const auto& [a, b, c] = step.operands;
    switch (step.op) {
      case Op::kAddFloat:
        return add(of(a), of(b));
      case Op::kSubFloat:
        if (of(b).product == Shape::Powers{2, 0} && b == first_ && is_one(a)) return of_powers({0, 2});
        return add(of(a), of(b));
      case Op::kNegFloat:
        return {of(a).sum, of(a).product, std::nullopt};
      case Op::kMulFloat:
        return multiply(of(a), of(b));
      case Op::kDivFloat:
        return divide(of(a), of(b));
      case Op::kSqrt:
        return square_root(of(a));
      case Op::kLog:
        return {of(a).log, std::nullopt, std::nullopt};
      case Op::kIteFloat:
        return depends(a) ? Shape{} : select(of(b), of(c));
      default:
        return {};
    }
  }

  const ScoreProgram& program_;
  Cell first_;
  std::vector<Shape> shapes_;
};

std::optional<Basis> basis_of_terms(const ScoreProgram& program, const Slice& slice) {
  const Shapes shapes(program, slice);
  std::optional<Basis> all = Basis{0};
  for (const Slice::Changed& term : slice.terms) all = joined(all, shapes.of(term.proposed).sum);
  return all;
}

bool within(Basis basis, Basis allowed) { return (basis & ~allowed) == 0; }

bool is_unit_interval(const ScoreProgram::Choice& choice) {
  const Distribution& distribution = choice.distribution;
  return distribution.family == Family::kBeta ||
         (distribution.family == Family::kUniform && choice.fixed_parameters && distribution.a == 0 &&
          distribution.b == 1);
}

}  // namespace

Form form_of(const ScoreProgram& program, const ScoreProgram::Choice& choice, const Slice& slice) {
  const Distribution& distribution = choice.distribution;
  if (distribution.type() != Type::kFloat || !slice.assumed.empty()) return Form::kUnknown;
  const std::optional<Basis> basis = basis_of_terms(program, slice);
  if (!basis) return Form::kUnknown;
  const bool has_line = distribution.family == Family::kNormal || distribution.family == Family::kNormalSharp;
  if (has_line && within(*basis, kC | kSquare)) return Form::kNormal;
  const bool has_half_line =
      distribution.family == Family::kGamma || distribution.family == Family::kExponential;
  if (has_half_line && within(*basis, kC | kLogC)) return Form::kGamma;
  if (is_unit_interval(choice) && within(*basis, kLogC | kLogRest)) return Form::kBeta;
  return Form::kUnknown;
}

}  // namespace solitaire
