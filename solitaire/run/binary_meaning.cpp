#include "solitaire/run/binary_meaning.h"

#include <cstddef>
#include <iterator>

namespace solitaire {
namespace {

constexpr bool kSwapped = true;
constexpr bool kNegated = true;

/// In the order of BinaryOp, up to the comparisons.
constexpr BinaryMeaning kMeanings[] = {
    {"+", Op::kAdd, Op::kAddFloat},
    {"-", Op::kSub, Op::kSubFloat},
    {"*", Op::kMul, Op::kMulFloat},
    {"/", Op::kDiv, Op::kDivFloat},
    {"%", Op::kMod, std::nullopt},
    {"==", Op::kEqInt, Op::kEqFloat},
    {"!=", Op::kEqInt, Op::kEqFloat, !kSwapped, kNegated},
    {"<", Op::kLtInt, Op::kLtFloat},
    {"<=", Op::kLeInt, Op::kLeFloat},
    {">", Op::kLtInt, Op::kLtFloat, kSwapped},
    {">=", Op::kLeInt, Op::kLeFloat, kSwapped},
};
static_assert(std::size(kMeanings) == static_cast<std::size_t>(BinaryOp::kGreaterEqual) + 1);

}  // namespace

const BinaryMeaning& meaning_of(BinaryOp op) { return kMeanings[static_cast<std::size_t>(op)]; }

}  // namespace solitaire
