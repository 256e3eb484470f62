#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/one_of.h"
#include "app/report.h"
#include "app/tiles_options.h"

namespace solitaire::app {
namespace {

void add_generate_options(CLI::App& command, Options& options) {
  options.search.count = 8;
  options.search.distinct = Distinct::kResult;
  add_program_options(command, options);
  add_search_options(command, options);
  command.add_option("-o,--output", options.output, "the folder to write to (default out)");
  command.add_flag("--json", options.json, "also print solutions, a JSON object a line");
  command.add_flag("--resume", options.resume,
                   "go on with the run that left its solutions in the folder, without repeating any");
  command.add_flag("--instancing", options.instancing,
                   "let things that look alike share a node of the .glb (EXT_mesh_gpu_instancing)");
  command.add_flag("--timings", options.timings,
                   "keep the times in the .json files, which then differ from run to run");
  add_picture_options(command, options);
  add_camera_option(command, options);
}

void add_solve_options(CLI::App& command, Options& options) {
  add_program_options(command, options);
  add_search_options(command, options);
  command.add_flag("--json", options.json, "a JSON object a line");
  options.search.run_each = false;
  command.add_flag(
      "--check", options.search.run_each,
      "run the program again with every solution, as generate does, instead of reading most off the trace");
}

void add_check_options(CLI::App& command, Options& options) {
  add_program_options(command, options);
  command.add_flag("--deep", options.deep,
                   "look into every path for mistakes that only some choices lead to, and say which");
}

void add_explain_options(CLI::App& command, Options& options) {
  add_program_options(command, options);
  add_solver_options(command, options);
  command.add_option("--more", options.more, "also show so many further, independent conflicts")
      ->type_name("N");
  command.add_flag("--full", options.full,
                   "show every member of a conflict, also where that is more than a screen");
  command.add_flag("--choices", options.choices, "show the values of every choice in solutions");
  command.add_flag("--thorough", options.thorough, "give no question up, however long it takes");
  command.add_flag("--json", options.json, "as one JSON object");
}

void add_counting_options(CLI::App& command, Options& options) {
  add_program_options(command, options);
  add_solver_options(command, options);
  add_count_options(command, options);
  command.add_flag("--json", options.json, "as one JSON object");
}

void add_sampling_options(CLI::App& command, Options& options) {
  add_program_options(command, options);
  add_sample_options(command, options);
  command.add_flag("--json", options.json, "as one JSON object");
}

void add_trace_options(CLI::App& command, Options& options) {
  add_program_options(command, options);
  command.add_option("--format", options.format, "text (default), dot for Graphviz, or smt2 for solvers")
      ->transform(one_of<TraceFormat>(
          {{"text", TraceFormat::kText}, {"dot", TraceFormat::kDot}, {"smt2", TraceFormat::kSmtlib}}));
}

void add_asset_options(CLI::App& command, Options& options) {
  command.add_option("NAME", options.models, "names of models, or of sets such as kitchen; all without any");
  add_assets_option(command, options);
  command.add_flag("--json", options.json, "a JSON object a line");
  add_picture_options(command, options);
  command.add_option("-o,--output", options.output, "the folder that --png writes to (default out)");
  command.add_flag("-q,--quiet", options.quiet, "no summary");
}

struct Subcommand {
  const char* name;
  const char* description;
  Command command;
  void (*add_options)(CLI::App&, Options&);
};

constexpr Subcommand kSubcommands[] = {
    {"generate", "find solutions and write each as a 3D scene (.glb), with a page that shows all",
     generate_command, add_generate_options},
    {"solve", "find solutions and print them", solve_command, add_solve_options},
    {"check", "look for mistakes in a program", check_command, add_check_options},
    {"explain", "why a program has no solution, or what in it rules nothing out and never occurs",
     explain_command, add_explain_options},
    {"count", "say how many solutions there are", count_command, add_counting_options},
    {"sample", "draw executions by how probable they are, and sum up what the program returns",
     sample_command, add_sampling_options},
    {"trace", "print the trace graph of a program", trace_command, add_trace_options},
    {"assets", "list the models that programs can place, and draw them", assets_command, add_asset_options},
    {"tiles", "make maps of tiles that look like small exemplars", tiles_command, add_tiles_options},
};

/// Prints what the command line's reader reports: help to standard output, errors to standard error.
ExitStatus answer(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream result, complaint;
  const bool helped = app.exit(error, result, complaint) == 0;
  tell(complaint.str());
  return status_of({}, [&] {
    print_result(result.str());
    return helped ? kDelivered : kUsage;
  });
}

/// Returns the word that stands where the command should, if it is none of them; "" if all is well.
std::string wrong_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  const std::string word = argv[1];
  const bool known =
      std::ranges::any_of(kSubcommands, [&](const Subcommand& each) { return word == each.name; });
  return known ? "" : word;
}

/// Says what to write before a script, which is what a first word that is no command mostly is.
void tell_wrong_command(const std::string& word) {
  std::vector<std::string> names;
  for (const Subcommand& each : kSubcommands) names.emplace_back(each.name);
  const std::string shown = word.size() <= 100 ? word : word.substr(0, 100) + "...";
  const bool is_script = std::filesystem::path(word).extension() == ".sol";
  tell(fmt::format("'{}' is no command; the commands are {}\n{}", shown, fmt::join(names, ", "),
                   is_script
                       ? fmt::format("to find solutions: solitaire solve {0}, or solitaire generate {0} for "
                                     "scenes\n",
                                     shown)
                       : "Run with --help for more information.\n"));
}

}  // namespace

std::variant<Asked, ExitStatus> read_command_line(int argc, char** argv) {
  CLI::App app("Solitaire: scripts with choices and constraints, solved into many different 3D scenes.");
  app.name("solitaire");
  app.set_version_flag("--version", std::string("solitaire ") + version());
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "what this command does and takes");

  std::deque<std::pair<CLI::App*, Asked>> subcommands;  // a deque, as the reader writes into the options
  for (const Subcommand& each : kSubcommands) {
    auto& [command, asked] =
        subcommands.emplace_back(app.add_subcommand(each.name, each.description), Asked{each.command, {}});
    each.add_options(*command, asked.options);
  }
  if (const std::string word = wrong_command(argc, argv); !word.empty()) {
    tell_wrong_command(word);
    return kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  }
  const auto parsed = [](const auto& subcommand) { return subcommand.first->parsed(); };
  return std::find_if(subcommands.begin(), subcommands.end(), parsed)->second;
}

}  // namespace solitaire::app
