#include "kernel/compiler.h"

#if SOLITAIRE_XBYAK && defined(__x86_64__) && !defined(_WIN32)

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>
#include <xbyak/xbyak.h>

#include "kernel/called_operations.h"
#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

using OneFloat = double (*)(double);
using TwoFloats = double (*)(double, double);
using TwoInts = std::int64_t (*)(std::int64_t, std::int64_t);

OneFloat function_of(Op op) {
  switch (op) {
    case Op::kExp:
      return std::exp;
    case Op::kLog:
      return std::log;
    case Op::kLgamma:
      return log_gamma;
    case Op::kSin:
      return std::sin;
    default:
      return std::cos;
  }
}

/// Which floats stand in registers, too: those that were used last. Every result is also written to its cell
/// at once, so a register can be given away at any time.
class Registers {
 public:
  Registers() { forget(); }

  /// A register for another cell: the one that was used the longest ago, and not by the present instruction.
  std::uint32_t take(Cell cell) {
    for (Held& held : held_)
      if (held.cell == cell) held.cell = kNoCell;
    const auto oldest = std::min_element(held_.begin(), held_.end(),
                                         [](const Held& a, const Held& b) { return a.used < b.used; });
    *oldest = {cell, now_};
    return number(oldest);
  }
  std::optional<std::uint32_t> find(Cell cell) {
    const auto at =
        std::find_if(held_.begin(), held_.end(), [&](const Held& held) { return held.cell == cell; });
    if (at == held_.end()) return std::nullopt;
    at->used = now_;
    return number(at);
  }
  void next_instruction() { ++now_; }
  /// Called functions may write to all registers.
  void forget() { held_.fill({}); }

 private:
  struct Held {
    Cell cell = kNoCell;
    std::uint64_t used = 0;
  };
  static constexpr std::uint32_t kFirst = 2;  // those below hold what is being worked on

  std::uint32_t number(const Held* held) const {
    return kFirst + static_cast<std::uint32_t>(held - held_.data());
  }

  std::array<Held, 14> held_;
  std::uint64_t now_ = 1;
};

/// Writes code that has the address of the cells in rbx, and in r12 whether all ints could be made.
class Writer : public Xbyak::CodeGenerator {
 public:
  /// Throws Xbyak::Error where the system does not let memory be executed.
  explicit Writer(std::span<const Instruction> code)
      : CodeGenerator(kMostOfOne * (code.size() + 2), Xbyak::DontSetProtectRWE) {
    push(rbx);
    push(r12);
    sub(rsp, 8);  // calls need the stack on a multiple of 16
    mov(rbx, rdi);
    mov(r12d, 1);
    for (const Instruction& step : code) {
      registers_.next_instruction();
      write(step);
    }
    mov(eax, r12d);
    add(rsp, 8);
    pop(r12);
    pop(rbx);
    ret();
    setProtectModeRE();
  }

 private:
  static constexpr std::size_t kMostOfOne = 80;  // bytes for an instruction, and more than that
  using Xmm = Xbyak::Xmm;

  Xbyak::Address at(Cell cell) { return qword[rbx + sizeof(Scalar) * cell]; }

  // ---- floats

