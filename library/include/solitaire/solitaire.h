#pragma once
// Solitaire as a library: programs from files or buffers, solutions, explanations, and files with scenes.
//
//     namespace sol = solitaire::api;
//     sol::Program program = sol::Program::load("office.sol");
//     program.set("desks", "4");
//     sol::SearchOptions options;
//     options.count = 5;
//     sol::Search search(program, options);
//     for (const sol::Solution& solution : search) {
//       std::cout << sol::to_json(solution) << '\n';
//       sol::write_glb(solution, program, "office", "office.glb");
//     }
//
// Nothing here prints, ends the process, or keeps anything for the whole process; objects of different
// threads have nothing to do with each other. Errors are exceptions of the type Error. docs/library.md tells
// more.
#include <functional>
#include <solitaire/check.h>
#include <solitaire/count.h>
#include <solitaire/error.h>
#include <solitaire/explain.h>
#include <solitaire/export.h>
#include <solitaire/models.h>
#include <solitaire/options.h>
#include <solitaire/output.h>
#include <solitaire/program.h>
#include <solitaire/sample.h>
#include <solitaire/search.h>
#include <solitaire/solution.h>
#include <solitaire/stop.h>

namespace solitaire::api {

/// Returns "0.1.0".
SOLITAIRE_API const char* version();

/// Runs `work` to its end on a thread whose stack is large enough for the deepest recursion that
/// Options::max_depth allows by default, and `beside` at the same time, if there is any, on this thread.
/// Elsewhere a program that nests too deep for the stack is reported as an error. Exceptions must not leave
/// them.
SOLITAIRE_API void run_on_large_stack(const std::function<void()>& work,
                                      const std::function<void()>& beside = {});

}  // namespace solitaire::api
