#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <xbyak/xbyak.h>

#include "kernel/called_operations.h"
#include "kernel/places.h"
#include "kernel/registers.h"

namespace solitaire {

using OneFloat = double (*)(double);
using TwoFloats = double (*)(double, double);
using TwoInts = std::int64_t (*)(std::int64_t, std::int64_t);

/// Writes code that has the address of the cells in `cells_`, that of the table in `table_`, and where it
/// calls functions in r12 whether all ints could be made.
class CodeWriter : public Xbyak::CodeGenerator {
 public:
  /// So many bytes are enough.
  static std::size_t most_bytes(std::span<const Instruction> code) { return kMostOfOne * (code.size() + 1); }

  CodeWriter(std::span<const Instruction> code, Cell table_end, Places& last_reads, std::uint8_t* room)
      : CodeGenerator(most_bytes(code), room),
        calls_(std::any_of(code.begin(), code.end(), [](const auto& step) { return is_called(step.op); })),
        cells_(calls_ ? rbx : rdi),
        table_(calls_ ? r13 : rsi),
        table_end_(table_end),
        last_reads_(last_reads) {
    find_last_reads(code);
    if (calls_) begin_with_calls();
    for (const Instruction& step : code) {
      registers_.next_instruction();
      lasts_ = step.lasts;
      write(step);
      free_unless_read_again(step.result);
      for (const Cell operand : step.operands) free_unless_read_again(operand);
      ++place_;
    }
    calls_ ? end_with_calls() : mov(eax, 1);
    ret();
  }

 private:
  static constexpr std::size_t kMostOfOne = 256;  // bytes for an instruction, and more than that
  using Xmm = Xbyak::Xmm;
  using Register = Registers::Register;

  void find_last_reads(std::span<const Instruction> code) {
    last_reads_.clear();
    for (std::size_t i = 0; i < code.size(); ++i)
      for (std::size_t k = 0; k < operation(code[i].op).arity; ++k) last_reads_.set(code[i].operands[k], i);
  }
  /// Calls need the stack on a multiple of 16, which three registers and the way back take.
  void begin_with_calls() {
    push(rbx);
    push(r12);
    push(r13);
    mov(rbx, rdi);
    mov(r12d, 1);
    mov(r13, rsi);
  }
  void end_with_calls() {
    mov(eax, r12d);
    pop(r13);
    pop(r12);
    pop(rbx);
  }

  /// Where a cell stands. Leaves the processor's flags as they are, and all registers but r8.
  Xbyak::Address at(Cell cell) {
    if (cell >= table_end_) return qword[cells_ + sizeof(Scalar) * cell];
    mov(r8d, dword[table_ + sizeof(Cell) * cell]);
    return qword[cells_ + r8 * sizeof(Scalar)];
  }
  bool is_read_again(Cell cell) const {
    const std::size_t* const last = last_reads_.find(cell);
    return last != nullptr && *last > place_;
  }

  // ---- floats; xmm0 and xmm1 hold what is being worked on, and the others are the Registers

  Xmm xmm(const Register& held) const { return Xmm(static_cast<int>(2 + registers_.number(held))); }
  void write_back(Register& held) {
    if (held.only_here) movsd(at(held.cell), xmm(held));
    held.only_here = false;
  }
  Register& make_room() {
    Register& oldest = registers_.oldest();
    if (oldest.cell != kNoCell) write_back(oldest);
    return oldest;
  }
  void free_unless_read_again(Cell cell) {
    if (is_read_again(cell)) return;
    if (Register* held = registers_.find(cell)) *held = {};
  }

  /// Moves a float to a register that nothing else knows of.
  void copy(const Xmm& to, Cell cell) {
    if (const Register* held = registers_.find(cell)) {
      movaps(to, xmm(*held));
    } else {
      movsd(to, at(cell));
    }
  }
  Xmm loaded(Cell cell) {
    if (const Register* held = registers_.find(cell)) return xmm(*held);
    Register& made = make_room();
    registers_.hold(made, cell, false);
    movsd(xmm(made), at(cell));
    return xmm(made);
  }
  using OnFloats = void (CodeGenerator::*)(const Xmm&, const Xbyak::Operand&);
  /// A float that is read again is worth a register.
  void apply(OnFloats instruction, const Xmm& to, Cell operand) {
    if (registers_.find(operand) != nullptr || is_read_again(operand)) {
      (this->*instruction)(to, loaded(operand));
    } else {
      (this->*instruction)(to, at(operand));
    }
  }
  /// The register of a result.
  Register& result_in(Register& made, Cell result) {
    registers_.hold(made, result, true);
    return made;
  }
  void finish(Register& made) {
    if (lasts_) write_back(made);
  }
  void keep(const Xmm& value, Cell result) {
    Register& made = result_in(make_room(), result);
    movaps(xmm(made), value);
    finish(made);
  }
  bool dies_in_register(Cell cell) { return !is_read_again(cell) && registers_.find(cell) != nullptr; }

