#include "library/known_models.h"

namespace solitaire::api {

std::optional<ModelFacts> KnownModels::find(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const Asset* asset = assets_.find(name);
  if (asset == nullptr) return std::nullopt;
  ModelFacts facts{natural_size(*asset), asset->has_front};
  for (double& length : facts.size) length = rounded(length, 4);
  return facts;
}

std::vector<std::string> KnownModels::names() const {
  const std::lock_guard lock(mutex_);
  return assets_.names();
}

}  // namespace solitaire::api
