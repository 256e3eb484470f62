#include "scene/picture/picture_files.h"

#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/picture/picture.h"
#include "scene/picture/png.h"
#include "scene/picture/sheet.h"

namespace solitaire {
namespace {

bool is_picture(const std::filesystem::path& file, const PictureSize& size) {
  try {
    const Image image = read_png(file);
    return image.width == size.width && image.height == size.height;
  } catch (const SceneError&) {  // it is not there, or broken
    return false;
  }
}

}  // namespace

PictureFiles::PictureFiles(std::filesystem::path folder, const PictureSize& size, std::size_t threads)
    : folder_(std::move(folder)), size_(size), painter_(std::make_unique<Painter>(threads)) {}

PictureFiles::~PictureFiles() = default;

std::string PictureFiles::draw(const Scene& scene, const std::string& name) {
  const std::string file = name + ".png";
  write_file_atomically(folder_ / file, png_bytes(painter_->draw(scene, size_).image));
  pictures_.push_back(folder_ / file);
  return file;
}

std::string PictureFiles::take_up(const Scene& scene, const std::string& name) {
  const std::string file = name + ".png";
  if (!is_picture(folder_ / file, size_)) return draw(scene, name);
  pictures_.push_back(folder_ / file);
  return file;
}

void PictureFiles::close() const {
  if (!pictures_.empty()) write_file_atomically(folder_ / "sheet.png", png_bytes(contact_sheet(pictures_)));
}

}  // namespace solitaire
