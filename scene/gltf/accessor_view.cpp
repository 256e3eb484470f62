#include "scene/gltf/accessor_view.h"

#include <fmt/format.h>

#include "scene/error.h"

namespace solitaire {
namespace {

std::size_t bytes_per_element(const tinygltf::Accessor& accessor) {
  const int component = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  return component > 0 && components > 0 ? static_cast<std::size_t>(component * components) : 0;
}

const tinygltf::BufferView& view_of(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
  return model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
}

std::size_t stride_of(const tinygltf::BufferView& view, std::size_t element_bytes) {
  return view.byteStride != 0 ? view.byteStride : element_bytes;
}

template <typename T>
T read_as(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

}  // namespace

AccessorView::AccessorView(const tinygltf::Model& model, int accessor) {
  const auto& source = model.accessors[static_cast<std::size_t>(accessor)];
  const auto& view = view_of(model, source);
  data_ =
      model.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset + source.byteOffset;
  count_ = source.count;
  element_bytes_ = bytes_per_element(source);
  stride_ = stride_of(view, element_bytes_);
  component_type_ = source.componentType;
}

float AccessorView::real(std::size_t i, int component) const {
  return read_as<float>(element(i) + static_cast<std::size_t>(component) * sizeof(float));
}

Vec3 AccessorView::point(std::size_t i) const { return {real(i, 0), real(i, 1), real(i, 2)}; }

std::uint32_t AccessorView::index(std::size_t i) const {
  switch (component_type_) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *element(i);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read_as<std::uint16_t>(element(i));
    default:
      return read_as<std::uint32_t>(element(i));
  }
}

void check_accessor(const tinygltf::Model& model, int accessor) {
  const auto fail = [&](std::string_view what) {
    throw SceneError(fmt::format("accessor {} {}", accessor, what));
  };
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size()) fail("does not exist");
  const auto& source = model.accessors[static_cast<std::size_t>(accessor)];
  if (source.sparse.isSparse) fail("is sparse, which is not supported");
  if (source.bufferView < 0 || static_cast<std::size_t>(source.bufferView) >= model.bufferViews.size()) {
    fail("has no buffer view");
  }
  const auto& view = view_of(model, source);
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) fail("has no buffer");
  const std::size_t available = model.buffers[static_cast<std::size_t>(view.buffer)].data.size();
  if (view.byteOffset > available || view.byteLength > available - view.byteOffset)
    fail("reaches out of its buffer");

  const std::size_t element = bytes_per_element(source);
  if (element == 0 || source.count == 0) fail("is empty or of an unknown type");
  const std::size_t stride = stride_of(view, element);
  if (stride < element) fail("has a stride less than its elements");
  if (source.byteOffset > view.byteLength || element > view.byteLength - source.byteOffset ||
      source.count - 1 > (view.byteLength - source.byteOffset - element) / stride) {
    fail("reaches out of its buffer view");
  }
}

}  // namespace solitaire
