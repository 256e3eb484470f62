#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <solitaire/export.h>
#include <solitaire/search.h>
#include <string>
#include <vector>

namespace solitaire::api {

/// Writes a solution's scene as a .glb: whole, or not at all. `title` names its root node. Throws Error
/// (kFile), also where the solution places nothing, or a model that cannot be used.
SOLITAIRE_API void write_glb(const Solution& solution, const Program& program, const std::string& title,
                             const std::filesystem::path& path);

/// The size of a picture in pixels: at least 1 x 1, and at most 16 million in all.
struct PictureSize {
  std::size_t width = 640, height = 480;
};

/// Reads a size such as "640x480". Returns nothing for a text that is no size of a picture.
SOLITAIRE_API std::optional<PictureSize> parse_picture_size(const std::string& text);

/// From where pictures show scenes.
enum class Viewpoint {
  kAbove,  // from the front, the right and above, with the walls cut low that hide something
  kEye,    // as somebody sees it who stands in the scene; the files are called NAME-eye.png
};

/// What pictures are drawn.
struct Pictures {
  PictureSize size;
  Viewpoint from = Viewpoint::kAbove;
};

/// A folder with the files of a run, as docs/formats.md describes them: for each solution a scene and a .json
/// file; a page that shows all, and what there is to say about the run as a whole. Use it from one thread at
/// a time. All of it throws Error (kFile).
class SOLITAIRE_API OutputFolder {
 public:
  /// Makes the folder if need be. With `timings`, files say how long things took, and then differ from run to
  /// run. With `pictures`, each scene is drawn, on as many threads as the search has jobs.
  /// With `instancing`, things that look alike share a node of the .glb.
  OutputFolder(const std::filesystem::path& folder, const Program& program, const SearchOptions& options,
               bool timings = false, const std::optional<Pictures>& pictures = std::nullopt,
               bool instancing = false);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Goes on with the run that left its solutions in the folder, without repeating any: the search takes them
  /// up. To be called before anything else. Throws where the folder's run is another one.
  void resume(Search& search);
  /// Writes a solution's files. `summary` is what the search came to with this solution.
  void add(const Solution& solution, const Summary& summary);
  /// Returns what there is to tell of the scenes written so far, a line each: names without a model, and what
  /// models have that is not shown.
  std::vector<std::string> notes() const;
  /// Writes the page and the run's file. Without an ending, an error ended the run. `reason` says why it
  /// stopped, where it did. Returns the page, or nothing where there are no solutions to show.
  std::optional<std::filesystem::path> close(std::optional<Ending> ending,
                                             StopReason reason = StopReason::kNone);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace solitaire::api
