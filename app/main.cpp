#include <CLI/CLI.hpp>
#include <sstream>

#include "app/commands.h"
#include "app/console.h"
#include "app/report.h"
#include "app/signals.h"
#include "solitaire/large_stack.h"

namespace solitaire {
namespace {

using Command = ExitStatus (*)(const Options&, Watchdog&);

ExitStatus run(Command command, const Options& options) {
  return status_of(options, [&] {
    Watchdog watchdog(options);
    return status_of(options, [&] { return command(options, watchdog); });
  });
}

/// What the command line's reader has to say: help to standard output, mistakes to standard error.
ExitStatus answer(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream result, complaint;
  const bool helped = app.exit(error, result, complaint) == 0;
  tell(complaint.str());
  return status_of({}, [&] {
    print_result(result.str());
    return helped ? kDelivered : kUsage;
  });
}

int run_command_line(int argc, char** argv) {
  CLI::App app("Solitaire: scripts with choices and constraints, solved into many different 3D scenes.");
  app.name("solitaire");
  app.set_version_flag("--version", std::string("solitaire ") + SOLITAIRE_VERSION);
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "what this command does and takes");

  Options generate_options;
  generate_options.count = 8;
  generate_options.distinct = Distinct::kResult;
  CLI::App* generating = app.add_subcommand(
      "generate", "find solutions and write each as a 3D scene (.glb), with a page that shows all");
  add_program_options(*generating, generate_options);
  add_search_options(*generating, generate_options);
  generating->add_option("-o,--output", generate_options.output, "the folder to write to (default out)");
  generating->add_flag("--json", generate_options.json, "also print solutions, a JSON object a line");
  generating->add_flag("--resume", generate_options.resume,
                       "go on with the run that left its solutions in the folder, without repeating any");
  generating->add_flag("--timings", generate_options.timings,
                       "keep the times in the .json files, which then differ from run to run");

  Options solve_options;
  CLI::App* solving = app.add_subcommand("solve", "find solutions and print them");
  add_program_options(*solving, solve_options);
  add_search_options(*solving, solve_options);
  solving->add_flag("--json", solve_options.json, "a JSON object a line");

  Options check_options;
  CLI::App* checking = app.add_subcommand("check", "look for mistakes in a program");
  add_program_options(*checking, check_options);
  checking->add_flag("--deep", check_options.deep,
                     "look into every path for mistakes that only some choices lead to, and say which");

  Options explain_options;
  CLI::App* explaining = app.add_subcommand(
      "explain", "why a program has no solution, or what in it rules nothing out and never occurs");
  add_program_options(*explaining, explain_options);
  add_solver_options(*explaining, explain_options);
  explaining->add_option("--more", explain_options.more, "also show so many further, independent conflicts")
      ->type_name("N");
  explaining->add_flag("--choices", explain_options.choices, "show the values of every choice in solutions");
  explaining->add_flag("--thorough", explain_options.thorough,
                       "of a program with solutions: give no question up, however long it takes");
  explaining->add_flag("--json", explain_options.json, "as one JSON object");

  Options count_options;
  CLI::App* counting = app.add_subcommand("count", "say how many solutions there are");
  add_program_options(*counting, count_options);
  add_solver_options(*counting, count_options);
  add_count_options(*counting, count_options);
  counting->add_flag("--json", count_options.json, "as one JSON object");

  Options trace_options;
  CLI::App* tracing = app.add_subcommand("trace", "print the trace graph of a program");
  add_program_options(*tracing, trace_options);
  tracing
      ->add_option("--format", trace_options.format, "text (default), dot for Graphviz, or smt2 for solvers")
      ->check(CLI::IsMember({"text", "dot", "smt2"}));

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  }
  if (generating->parsed()) return run(generate, generate_options);
  if (solving->parsed()) return run(solve, solve_options);
  if (checking->parsed()) return run(check, check_options);
  if (explaining->parsed()) return run(explain, explain_options);
  if (counting->parsed()) return run(count, count_options);
  return run(trace_graph, trace_options);
}

}  // namespace
}  // namespace solitaire

int main(int argc, char** argv) {
  solitaire::reserve_standard_streams();
  solitaire::catch_signals();
  int status = solitaire::kError;
  solitaire::run_on_large_stack([&] { status = solitaire::run_command_line(argc, argv); });
  return status;
}