  /// An operand that is not read again gives its register to the result.
  void binary(OnFloats instruction, Cell result, Cell a, Cell b) {
    registers_.find(b);  // so that it stays
    if (dies_in_register(a)) {
      Register& made = *registers_.find(a);
      const Xmm to = xmm(made);
      if (a == b) {
        (this->*instruction)(to, to);
      } else {
        apply(instruction, to, b);
      }
      return finish(result_in(made, result));
    }
    if (is_read_again(a)) loaded(a);
    Register& made = result_in(make_room(), result);
    copy(xmm(made), a);
    apply(instruction, xmm(made), b);
    finish(made);
  }
  void commutative(OnFloats instruction, Cell result, Cell a, Cell b) {
    const bool other_way = dies_in_register(b) && !dies_in_register(a);
    other_way ? binary(instruction, result, b, a) : binary(instruction, result, a, b);
  }
  void negate(Cell result, Cell a) {
    mov(rax, std::bit_cast<std::uint64_t>(-0.0));
    movq(xmm0, rax);
    xorps(xmm0, loaded(a));
    keep(xmm0, result);
  }
  void call_function(std::uint64_t address) {
    for (Register& held : registers_.all())
      if (held.cell != kNoCell && is_read_again(held.cell)) write_back(held);
    mov(rax, address);
    call(rax);
    registers_.forget();
  }
  void call_of_one(OneFloat function, Cell result, Cell a) {
    copy(xmm0, a);
    call_function(std::bit_cast<std::uint64_t>(function));
    keep(xmm0, result);
  }
  void call_of_two(TwoFloats function, Cell result, Cell a, Cell b) {
    copy(xmm0, a);
    copy(xmm1, b);
    call_function(std::bit_cast<std::uint64_t>(function));
    keep(xmm0, result);
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
    apply(&CodeGenerator::ucomisd, loaded(a), b);
    keep_flag(set, result);
  }
  void equal_floats(Cell result, Cell a, Cell b) {
    apply(&CodeGenerator::ucomisd, loaded(a), b);
    mov(ecx, 0);
    setnp(cl);
    mov(eax, 0);
    cmovne(ecx, eax);
    mov(at(result), rcx);
  }
  void to_float(Cell result, Cell a) {
    mov(rax, at(a));
    xorps(xmm0, xmm0);
    cvtsi2sd(xmm0, rax);
    keep(xmm0, result);
  }
  void select_float(Cell result, Cell condition, Cell a, Cell b) {
    for (const Cell operand : {a, b})
      if (Register* held = registers_.find(operand)) write_back(*held);
    select(condition, a, b);
    Register& made = result_in(make_room(), result);
    movq(xmm(made), rax);
    finish(made);
  }

  // ---- ints and bools, which stand in their cells alone