  Xmm loaded(Cell cell) {
    if (const auto number = registers_.find(cell)) return Xmm(*number);
    const Xmm made(registers_.take(cell));
    movsd(made, at(cell));
    return made;
  }
  /// Keeps the float in xmm0 as a result.
  void keep(Cell result) {
    movsd(at(result), xmm0);
    movaps(Xmm(registers_.take(result)), xmm0);
  }
  using OnFloats = void (CodeGenerator::*)(const Xmm&, const Xbyak::Operand&);
  void binary(OnFloats instruction, Cell result, Cell a, Cell b) {
    movaps(xmm0, loaded(a));
    (this->*instruction)(xmm0, loaded(b));
    keep(result);
  }
  void negate(Cell result, Cell a) {
    mov(rax, std::bit_cast<std::uint64_t>(-0.0));
    movq(xmm0, rax);
    xorps(xmm0, loaded(a));
    keep(result);
  }
  void call_function(std::uint64_t address) {
    mov(rax, address);
    call(rax);
    registers_.forget();
  }
  void call_of_one(OneFloat function, Cell result, Cell a) {
    movaps(xmm0, loaded(a));
    call_function(std::bit_cast<std::uint64_t>(function));
    keep(result);
  }
  void call_of_two(TwoFloats function, Cell result, Cell a, Cell b) {
    const Xmm second = loaded(b);
    movaps(xmm0, loaded(a));
    movaps(xmm1, second);
    call_function(std::bit_cast<std::uint64_t>(function));
    keep(result);
  }
  using OnFlags = void (CodeGenerator::*)(const Xbyak::Operand&);
  /// Keeps whether a condition holds, of which `set` says which flags it is.
  void keep_flag(OnFlags set, Cell result) {
    mov(ecx, 0);  // leaves the flags as they are
    (this->*set)(cl);
    mov(at(result), rcx);
  }
  /// A comparison with NaN does not hold.
  void compare_floats(OnFlags set, Cell result, Cell a, Cell b) {
    const Xmm first = loaded(a);
    ucomisd(first, loaded(b));
    keep_flag(set, result);
  }
  void equal_floats(Cell result, Cell a, Cell b) {
    const Xmm first = loaded(a);
    ucomisd(first, loaded(b));
    mov(ecx, 0);
    setnp(cl);
    mov(eax, 0);
    cmovne(ecx, eax);
    mov(at(result), rcx);
  }

  // ---- ints and bools

  /// `instruction` works on rax and that operand.
  template <class Apply>
  void combine(Cell result, Cell a, Cell b, Apply instruction) {
    mov(rax, at(a));
    instruction(at(b));
    mov(at(result), rax);
  }
  void compare_ints(OnFlags set, Cell result, Cell a, Cell b) {
    mov(rax, at(a));
    cmp(rax, at(b));
    keep_flag(set, result);
  }
  using Move = void (CodeGenerator::*)(const Xbyak::Reg&, const Xbyak::Operand&);
  void select_int(Move move, Cell result, Cell a, Cell b) {
    mov(rax, at(a));
    mov(rcx, at(b));
    cmp(rcx, rax);
    (this->*move)(rax, rcx);
    mov(at(result), rax);
  }
  void absolute(Cell result, Cell a) {
    mov(rax, at(a));
    mov(rcx, rax);
    neg(rcx);
    cmovns(rax, rcx);
    mov(at(result), rax);
  }
  void invert(Cell result, Cell a) {
    cmp(at(a), 0);
    keep_flag(&CodeGenerator::sete, result);
  }
  void negate_int(Cell result, Cell a) {
    mov(rax, at(a));
    neg(rax);
    mov(at(result), rax);
  }
  void call_of_ints(TwoInts function, Cell result, Cell a, Cell b) {
    mov(rdi, at(a));
    mov(rsi, at(b));
    call_function(std::bit_cast<std::uint64_t>(function));
    mov(at(result), rax);
  }
  void select(Cell result, Cell condition, Cell a, Cell b) {
    mov(rax, at(a));
    cmp(at(condition), 0);
    cmove(rax, at(b));
    mov(at(result), rax);
  }
  void to_float(Cell result, Cell a) {
    mov(rax, at(a));
    xorps(xmm0, xmm0);
    cvtsi2sd(xmm0, rax);
    keep(result);
  }
  void floor(Cell result, Cell a) {
    bool (*const function)(double, Scalar*) = floor_into;
    movaps(xmm0, loaded(a));
    lea(rdi, at(result));
    call_function(std::bit_cast<std::uint64_t>(function));
    movzx(eax, al);
    and_(r12d, eax);
  }

