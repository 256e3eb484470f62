#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace solitaire {

/// What a program can ask about a model that it places.
struct ModelFacts {
  std::array<double, 3> size{};  // width, depth, height in metres, seen from its front; in tenths of a mm
  bool has_front = false;
};

/// Knows the models that a program can place. Several threads may ask it at a time.
class Models {
 public:
  virtual ~Models() = default;

  /// Returns nothing if there is no model of this name. Throws a std::exception for a file that cannot be
  /// used.
  virtual std::optional<ModelFacts> find(const std::string& name) const = 0;
  /// Returns the names of all that have one.
  virtual std::vector<std::string> names() const = 0;
  /// Returns the names of the materials that a placed thing can be made of.
  virtual const std::vector<std::string>& materials() const = 0;
};

}  // namespace solitaire
