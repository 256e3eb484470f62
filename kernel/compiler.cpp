#include "kernel/compiler.h"

#if SOLITAIRE_XBYAK && defined(__x86_64__) && !defined(_WIN32)

#include <map>
#include <utility>

#include "kernel/code_memory.h"
#include "kernel/code_order.h"
#include "kernel/code_writer.h"
#include "kernel/shared_code.h"

namespace solitaire {

class Compiler::Runtime {
 public:
  Code compile(std::span<const Instruction> code, Cell shared_end) {
    if (refused_) return {};
    if (code.size() > kLongestShared) shared_end = 0;
    SharedCode made = maker_.shared_of(order_.of(code), shared_end);
    if (shared_end == 0) return {write(made.code, 0)};
    const auto [found, is_new] = shared_.try_emplace(made.key(), nullptr);
    if (is_new) found->second = write(made.code, shared_end);
    return {found->second, std::move(made.table)};
  }

 private:
  using Function = Code::Function;
  /// Longer codes are hardly ever alike, and a table takes time.
  static constexpr std::size_t kLongestShared = 100;

  Function write(std::span<const Instruction> code, Cell table_end) {
    std::uint8_t* const room = memory_.room(CodeWriter::most_bytes(code));
    refused_ = room == nullptr;
    if (refused_) return nullptr;
    const CodeWriter writer(code, table_end, last_reads_, room);
    refused_ = !memory_.take(writer.getSize());
    return refused_ ? nullptr : writer.getCode<Function>();
  }

  CodeMemory memory_;
  CodeOrder order_;
  SharedCodeMaker maker_;
  std::map<std::vector<std::uint32_t>, Function> shared_;  // by their keys
  Places last_reads_;
  bool refused_ = false;  // by the system, which will not let it pass another time
};

Compiler::Code Compiler::compile(std::span<const Instruction> code, Cell shared_end) {
  if (runtime_ == nullptr) runtime_ = std::make_unique<Runtime>();
  return runtime_->compile(code, shared_end);
}

bool Compiler::available() { return true; }

}  // namespace solitaire

#else

namespace solitaire {

class Compiler::Runtime {};

Compiler::Code Compiler::compile(std::span<const Instruction>, Cell) { return {}; }
bool Compiler::available() { return false; }

}  // namespace solitaire

#endif

namespace solitaire {

Compiler::Compiler() = default;
Compiler::~Compiler() = default;
Compiler::Compiler(Compiler&&) noexcept = default;
Compiler& Compiler::operator=(Compiler&&) noexcept = default;

}  // namespace solitaire