  void write(const Instruction& step) {
    const Cell r = step.result;
    const auto [a, b, c] = step.operands;
    switch (step.op) {
      case Op::kConstBool:
      case Op::kConstInt:
      case Op::kConstFloat:
      case Op::kChoice:
      case Op::kChoiceFloat:
      case Op::kCount_:
        return;
      case Op::kNot:
        return invert(r, a);
      case Op::kAnd:
        return combine(r, a, b, [&](const Xbyak::Address& x) { and_(rax, x); });
      case Op::kOr:
        return combine(r, a, b, [&](const Xbyak::Address& x) { or_(rax, x); });
      case Op::kAdd:
        return combine(r, a, b, [&](const Xbyak::Address& x) { add(rax, x); });
      case Op::kSub:
        return combine(r, a, b, [&](const Xbyak::Address& x) { sub(rax, x); });
      case Op::kMul:
        return combine(r, a, b, [&](const Xbyak::Address& x) { imul(rax, x); });
      case Op::kEqBool:
      case Op::kEqInt:
        return compare_ints(&CodeGenerator::sete, r, a, b);
      case Op::kLtInt:
        return compare_ints(&CodeGenerator::setl, r, a, b);
      case Op::kLeInt:
        return compare_ints(&CodeGenerator::setle, r, a, b);
      case Op::kIteBool:
      case Op::kIteInt:
      case Op::kIteFloat:
        return select(r, a, b, c);
      case Op::kDiv:
        return call_of_ints(quotient_of, r, a, b);
      case Op::kMod:
        return call_of_ints(rest_of, r, a, b);
      case Op::kNeg:
        return negate_int(r, a);
      case Op::kMin:
        return select_int(&CodeGenerator::cmovl, r, a, b);
      case Op::kMax:
        return select_int(&CodeGenerator::cmovg, r, a, b);
      case Op::kAbs:
        return absolute(r, a);
      case Op::kToFloat:
        return to_float(r, a);
      case Op::kFloor:
        return floor(r, a);
      case Op::kAddFloat:
        return binary(&CodeGenerator::addsd, r, a, b);
      case Op::kSubFloat:
        return binary(&CodeGenerator::subsd, r, a, b);
      case Op::kMulFloat:
        return binary(&CodeGenerator::mulsd, r, a, b);
      case Op::kDivFloat:
        return binary(&CodeGenerator::divsd, r, a, b);
      // Of equal numbers and of NaN these instructions give the second, as the machine gives the first.
      case Op::kMinFloat:
        return binary(&CodeGenerator::minsd, r, b, a);
      case Op::kMaxFloat:
        return binary(&CodeGenerator::maxsd, r, b, a);
      case Op::kNegFloat:
        return negate(r, a);
      case Op::kSqrt:
        return binary(&CodeGenerator::sqrtsd, r, a, a);
      case Op::kExp:
      case Op::kLog:
      case Op::kLgamma:
      case Op::kSin:
      case Op::kCos:
        return call_of_one(function_of(step.op), r, a);
      case Op::kPow:
        return call_of_two(std::pow, r, a, b);
      case Op::kAtan2:
        return call_of_two(std::atan2, r, a, b);
      case Op::kEqFloat:
        return equal_floats(r, a, b);
      // The other way round, for the flags of "above" do not hold with NaN.
      case Op::kLtFloat:
        return compare_floats(&CodeGenerator::seta, r, b, a);
      case Op::kLeFloat:
        return compare_floats(&CodeGenerator::setae, r, b, a);
    }
  }

  Registers registers_;
};

}  // namespace

class Compiler::Runtime {
 public:
  Code compile(std::span<const Instruction> code) {
    if (refused_) return nullptr;
    try {
      made_.push_back(std::make_unique<Writer>(code));
      return made_.back()->getCode<Code>();
    } catch (const Xbyak::Error&) {
      refused_ = true;
      return nullptr;
    }
  }

 private:
  std::vector<std::unique_ptr<Xbyak::CodeGenerator>> made_;
  bool refused_ = false;  // by the system, which will not let it pass another time
};

Compiler::Code Compiler::compile(std::span<const Instruction> code) {
  if (runtime_ == nullptr) runtime_ = std::make_unique<Runtime>();
  return runtime_->compile(code);
}

bool Compiler::available() { return true; }

}  // namespace solitaire

#else

namespace solitaire {

class Compiler::Runtime {};

Compiler::Code Compiler::compile(std::span<const Instruction>) { return nullptr; }
bool Compiler::available() { return false; }

}  // namespace solitaire

#endif

namespace solitaire {

Compiler::Compiler() = default;
Compiler::~Compiler() = default;
Compiler::Compiler(Compiler&&) noexcept = default;
Compiler& Compiler::operator=(Compiler&&) noexcept = default;

}  // namespace solitaire
