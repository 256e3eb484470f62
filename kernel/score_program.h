#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "kernel/forms.h"
#include "tracegraph/graph.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// A place for a value of a ScoreProgram. Operands have smaller numbers than what is made of them.
using Cell = std::uint32_t;
inline constexpr Cell kNoCell = UINT32_MAX;

/// What the code of slopes needs beside a program's own cells (gradient.h). The last five are the
/// coefficients of the series of the digamma function (Abramowitz and Stegun 6.3.18).
inline constexpr std::array<double, 8> kSlopeNumbers = {0,          1,         0.5,        1.0 / 12,
                                                        -1.0 / 120, 1.0 / 252, -1.0 / 240, 1.0 / 132};

/// Computes a cell from others. Operands that the operation does not have are 0.
struct Instruction {
  Instruction(Op operation, Cell made, std::array<Cell, 3> read)
      : result(made), operands(read), op(operation) {}

  Cell result;
  std::array<Cell, 3> operands;
  Op op;
  bool lasts = true;  // whether something reads the result once all of the code has run
};

/// The density of executions as a program without control flow, for the executions that take one path: made
/// of a trace's graph, with all that the density does not depend on left out (section 3.4 of the
/// dissertation).
///
/// The density's logarithm is the sum of `terms` and `constant`, where every cell of `required` is true; else
/// the execution is impossible. All of this holds only where every cell of `assumed` is true: elsewhere the
/// execution takes another path, of which this program knows nothing.
struct ScoreProgram {
  struct Choice {
    Cell cell;  // kNoCell for a choice with one value alone
    AddressId address;
    bool fixed_parameters;            // they depend on no choice
    Form form = Form::kUnknown;       // along the choice; unknown also where a branch depends on it
    Distribution distribution;        // with the parameters that it had when it was traced
    std::vector<Cell> parameters;     // as of log_density() (tracegraph/density.h)
    Scalar only_value;                // of a choice without a cell
    std::vector<Cell> numbers = {};   // of the form
    std::vector<Cell> required = {};  // of those that depend on the choice, those that the form leaves open
  };

  /// Floats that have a normal distribution together, as in NormalBlock.
  struct Block {
    std::vector<std::size_t> choices;
    std::vector<Cell> mixed;

    bool has(std::size_t choice) const { return std::binary_search(choices.begin(), choices.end(), choice); }
  };

  std::vector<Scalar> cells;  // constants have their values, all others wait to be set or computed
  std::vector<Type> types;    // of the cells
  std::vector<Choice> choices;
  Block block;
  std::vector<Instruction> code;  // in the order of results; makes what the density depends on
  std::vector<Cell> terms;        // floats
  std::vector<Cell> required;     // bools
  std::vector<Cell> assumed;      // bools
  double constant = 0;
  std::vector<Cell> slope_numbers;  // have the values of kSlopeNumbers
  /// Makes the numbers of forms, once `code` has run.
  std::vector<Instruction> form_code;
  /// Makes the outputs, after both.
  std::vector<Instruction> output_code;
  std::vector<Cell> outputs;

  bool impossible() const { return constant == -std::numeric_limits<double>::infinity(); }
};

/// Whether the forms of the density along choices are looked for. Where they are left out, they count as
/// unknown.
enum class Forms : std::uint8_t { kFound, kLeftOut };

/// Makes the program of a traced execution. `path` is what its branches followed, and `outputs` are nodes
/// whose values are asked for. Adds nodes for densities to the graph.
ScoreProgram score_program(Graph& graph, const Trace& trace, std::span<const NodeId> path,
                           std::span<const NodeId> outputs, Forms wanted = Forms::kFound);

}  // namespace solitaire
