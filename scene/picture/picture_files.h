#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/picture/picture_size.h"
#include "scene/picture/viewpoint.h"
#include "scene/scene.h"

namespace solitaire {

class Painter;

/// Writes the pictures of a run's scenes, and at the end a contact sheet of them all, into a folder. Only one
/// thread at a time may use it. Those at eye height have "-eye" at the end of their names, so that both kinds
/// can lie in one folder.
class PictureFiles {
 public:
  PictureFiles(std::filesystem::path folder, const PictureSize& size, std::size_t threads,
               Viewpoint from = Viewpoint::kAbove);
  ~PictureFiles();

  /// Draws the scene into NAME.png or NAME-eye.png and returns that name. Throws SceneError.
  std::string draw(const Scene& scene, const std::string& name);

  /// Takes up the picture of the scene that an earlier run left, and draws it only if there is none of this
  /// size.
  std::string take_up(const Scene& scene, const std::string& name);

  /// Writes sheet.png or sheet-eye.png if there is a picture. Throws SceneError.
  void close() const;

 private:
  std::string file_name(const std::string& name) const;

  std::filesystem::path folder_;
  PictureSize size_;
  Viewpoint from_;
  std::unique_ptr<Painter> painter_;
  std::vector<std::filesystem::path> pictures_;
};

}  // namespace solitaire
