#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <solitaire/solitaire.h>
#include <string>
#include <vector>

#include "app/draw_printer.h"

namespace CLI {
class App;
}

namespace solitaire::app {

using namespace api;

/// Exit statuses of every subcommand.
enum ExitStatus : int {
  kDelivered = 0,   // what was asked for
  kNoSolution = 1,  // proved that there is no (further) solution where one was asked for
  kUsage = 2,
  kError = 3,  // in the program, or a file that cannot be read or written
  kLimit = 4,  // time, memory or an interrupt came first; what was found is kept
};

struct TilesOptions;

/// What the command line asks for.
struct Options {
  std::string script;
  std::vector<std::string> settings;          // NAME=VALUE
  std::vector<std::string> data;              // NAME=FILE
  SearchOptions search;                       // without pins; Session adds them
  std::vector<std::string> pins;              // ADDRESS=VALUE
  std::vector<std::string> forbidden;         // ADDRESS=VALUE
  std::vector<std::filesystem::path> assets;  // folders with models of the user's
  std::vector<std::string> models;            // names of models or sets; none for all
  std::filesystem::path output = "out";
  std::optional<std::filesystem::path> formula;  // where what is left at the end is written to
  bool json = false;
  bool timings = false;
  bool resume = false;
  bool instancing = false;
  std::optional<Pictures> pictures;  // of the scenes or models
  bool deep = false;
  bool quiet = false;
  std::optional<double> timeout;  // seconds, for the whole run
  std::optional<double> memory;   // megabytes, of the process
  TraceFormat format = TraceFormat::kText;
  std::uint64_t more = 0;  // conflicts after the first
  bool choices = false;    // explain every choice
  bool full = false;       // show all of a conflict
  bool thorough = false;
  CountOptions counting;
  SampleOptions sampling;
  std::optional<std::filesystem::path> draws_file;
  std::optional<DrawFormat> stream;  // of the draws, on standard output
  std::optional<std::filesystem::path> report_file;
  std::shared_ptr<TilesOptions> tiles;  // of the subcommand tiles
};

/// Adds the options that every subcommand shares.
void add_program_options(CLI::App& command, Options& options);
/// --timeout and --memory.
void add_limit_options(CLI::App& command, Options& options);
void add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& help);
/// Adds the options of the subcommands that solve: which solver, and what is held fixed.
void add_solver_options(CLI::App& command, Options& options);
/// Adds the options of the subcommands that look for solutions.
void add_search_options(CLI::App& command, Options& options);
/// Adds the options of the subcommands that draw pictures.
void add_picture_options(CLI::App& command, Options& options);
/// Adds from where scenes are drawn.
void add_camera_option(CLI::App& command, Options& options);
/// Adds the folders with models.
void add_assets_option(CLI::App& command, Options& options);
/// Adds those of the subcommand that counts.
void add_count_options(CLI::App& command, Options& options);
/// Adds those of the subcommand that draws samples.
void add_sample_options(CLI::App& command, Options& options);

}  // namespace solitaire::app
