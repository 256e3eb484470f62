#pragma once
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/file_error.h"

namespace solitaire::tiles {

/// An object of a JSON file of which every member has to be asked for. Mistakes name the file and the member.
class JsonObject {
 public:
  using Json = nlohmann::json;

  /// `where` is the way to the object, such as "rules[2]"; empty for the file as a whole.
  JsonObject(const std::string& file, const Json& json, std::string where);

  bool has(const char* member);
  /// Returns a member, which must be there.
  const Json& at(const char* member);
  std::string text(const char* member);
  std::string text_or(const char* member, const std::string& otherwise);
  /// Returns a whole number from `least` to `most`.
  std::int64_t number(const char* member, std::int64_t least, std::int64_t most);
  double real(const char* member, double least, double most);
  bool flag(const char* member);
  /// Returns a list of texts; a single text is a list of one.
  std::vector<std::string> texts(const char* member);
  /// Returns a list of 2 or 3 whole numbers from `least` on, with ones for what is not said.
  std::vector<int> numbers(const char* member, int least, std::size_t fewest, std::size_t most);
  /// Returns the objects of a list; none if there is no such member.
  std::vector<JsonObject> objects(const char* member);
  /// Returns a member's way, for messages.
  std::string way(const char* member) const;

  const std::string& file() const { return *file_; }
  /// Returns the file and the way to the object, for messages: "town.tiles.json: 'pins[2]'".
  std::string where() const;

  [[noreturn]] void fail(const char* member, const std::string& reason) const;
  /// Throws FileError if there is a member that nobody asked for.
  void require_no_more() const;

 private:
  const std::string* file_;
  const Json* json_;
  std::string where_;
  std::set<std::string> asked_;
};

/// Parses the text of a JSON file. Throws FileError with line and column.
nlohmann::json parse_json(const std::string& file, const std::string& text);

}  // namespace solitaire::tiles
