#include "scene/picture/png.h"

#include <fmt/format.h>
#include <png.h>

#include "scene/error.h"

namespace solitaire {
namespace {

png_image description_of(const Image& image) {
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.width);
  description.height = static_cast<png_uint_32>(image.height);
  description.format = PNG_FORMAT_RGB;
  return description;
}

}  // namespace

std::string png_bytes(const Image& image) {
  png_image description = description_of(image);
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(description), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&description, bytes.data(), &size, 0, image.bytes.data(), 0, nullptr) == 0)
    throw SceneError(fmt::format("libpng could not write a picture: {}", description.message));
  bytes.resize(size);
  return bytes;
}

Image read_png(const std::filesystem::path& file) {
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  const auto fail = [&] {
    png_image_free(&description);
    throw SceneError(fmt::format("cannot read {}: {}", file.string(), description.message));
  };
  if (png_image_begin_read_from_file(&description, file.c_str()) == 0) fail();
  description.format = PNG_FORMAT_RGB;
  Image image(description.width, description.height);
  if (png_image_finish_read(&description, nullptr, image.bytes.data(), 0, nullptr) == 0) fail();
  return image;
}

}  // namespace solitaire
