#pragma once
#include <cstdint>
#include <cstring>
#include <tiny_gltf.h>

#include "scene/geometry.h"

namespace solitaire {

/// Reads the elements of an accessor that lies within its buffer (see check_accessor).
class AccessorView {
 public:
  AccessorView(const tinygltf::Model& model, int accessor);

  std::size_t count() const { return count_; }
  std::size_t element_bytes() const { return element_bytes_; }
  const unsigned char* element(std::size_t i) const { return data_ + i * stride_; }

  float real(std::size_t i, int component) const;  // FLOAT components only
  Vec3 point(std::size_t i) const;                 // FLOAT VEC3 only
  std::uint32_t index(std::size_t i) const;        // unsigned SCALAR only

 private:
  const unsigned char* data_;
  std::size_t count_;
  std::size_t stride_;
  std::size_t element_bytes_;
  int component_type_;
};

/// Throws SceneError unless all elements of the accessor lie within its view and the view within its buffer.
void check_accessor(const tinygltf::Model& model, int accessor);

}  // namespace solitaire
