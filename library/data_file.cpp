#include "library/data_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <solitaire/error.h>
#include <string_view>
#include <utility>
#include <vector>

#include "base/source.h"
#include "library/json.h"
#include "solitaire/value/plain_value.h"

namespace solitaire::api {
namespace {

[[noreturn]] void refuse_data(const std::filesystem::path& path, const std::string& reason) {
  throw Error(Error::Kind::kFile, fmt::format("{}: {}", path.string(), reason));
}

std::string text_of_data(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) refuse_data(path, "is a folder, not a file of data");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_data(path, "cannot be read");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (const std::size_t at = find_broken_utf8(text); at < text.size()) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    refuse_data(path, fmt::format("is not UTF-8: line {} has the byte \\x{:02x}; save it as UTF-8", line,
                                  static_cast<unsigned char>(text[at])));
  }
  // Spreadsheets mark their tables so, which is no part of the first cell.
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

std::string list_constant(const std::vector<std::string>& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) text += (i == 0 ? "" : ", ") + items[i];
  return text + "]";
}

/// A text as the language writes it, which knows fewer escapes than JSON.
std::string text_constant(const std::string& text) {
  std::string constant = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') constant += '\\';
    if (c == '\n') {
      constant += "\\n";
    } else {
      constant += c;
    }
  }
  return constant + "\"";
}

/// Lists within each other; the language reads a few more.
constexpr int kDeepestLists = 200;

std::string json_constant(const Json& json, const std::filesystem::path& path, int depth = 0) {
  if (json.is_null()) return "nil";
  if (json.is_number_float()) return float_text(json.get<double>());
  if (json.is_string()) return text_constant(json.get<std::string>());
  if (!json.is_structured()) return json.dump();
  if (json.is_object())
    refuse_data(
        path,
        "has an object, {...}; data are numbers, texts and lists of such, so write a list of its values");
  if (depth == kDeepestLists)
    refuse_data(path, fmt::format("has more than {} lists within each other", kDeepestLists));
  std::vector<std::string> items;
  for (const Json& item : json) items.push_back(json_constant(item, path, depth + 1));
  return list_constant(items);
}

std::string constant_of_json(const std::filesystem::path& path) {
  const std::string text = text_of_data(path);
  try {
    return json_constant(Json::parse(text), path);
  } catch (const Json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1 ..."
    const std::string_view what = error.what();
    refuse_data(path, fmt::format("is no JSON: {}", what.substr(what.find("] ") + 2)));
  }
}

// ---- tables

using Cells = std::vector<std::string>;

/// What stands between the cells: a comma, or a tab or semicolon where the first row has no comma.
char separator_of(const std::string& text) {
  bool quoted = false, tab = false, semicolon = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\n') break;
    if (c == ',') return ',';
    tab = tab || c == '\t';
    semicolon = semicolon || c == ';';
  }
  return tab ? '\t' : semicolon ? ';' : ',';
}

/// Splits a table into rows of cells. Cells in double quotes may have separators, line ends and doubled
/// quotes.
std::vector<Cells> cells_of(const std::string& text, char separator, const std::filesystem::path& path) {
  std::vector<Cells> rows;
  Cells row;
  std::string cell;
  bool quoted = false;
  std::size_t opened = 0;  // the row where the quote that is open stands
  const auto end_cell = [&] { row.push_back(std::exchange(cell, {})); };
  const auto end_row = [&] {
    end_cell();
    if (row.size() > 1 || !row[0].empty()) rows.push_back(row);
    row.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
      cell += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
      opened = rows.size() + 1;
    } else if (c == separator && !quoted) {
      end_cell();
    } else if (c == '\n' && !quoted) {
      end_row();
    } else if (c != '\r') {
      cell += c;
    }
  }
  if (quoted) refuse_data(path, fmt::format("a double quote in row {} is never closed", opened));
  if (!cell.empty() || !row.empty()) end_row();
  return rows;
}

std::string trimmed_cell(const std::string& cell) {
  const auto first = cell.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
}

template <class Number>
std::optional<Number> number_in(const std::string& cell) {
  Number number{};
  const char* const end = cell.data() + cell.size();
  const auto [stop, error] = std::from_chars(cell.data(), end, number);
  if (cell.empty() || error != std::errc{} || stop != end) return std::nullopt;
  if (!std::isfinite(static_cast<double>(number))) return std::nullopt;  // "inf" and "nan" are texts
  return number;
}

bool is_number_cell(const std::string& cell) { return number_in<double>(trimmed_cell(cell)).has_value(); }

/// Two numbers with that sign between them, such as "1,5".
bool is_pair(const std::string& cell, char sign) {
  const std::size_t at = cell.find(sign);
  return at != std::string::npos && is_number_cell(cell.substr(0, at)) && is_number_cell(cell.substr(at + 1));
}

/// Refuses a row of which one can tell that it was split at another sign than whoever wrote it meant.
void check_row(const Cells& row, std::size_t number, char separator, const std::filesystem::path& path) {
  for (const std::string& cell : row) {
    if (separator != ',' && is_pair(cell, ',')) {
      refuse_data(path,
                  fmt::format("row {} of the data has the number {} with a comma; write it with a point",
                              number, trimmed_cell(cell)));
    }
    if (separator == ',' && is_pair(cell, ';')) {
      refuse_data(path, fmt::format("row {} of the data has the cell {}; put either commas or semicolons "
                                    "between all cells, and write numbers with a point",
                                    number, trimmed_cell(cell)));
    }
  }
}

std::string cell_constant(const std::string& cell) {
  const std::string text = trimmed_cell(cell);
  if (const auto i = number_in<std::int64_t>(text)) return std::to_string(*i);
  if (const auto d = number_in<double>(text)) return float_text(*d);
  return text_constant(text);
}

std::string constant_of_table(const std::filesystem::path& path) {
  const std::string text = text_of_data(path);
  const char separator = separator_of(text);
  std::vector<Cells> rows = cells_of(text, separator, path);
  if (!rows.empty() && std::none_of(rows[0].begin(), rows[0].end(), is_number_cell)) rows.erase(rows.begin());
  std::vector<std::string> items;
  for (const Cells& row : rows) {
    if (row.size() != rows[0].size()) {
      refuse_data(path, fmt::format("row {} of the data has {} cells, and the first has {}", items.size() + 1,
                                    row.size(), rows[0].size()));
    }
    check_row(row, items.size() + 1, separator, path);
    Cells constants;
    for (const std::string& cell : row) constants.push_back(cell_constant(cell));
    items.push_back(row.size() == 1 ? constants[0] : list_constant(constants));
  }
  return list_constant(items);
}

}  // namespace

std::string constant_of_file(const std::filesystem::path& path) {
  if (path.extension() == ".json") return constant_of_json(path);
  if (path.extension() == ".csv") return constant_of_table(path);
  refuse_data(path, "data end in .json or .csv");
}

}  // namespace solitaire::api
