#pragma once
#include <filesystem>
#include <string>

namespace solitaire::api {

/// Reads a file of data as a constant of the language, for a param.
///
/// A .json file has numbers, texts, true, false, null and lists of such. A .csv file is a table: a list of
/// its rows, each a list of cells, or, if it has one column, a list of the cells. A cell is a number if it
/// reads as one, else a text. A first row in which no cell is a number is a heading, and left out. Throws
/// Error (kFile), which names the file and the place in it.
std::string constant_of_file(const std::filesystem::path& path);

}  // namespace solitaire::api