  using OnInts = void (CodeGenerator::*)(const Xbyak::Operand&, const Xbyak::Operand&);
  void combine(OnInts instruction, Cell result, Cell a, Cell b) {
    mov(rax, at(a));
    (this->*instruction)(rax, at(b));
    mov(at(result), rax);
  }
  void multiply(Cell result, Cell a, Cell b) {
    mov(rax, at(a));
    imul(rax, at(b));
    mov(at(result), rax);
  }
  void compare_ints(OnFlags set, Cell result, Cell a, Cell b) {
    mov(rax, at(a));
    cmp(rax, at(b));
    keep_flag(set, result);
  }
  using Move = void (CodeGenerator::*)(const Xbyak::Reg&, const Xbyak::Operand&);
  void select_less(Move move, Cell result, Cell a, Cell b) {
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
  void look_up(Cell result, Cell a, Cell b, Cell table) {
    mov(rdi, at(a));
    mov(rsi, at(b));
    mov(rdx, at(table));
    std::int64_t (*const function)(std::int64_t, std::int64_t, const PairTable*) = looked_up;
    call_function(std::bit_cast<std::uint64_t>(function));
    mov(at(result), rax);
  }
  /// Leaves what is selected in rax.
  void select(Cell condition, Cell a, Cell b) {
    mov(rax, at(a));
    cmp(at(condition), 0);
    cmove(rax, at(b));
  }
  void select_int(Cell result, Cell condition, Cell a, Cell b) {
    select(condition, a, b);
    mov(at(result), rax);
  }
  void floor(Cell result, Cell a) {
    bool (*const function)(double, Scalar*) = floor_into;
    copy(xmm0, a);
    lea(rdi, at(result));
    call_function(std::bit_cast<std::uint64_t>(function));
    movzx(eax, al);
    and_(r12d, eax);
  }

  // How an operation is written, of a result r and the operands a, b and c: a line for each.
  // clang-format off
#define SOLITAIRE_WRITES(operation, writing) case Op::operation: return writing;

  void write(const Instruction& step) {
    const Cell r = step.result;
    const auto [a, b, c] = step.operands;
    switch (step.op) {
      SOLITAIRE_WRITES(kNot, invert(r, a))
      SOLITAIRE_WRITES(kAnd, combine(&CodeGenerator::and_, r, a, b))
      SOLITAIRE_WRITES(kOr, combine(&CodeGenerator::or_, r, a, b))
      SOLITAIRE_WRITES(kEqBool, compare_ints(&CodeGenerator::sete, r, a, b))
      SOLITAIRE_WRITES(kEqInt, compare_ints(&CodeGenerator::sete, r, a, b))
      SOLITAIRE_WRITES(kLtInt, compare_ints(&CodeGenerator::setl, r, a, b))
      SOLITAIRE_WRITES(kLeInt, compare_ints(&CodeGenerator::setle, r, a, b))
      SOLITAIRE_WRITES(kAllowed, look_up(r, a, b, c))
      SOLITAIRE_WRITES(kEqFloat, equal_floats(r, a, b))
      // The other way round, for the flags of "above" do not hold with NaN.
      SOLITAIRE_WRITES(kLtFloat, compare_floats(&CodeGenerator::seta, r, b, a))
      SOLITAIRE_WRITES(kLeFloat, compare_floats(&CodeGenerator::setae, r, b, a))
      SOLITAIRE_WRITES(kIteBool, select_int(r, a, b, c))
      SOLITAIRE_WRITES(kIteInt, select_int(r, a, b, c))
      SOLITAIRE_WRITES(kIteFloat, select_float(r, a, b, c))
      SOLITAIRE_WRITES(kAdd, combine(&CodeGenerator::add, r, a, b))
      SOLITAIRE_WRITES(kSub, combine(&CodeGenerator::sub, r, a, b))
      SOLITAIRE_WRITES(kMul, multiply(r, a, b))
      SOLITAIRE_WRITES(kDiv, call_of_ints(quotient_of, r, a, b))
      SOLITAIRE_WRITES(kMod, call_of_ints(rest_of, r, a, b))
      SOLITAIRE_WRITES(kNeg, negate_int(r, a))
      SOLITAIRE_WRITES(kMin, select_less(&CodeGenerator::cmovl, r, a, b))
      SOLITAIRE_WRITES(kMax, select_less(&CodeGenerator::cmovg, r, a, b))
      SOLITAIRE_WRITES(kAbs, absolute(r, a))
      SOLITAIRE_WRITES(kToFloat, to_float(r, a))
      SOLITAIRE_WRITES(kFloor, floor(r, a))
      SOLITAIRE_WRITES(kAddFloat, commutative(&CodeGenerator::addsd, r, a, b))
      SOLITAIRE_WRITES(kSubFloat, binary(&CodeGenerator::subsd, r, a, b))
      SOLITAIRE_WRITES(kMulFloat, commutative(&CodeGenerator::mulsd, r, a, b))
      SOLITAIRE_WRITES(kDivFloat, binary(&CodeGenerator::divsd, r, a, b))
      // Of equal numbers and of NaN these instructions give the second, as the machine gives the first.
      SOLITAIRE_WRITES(kMinFloat, binary(&CodeGenerator::minsd, r, b, a))
      SOLITAIRE_WRITES(kMaxFloat, binary(&CodeGenerator::maxsd, r, b, a))
      SOLITAIRE_WRITES(kNegFloat, negate(r, a))
      SOLITAIRE_WRITES(kSqrt, binary(&CodeGenerator::sqrtsd, r, a, a))
      SOLITAIRE_WRITES(kExp, call_of_one(std::exp, r, a))
      SOLITAIRE_WRITES(kLog, call_of_one(std::log, r, a))
      SOLITAIRE_WRITES(kPow, call_of_two(std::pow, r, a, b))
      SOLITAIRE_WRITES(kLgamma, call_of_one(log_gamma, r, a))
      SOLITAIRE_WRITES(kSin, call_of_one(std::sin, r, a))
      SOLITAIRE_WRITES(kCos, call_of_one(std::cos, r, a))
      SOLITAIRE_WRITES(kAtan2, call_of_two(std::atan2, r, a, b))
      case Op::kConstBool: case Op::kConstInt: case Op::kConstFloat: case Op::kConstTable: return;
      case Op::kChoice: case Op::kChoiceFloat: case Op::kCount_: return;
    }
  }
  // clang-format on

#undef SOLITAIRE_WRITES

  bool calls_;
  Xbyak::Reg64 cells_, table_;
  Cell table_end_;  // cells below are places of the table
  Places& last_reads_;
  Registers registers_;
  std::size_t place_ = 0;  // of the present instruction
  bool lasts_ = false;     // whether its result does
};

}  // namespace solitaire
