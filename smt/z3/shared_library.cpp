#include "smt/z3/shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <stdexcept>

namespace solitaire {
namespace {

[[noreturn]] void fail(const std::string& file) {
  const char* reason = dlerror();
  throw std::runtime_error(fmt::format("{} is needed and cannot be loaded: {}", file,
                                       reason == nullptr ? "for no reason given" : reason));
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& file)
    : file_(file), handle_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) fail(file_);
}

void* SharedLibrary::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) fail(file_);
  return found;
}

}  // namespace solitaire
