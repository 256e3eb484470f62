#pragma once
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "scene/assets.h"
#include "scene/paint.h"
#include "solitaire/names/models.h"

namespace solitaire::api {

/// The models of folders with assets, as the language asks about them.
class KnownModels : public Models {
 public:
  explicit KnownModels(AssetLibrary assets) : assets_(std::move(assets)) {}

  /// Throws SceneError for a file that cannot be used.
  std::optional<ModelFacts> find(const std::string& name) const override;
  std::vector<std::string> names() const override;
  const std::vector<std::string>& materials() const override { return material_names(); }

 private:
  mutable std::mutex mutex_;
  mutable AssetLibrary assets_;  // which loads files when it is asked
};

}  // namespace solitaire::api
