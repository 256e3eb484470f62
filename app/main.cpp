#include <CLI/CLI.hpp>
#include <functional>
#include <malloc.h>
#include <sstream>

#include "app/commands.h"
#include "app/console.h"
#include "app/report.h"
#include "app/signals.h"
#include "base/large_stack.h"

namespace solitaire {
namespace {

using Command = ExitStatus (*)(const Options&, Watchdog&);

/// The first thread watches the limits, while another one with a large stack runs the command.
ExitStatus run(Command command, const Options& options) {
  return status_of(options, [&] {
    Watchdog watchdog(options);
    ExitStatus status = kError;
    const auto work = [&] {
      status = status_of(options, [&] { return command(options, watchdog); });
      watchdog.end();
    };
    run_on_large_stack(work, [&] { watchdog.watch(); });
    return status;
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

/// A subcommand. It gets its options when it is asked for, as there are many in all.
CLI::App* add_command(CLI::App& app, const char* name, const char* description,
                      std::function<void(CLI::App&)> add_options) {
  CLI::App* command = app.add_subcommand(name, description);
  command->preparse_callback([command, add = std::move(add_options)](std::size_t) { add(*command); });
  return command;
}

/// The command's thread does nearly all the work. This lets its memory grow in large steps, as that of a
/// first thread does by itself.
void let_memory_grow_in_large_steps() {
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TOP_PAD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
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
  generate_options.replay = Replay::kEvery;
  CLI::App* generating = add_command(
      app, "generate", "find solutions and write each as a 3D scene (.glb), with a page that shows all",
      [&](CLI::App& command) {
        add_program_options(command, generate_options);
        add_search_options(command, generate_options);
        command.add_option("-o,--output", generate_options.output, "the folder to write to (default out)");
        command.add_flag("--json", generate_options.json, "also print solutions, a JSON object a line");
        command.add_flag("--resume", generate_options.resume,
                         "go on with the run that left its solutions in the folder, without repeating any");
        command.add_flag("--timings", generate_options.timings,
                         "keep the times in the .json files, which then differ from run to run");
      });

  Options solve_options;
  CLI::App* solving = add_command(app, "solve", "find solutions and print them", [&](CLI::App& command) {
    add_program_options(command, solve_options);
    add_search_options(command, solve_options);
    command.add_flag("--json", solve_options.json, "a JSON object a line");
    command.add_flag_callback(
        "--check", [&] { solve_options.replay = Replay::kEvery; },
        "run the program again with every solution, as generate does, instead of reading most off the trace");
  });

  Options check_options;
  CLI::App* checking = add_command(app, "check", "look for mistakes in a program", [&](CLI::App& command) {
    add_program_options(command, check_options);
    command.add_flag("--deep", check_options.deep,
                     "look into every path for mistakes that only some choices lead to, and say which");
  });

  Options explain_options;
  CLI::App* explaining = add_command(
      app, "explain", "why a program has no solution, or what in it rules nothing out and never occurs",
      [&](CLI::App& command) {
        add_program_options(command, explain_options);
        add_solver_options(command, explain_options);
        command
            .add_option("--more", explain_options.more, "also show so many further, independent conflicts")
            ->type_name("N");
        command.add_flag("--choices", explain_options.choices,
                         "show the values of every choice in solutions");
        command.add_flag("--thorough", explain_options.thorough,
                         "of a program with solutions: give no question up, however long it takes");
        command.add_flag("--json", explain_options.json, "as one JSON object");
      });

  Options count_options;
  CLI::App* counting = add_command(app, "count", "say how many solutions there are", [&](CLI::App& command) {
    add_program_options(command, count_options);
    add_solver_options(command, count_options);
    add_count_options(command, count_options);
    command.add_flag("--json", count_options.json, "as one JSON object");
  });

  Options trace_options;
  add_command(app, "trace", "print the trace graph of a program", [&](CLI::App& command) {
    add_program_options(command, trace_options);
    command
        .add_option("--format", trace_options.format, "text (default), dot for Graphviz, or smt2 for solvers")
        ->check(CLI::IsMember({"text", "dot", "smt2"}));
  });

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
  solitaire::let_memory_grow_in_large_steps();
  return solitaire::run_command_line(argc, argv);
}
