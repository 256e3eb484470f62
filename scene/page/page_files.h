#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/page/gallery.h"
#include "scene/scene.h"

namespace solitaire {

/// The files that the page has for a solution, relative to it.
struct SolutionFiles {
  std::string script;   // what is shown when somebody opens it
  std::string drawing;  // an SVG, "" where there are no drawings
};

/// Writes the page of a run: index.html in a folder, and what it needs in the folder page/ below. Scenes are
/// scripts, which alone a page that is opened from a disk may load when somebody asks for them. All of it
/// throws SceneError.
class PageFiles {
 public:
  /// `program` holds the page's scripts and style sheet.
  PageFiles(std::filesystem::path folder, std::filesystem::path program);

  /// Writes a solution's files. `scene` and the bytes of its .glb are nullptr and "" where it places nothing.
  /// `about` is a JSON object with what there is to say beside that; the scene's drawings are added to
  /// "views".
  SolutionFiles add(const std::string& name, const Scene* scene, std::string_view glb,
                    const std::string& about);

  /// Writes the page, which knows the choices of all solutions by the JSON text `choices`. Returns its path.
  std::filesystem::path close(const GalleryInfo& info, const std::vector<GalleryEntry>& entries,
                              std::string_view choices) const;

 private:
  void copy_program();

  std::filesystem::path folder_, program_;
  bool has_program_ = false;
};

}  // namespace solitaire
