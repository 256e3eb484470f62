#include "kernel/compiler.h"

#if SOLITAIRE_XBYAK && defined(__x86_64__) && !defined(_WIN32)

#include "kernel/code_memory.h"
#include "kernel/code_writer.h"

namespace solitaire {

class Compiler::Runtime {
 public:
  Code compile(std::span<const Instruction> code) {
    if (refused_) return nullptr;
    std::uint8_t* const room = memory_.room(Writer::most_bytes(code));
    refused_ = room == nullptr;
    if (refused_) return nullptr;
    reads_.look_at(code);
    const Writer made(code, reads_, room);
    refused_ = !memory_.take(made.getSize());
    return refused_ ? nullptr : made.getCode<Code>();
  }

 private:
  CodeMemory memory_;
  LastReads reads_;
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
