#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engines/tiles/job/job_options.h"

namespace solitaire::tiles {

/// How a job ended.
enum class JobEnding : std::uint8_t {
  kDone,
  kNoMap,   // proved
  kGaveUp,  // the sampler did; this is no proof
  kStopped,
};

/// A cube of a tile's model.
struct ShownVoxel {
  std::array<int, 3> at;  // as in ShownTile, but in voxels from the tile's lowest corner
  std::array<double, 3> color;
};

/// The cubes of a tile; there is at least one.
struct ShownModel {
  int across, layers;  // voxels along the sides of the tile, and up
  std::vector<ShownVoxel> voxels;
};

/// A tile of a map as a scene shows it.
struct ShownTile {
  std::string name;
  std::array<int, 3> at;  // x to the right, y into the depth, z up, in tiles
  std::string asset;      // a model, or nothing: a box
  int turn;               // quarter turns of the model
  double height;          // of the box, in sides of a tile
  std::array<double, 3> color;
  std::shared_ptr<const ShownModel> model;  // of cubes, which tiles of a kind share; or none
};

/// Makes the maps that somebody asks for, or answers questions about them. This is the face of the tile
/// engine for programs: it needs no other header of the engine.
class Job {
 public:
  /// Reads the exemplars and learns their pairs. Throws RequestError for options that contradict each other
  /// or name what is not there, and FileError. Whatever takes long asks `stopped` every few milliseconds
  /// whether it is to end.
  explicit Job(
      const JobOptions& options, std::function<bool()> stopped = [] { return false; });
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Returns what is wrong with a map in a file; nothing if it keeps all rules.
  std::vector<std::string> check(const std::filesystem::path& file) const;
  /// Returns how many maps there are, or nothing if they cannot be counted (count_maps()). Throws
  /// Interrupted.
  std::optional<std::string> count() const;
  /// Returns why there is no map, a rule a line; nothing if there is one. Without a line there is no map of
  /// this size at all. Throws Interrupted.
  std::optional<std::vector<std::string>> explain() const;
  /// Returns what whoever asks should know about how the request was understood.
  std::vector<std::string> notes() const;
  /// Returns what should be known about the exemplars.
  std::vector<std::string> warnings() const;

  /// Learns weights, and returns them as the text of a file that a problem file can name. Throws Interrupted.
  std::string weights();

  /// Learns weights and makes maps, several at a time, and calls `deliver(number)` for each in their order,
  /// numbered from 1. Throws std::logic_error if a map breaks a rule, which is then not delivered.
  JobEnding run(const std::function<void(std::uint64_t)>& deliver);
  /// Returns what a scene shows of the map that is being delivered: all tiles that are not empty.
  std::vector<ShownTile> shown_tiles() const;
  /// Returns the file of the map that is being delivered, as txt, png, json, vox, tmx or tmj
  /// (require_format()). `pixels` is the side of a tile without an icon; `folder` is where the file will be.
  /// Throws RequestError.
  std::string file(const std::string& format, int pixels, const std::filesystem::path& folder) const;
  /// Throws RequestError for a format in which no map of this job can be written, whatever it looks like.
  void require_format(const std::string& format) const;
  /// Returns what there is to say of all maps together.
  std::string summary() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace solitaire::tiles
