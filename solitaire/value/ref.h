#pragma once
#include <cstdint>
#include <utility>

namespace solitaire {

class Value;

/// Base of all objects that a Ref or a Value can hold: counts its own references. Values belong to one
/// evaluation and so to one thread, which is why the count is a plain one.
class Counted {
 public:
  Counted() = default;
  Counted(const Counted&) {}  // a copy starts with references of its own
  Counted& operator=(const Counted&) { return *this; }

 protected:
  virtual ~Counted() = default;

 private:
  template <class T>
  friend class Ref;
  friend class Value;
  mutable std::uint32_t references_ = 0;
};

/// A shared pointer to a Counted. Empty or the address of a living object.
template <class T>
class Ref {
 public:
  Ref() = default;
  explicit Ref(T* object) : object_(object) { acquire(); }
  Ref(const Ref& other) : object_(other.object_) { acquire(); }
  Ref(Ref&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Ref& operator=(Ref other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Ref() {
    if (object_ != nullptr && --object_->references_ == 0) delete object_;
  }

  T& operator*() const { return *object_; }
  T* operator->() const { return object_; }
  T* get() const { return object_; }
  /// Returns true if no other Ref or Value has the object.
  bool unique() const { return object_ != nullptr && object_->references_ == 1; }
  /// Gives its reference up to the caller, who has to count it off.
  T* release() { return std::exchange(object_, nullptr); }
  explicit operator bool() const { return object_ != nullptr; }
  friend bool operator==(const Ref&, const Ref&) = default;

 private:
  void acquire() {
    if (object_ != nullptr) ++object_->references_;
  }

  T* object_ = nullptr;
};

template <class T, class... Arguments>
Ref<T> make_ref(Arguments&&... arguments) {
  return Ref<T>(new T{std::forward<Arguments>(arguments)...});
}

}  // namespace solitaire
