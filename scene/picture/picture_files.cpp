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

PictureFiles::PictureFiles(std::filesystem::path folder, const PictureSize& size, std::size_t threads,
                           Viewpoint from)
    : folder_(std::move(folder)), size_(size), from_(from), painter_(std::make_unique<Painter>(threads)) {}

PictureFiles::~PictureFiles() = default;

std::string PictureFiles::draw(const Scene& scene, const std::string& name) {
  const std::string file = file_name(name);
  write_file_atomically(folder_ / file, png_bytes(painter_->draw(scene, size_, from_).image));
  pictures_.push_back(folder_ / file);
  return file;
}

std::string PictureFiles::take_up(const Scene& scene, const std::string& name) {
  const std::string file = file_name(name);
  if (!is_picture(folder_ / file, size_)) return draw(scene, name);
  pictures_.push_back(folder_ / file);
  return file;
}

void PictureFiles::close() const {
  if (pictures_.empty()) return;
  write_file_atomically(folder_ / file_name("sheet"), png_bytes(contact_sheet(pictures_)));
}

std::string PictureFiles::file_name(const std::string& name) const {
  return name + (from_ == Viewpoint::kEye ? "-eye.png" : ".png");
}

}  // namespace solitaire
