#pragma once
#include <memory>
#include <span>

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
  /// Returns what run() returns.
  using Code = bool (*)(Scalar* cells);

  Compiler();
  ~Compiler();
  Compiler(Compiler&&) noexcept;
  Compiler& operator=(Compiler&&) noexcept;

  /// Returns nothing where nothing can be made.
  Code compile(std::span<const Instruction> code);
  /// Returns true if this build makes machine code at all.
  static bool available();

 private:
  class Runtime;
  std::unique_ptr<Runtime> runtime_;  // made when it is needed
};

}  // namespace solitaire
