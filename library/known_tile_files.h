#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "solitaire/names/tile_pairs.h"

namespace solitaire::api {

/// Exemplars and problem files on the disk, each of which is read once.
class KnownTileFiles : public TileFiles {
 public:
  explicit KnownTileFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Throws FileError and tiles::RequestError.
  std::shared_ptr<const TilePairs> find(const std::string& file) const override;

 private:
  std::filesystem::path folder_;  // of the script
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::shared_ptr<const TilePairs>> read_;
};

}  // namespace solitaire::api
