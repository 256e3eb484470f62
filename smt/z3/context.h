#pragma once
#include <memory>
#include <new>
#include <type_traits>
#include <z3++.h>

namespace solitaire {

/// A Z3 context that reports lack of memory like everything else does: as std::bad_alloc. Z3's C++ interface
/// alone would use a context that could not be made, and throws z3::exception where a call runs out of
/// memory.
class Z3Context {
 public:
  /// Throws std::bad_alloc if the context cannot be made.
  Z3Context() {
    Z3_set_error_handler(scoped_(), [](Z3_context, Z3_error_code error) {
      if (error == Z3_MEMOUT_FAIL) out_of_memory_ = true;
    });
  }

  z3::context& operator*() { return scoped_(); }

  /// Runs an action that calls Z3, and returns its result. Z3 forgets its last error as soon as terms are
  /// freed while an exception passes, so the error handler has to keep it.
  template <class Action>
  static auto run(Action action) {
    out_of_memory_ = false;
    try {
      return action();
    } catch (const z3::exception&) {
      if (out_of_memory_) throw std::bad_alloc();
      throw;
    }
  }

 private:
  struct Delete {
    void operator()(Z3_context context) const { Z3_del_context(context); }
  };
  using Owned = std::unique_ptr<std::remove_pointer_t<Z3_context>, Delete>;

  static Owned make() {
    z3::config config;
    Owned made(Z3_mk_context_rc(config));
    if (made == nullptr) throw std::bad_alloc();
    return made;
  }

  static inline thread_local bool out_of_memory_ = false;
  Owned owned_ = make();
  z3::scoped_context scoped_{owned_.get()};
};

}  // namespace solitaire
