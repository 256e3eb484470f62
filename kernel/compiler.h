#pragma once
#include <memory>
#include <span>
#include <vector>

#include "kernel/score_program.h"

namespace solitaire {

/// Makes machine code of straight-line code. Of the results that last, it gives the same as run()
/// (machine.h), bit for bit; of NaNs the payload may be another. Other cells of results have anything then.
/// What it made lives as long as the compiler does.
///
/// It is there for x86-64 processors, and where the system lets memory be written and then executed.
/// Elsewhere nothing is made, and run() does all of the work.
class Compiler {
 public:
  /// Code and the cells that it works on.
  struct Code {
    using Function = bool (*)(Scalar* cells, const Cell* table);
    Function function = nullptr;
    std::vector<Cell> table = {};

    explicit operator bool() const { return function != nullptr; }
    /// Returns what run() returns.
    bool operator()(Scalar* cells) const { return function(cells, table.data()); }
  };

  Compiler();
  ~Compiler();
  Compiler(Compiler&&) noexcept;
  Compiler& operator=(Compiler&&) noexcept;

  /// Returns nothing where nothing can be made. Short codes that are alike but for which cells below
  /// `shared_end` they work on share a function: processors foresee where a call leads if it often leads
  /// there.
  Code compile(std::span<const Instruction> code, Cell shared_end = 0);
  /// Returns true if this build makes machine code at all.
  static bool available();

 private:
  class Runtime;
  std::unique_ptr<Runtime> runtime_;  // made when it is needed
};

}  // namespace solitaire
