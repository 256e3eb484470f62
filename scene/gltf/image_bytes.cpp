#include "scene/gltf/image_bytes.h"

#include <algorithm>
#include <string_view>

namespace solitaire {

std::span<const unsigned char> image_bytes(const tinygltf::Model& model, int image) {
  const auto& source = model.images[static_cast<std::size_t>(image)];
  if (source.bufferView == -1) return source.image;
  const auto& view = model.bufferViews[static_cast<std::size_t>(source.bufferView)];
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  return std::span(data).subspan(view.byteOffset, view.byteLength);
}

std::string image_kind(std::span<const unsigned char> bytes) {
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()),
                              std::min<std::size_t>(bytes.size(), 12));
  if (head.starts_with("\x89PNG\r\n\x1a\n")) return "PNG";
  if (head.starts_with("\xff\xd8\xff")) return "JPEG";
  if (head.starts_with("RIFF") && head.ends_with("WEBP")) return "WebP";
  if (head.starts_with("\xABKTX 20")) return "KTX2";
  return "of another kind";
}

}  // namespace solitaire
