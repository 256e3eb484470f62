#include "app/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <thread>

#include "app/one_of.h"

namespace solitaire::app {
namespace {

constexpr std::uint64_t kMostCount = 9'999'999'999'999'999'999U;
constexpr double kMostSeconds = 1e12;

/// Returns as much of what the user wrote as a message repeats.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 100;
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

/// Returns what a text is wrong for, as a number of that type; "" for one that lies within the ends.
template <class Number>
std::string check_number(const std::string& text, Number least, Number most, const std::string& wanted) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool good = error == std::errc{} && stop == end && number >= least && number <= most;
  return good ? "" : fmt::format("'{}' is not {}", shortened(text), wanted);
}

std::string check_count(const std::string& text) {
  return check_number<std::uint64_t>(text, 1, kMostCount, "a whole number from 1, of at most 19 digits");
}

std::string check_seed(const std::string& text) {
  return check_number<std::uint64_t>(text, 0, kMostCount, "a whole number from 0, of at most 19 digits");
}

std::string check_seconds(const std::string& text) {
  return check_number<double>(text, 0, kMostSeconds, "a number of seconds from 0");
}

std::string check_megabytes(const std::string& text) {
  return check_number<double>(text, std::numeric_limits<double>::min(), 1e12,
                              "a number of megabytes above 0");
}

std::string check_setting(const std::string& text) {
  const std::size_t sign = text.find('=');
  return sign == std::string::npos || sign == 0 ? fmt::format("'{}' is not of the form NAME=VALUE", text)
                                                : "";
}

std::string check_formula_name(const std::string& name) {
  const auto ending = std::filesystem::path(name).extension();
  return ending == ".smt2" || ending == ".cnf"
             ? ""
             : fmt::format("'{}' ends neither in .smt2, for SMT-LIB, nor in .cnf, for DIMACS", name);
}

std::string check_picture_size(const std::string& text) {
  if (parse_picture_size(text)) return "";
  return fmt::format("'{}' is no size of a picture; write one like 640x480, of at most 16 million pixels",
                     text);
}

/// Adds an option that can be given several times, each time with one value.
CLI::Option* add_repeatable(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                            const std::string& help) {
  return command.add_option(name, values, help)
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

Words<Solver> exact_engines() {
  return {{"auto", Solver::kCadical}, {"cadical", Solver::kCadical}, {"z3", Solver::kZ3}};
}

/// Adds the choice among all engines, also the one whose answers are no proofs.
void add_engine_option(CLI::App& command, Options& options) {
  Words<Solver> engines = exact_engines();
  engines.emplace_back("thesis", Solver::kThesis);
  engines.emplace_back("shred", Solver::kShred);
  engines.emplace_back("tiles", Solver::kTiles);
  command
      .add_option(
          "--engine", options.search.solver,
          "which solver to use: cadical (auto takes it: the fastest), z3 (the reference), thesis (16-bit "
          "ints "
          "and random exploration, as published, to measure against), shred (draws executions by how "
          "probable they are, as 'sample' does), or tiles (draws maps of tiles as their exemplars look)")
      ->transform(one_of(engines));
  command.parse_complete_callback([&options] {
    const SearchOptions& search = options.search;
    if (search.solver == Solver::kThesis && search.exploration_name() == "demand")
      throw CLI::ValidationError("--explore", "--engine thesis explores at random only: random:N");
  });
}

void add_pin_options(CLI::App& command, Options& options) {
  add_repeatable(
      command, "--pin", options.pins,
      "fix the choices whose addresses match a pattern: ADDRESS=VALUE, as 'wing[*]/room[0]/x=3'; can be "
      "given several times")
      ->type_name("ADDRESS=VALUE");
  add_repeatable(command, "--forbid", options.forbidden, "keep the choices that match from having a value")
      ->type_name("ADDRESS=VALUE");
  auto* file = command
                   .add_option("--pin-file", options.search.pin_file,
                               "fix choices to what they are in the .json file of a solution")
                   ->type_name("FILE");
  add_repeatable(
      command, "--keep", options.search.keep,
      "of --pin-file, fix only the choices whose addresses match the pattern; can be given several times")
      ->type_name("PATTERN")
      ->needs(file);
}

/// Returns what pictures are asked for, from now on some.
Pictures& pictures_of(Options& options) {
  return options.pictures ? *options.pictures : options.pictures.emplace();
}

}  // namespace

void add_assets_option(CLI::App& command, Options& options) {
  command
      .add_option(
          "--assets", options.assets,
          "a folder with models (NAME.glb), looked into before the bundled ones; can be given several times")
      ->check(CLI::ExistingDirectory)
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_program_options(CLI::App& command, Options& options) {
  command.add_option("FILE", options.script, "the script, a .sol file")->required();
  add_assets_option(command, options);
  add_repeatable(command, "--set", options.settings,
                 "set a param of the program: NAME=VALUE; can be given several times")
      ->check(CLI::Validator(check_setting, "NAME=VALUE"));
  add_repeatable(command, "--data", options.data,
                 "set a param of the program to what a .json or .csv file holds: NAME=FILE")
      ->check(CLI::Validator(check_setting, "NAME=FILE"));
  add_seed_option(command, options.search.seed, "same seed, program and options: same output (default 0)");
  command
      .add_option(
          "--explore", options.search.explore,
          "which paths to cover: 'demand' (default) opens what stands in the way of a solution; 'random:N' "
          "only what N random executions take")
      ->check(CLI::Validator(check_exploration, "demand|random:N"));
  command
      .add_option("--max-steps", options.search.max_steps,
                  "steps after which one execution counts as endless (default 10000000)")
      ->check(CLI::Validator(check_count, "N"));
  command
      .add_option("--max-depth", options.search.max_depth,
                  "calls within each other after which a recursion counts as endless (default 4000)")
      ->check(CLI::Validator(check_count, "N"));
  add_limit_options(command, options);
  command.add_flag("-q,--quiet", options.quiet, "no progress and no summary");
}

void add_limit_options(CLI::App& command, Options& options) {
  command.add_option("--timeout", options.timeout, "end after so many seconds, keeping what was found")
      ->check(CLI::Validator(check_seconds, "SECONDS"));
  command
      .add_option("--memory", options.memory,
                  "end when more than so many megabytes of memory are in use, keeping what was found")
      ->check(CLI::Validator(check_megabytes, "MEGABYTES"));
}

void add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& help) {
  command.add_option("--seed", seed, help)->check(CLI::Validator(check_seed, "N"));
}

void add_solver_options(CLI::App& command, Options& options) {
  command
      .add_option("--engine", options.search.solver,
                  "which solver to use: cadical (auto takes it: the fastest), or z3 (the reference)")
      ->transform(one_of(exact_engines()));
  add_pin_options(command, options);
}

void add_search_options(CLI::App& command, Options& options) {
  auto* count = command
                    .add_option("-n", options.search.count,
                                fmt::format("how many solutions (default {})", options.search.count))
                    ->check(CLI::Validator(check_count, "N"));
  command
      .add_option("--per-solution", options.search.seconds_per_solution,
                  "end when one further solution takes longer than so many seconds, keeping what was found")
      ->check(CLI::Validator(check_seconds, "SECONDS"));
  add_engine_option(command, options);
  add_pin_options(command, options);
  auto* relax =
      command.add_flag("--relax", options.search.relax,
                       "where not all asserts can hold, break as few as possible, and mark what is broken");
  auto* all = command
                  .add_flag("--all", options.search.all,
                            "all solutions, until it is proved that no further one exists")
                  ->excludes(count);
  auto* sample =
      command
          .add_option(
              "--sample", options.search.sampling,
              "how to choose among all solutions: as the search finds them (search, default), or each "
              "with the same probability (uniform)")
          ->transform(one_of<Sampling>({{"search", Sampling::kSearch}, {"uniform", Sampling::kUniform}}));
  command
      .add_option(
          "--distinct", options.search.distinct,
          "what makes two solutions different: their choices, the result (value and scene), or the value "
          "that the program returns before its output")
      ->transform(one_of<Distinct>(
          {{"choices", Distinct::kChoices}, {"result", Distinct::kResult}, {"value", Distinct::kValue}}));
  options.search.jobs = std::max(1U, std::thread::hardware_concurrency());
  auto* min_distance =
      command
          .add_option(
              "--min-distance", options.search.min_distance,
              "the share of choices, 0 to 1, in which each solution has to differ from every earlier one")
          ->check(CLI::Range(0.0, 1.0));
  command
      .add_option("--jobs", options.search.jobs,
                  fmt::format("how many searches work side by side; the solutions are the same for any "
                              "number (default {}, one for each processor)",
                              options.search.jobs))
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command
      .add_option(
          "--diversity", options.search.diversity,
          "how far apart solutions are: 'low' takes whatever comes fastest (with --all by itself), "
          "'normal' (default) starts each search at random values, 'high' also without regard to what "
          "earlier searches met, which takes longer")
      ->transform(one_of<Diversity>(
          {{"low", Diversity::kLow}, {"normal", Diversity::kNormal}, {"high", Diversity::kHigh}}));
  auto* formula =
      command
          .add_option(
              "--formula", options.formula,
              "write what holds in the solutions that are left at the end, which is unsatisfiable if there "
              "are none: as SMT-LIB (.smt2) or as clauses (.cnf)")
          ->check(CLI::Validator(check_formula_name, "FILE.smt2|FILE.cnf"));
  for (CLI::Option* other : {relax, all, formula, min_distance}) sample->excludes(other);
}

void add_picture_options(CLI::App& command, Options& options) {
  command.add_flag_callback(
      "--png", [&] { pictures_of(options); },
      "also draw a picture of each scene (.png), and a contact sheet of them all (sheet.png)");
  command
      .add_option_function<std::string>(
          "--png-size",
          [&](const std::string& text) { pictures_of(options).size = *parse_picture_size(text); },
          "draw pictures of so many pixels (default 640x480)")
      ->check(CLI::Validator(check_picture_size, "WIDTHxHEIGHT"));
}

void add_camera_option(CLI::App& command, Options& options) {
  command
      .add_option_function<Viewpoint>(
          "--camera", [&](const Viewpoint& from) { pictures_of(options).from = from; },
          "draw pictures from the front, the right and above (above: default), or as somebody sees it who "
          "stands in the scene (eye: NAME-eye.png)")
      ->transform(one_of<Viewpoint>({{"above", Viewpoint::kAbove}, {"eye", Viewpoint::kEye}}));
}

void add_sample_options(CLI::App& command, Options& options) {
  SampleOptions& sampling = options.sampling;
  const auto number = [&](const std::string& name, auto& value, const std::string& help) {
    command.add_option(name, value, help)->check(CLI::Validator(check_count, "N"));
  };
  number("-n", sampling.draws, "how many draws are kept, over all chains (default 1000)");
  number("--chains", sampling.chains, "how many independent chains draw (default 4)");
  command.add_option("--warmup", sampling.warmup, "draws of each chain that are thrown away at its start")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  number("--thin", sampling.thin, "sweeps over all choices from one draw to the next (default 1)");
  command
      .add_option("--engine", sampling.engine,
                  "how to draw: shred (default: a step computes anew what depends on it), or lightweight (a "
                  "step runs the program again)")
      ->transform(one_of<SampleOptions::Engine>(
          {{"shred", SampleOptions::Engine::kShred}, {"lightweight", SampleOptions::Engine::kLightweight}}));
  command.add_option("--draws", options.draws_file, "write the draws: a table, or lines of JSON (.jsonl)")
      ->type_name("FILE.csv");
  command
      .add_option(
          "--stream", options.stream,
          "print each draw as it comes, as a line of JSON or a row of a table; the summary goes to standard "
          "error")
      ->transform(one_of<DrawFormat>({{"jsonl", DrawFormat::kJsonLines}, {"csv", DrawFormat::kCsv}}));
  command.add_option("--report", options.report_file, "write a page with pictures of the draws")
      ->type_name("FILE.html");
  sampling.jobs = std::max(1U, std::thread::hardware_concurrency());
  command
      .add_option(
          "--jobs", sampling.jobs,
          fmt::format("how many chains work side by side; the draws are the same for any number (default "
                      "{}, one for each processor)",
                      sampling.jobs))
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
}

void add_count_options(CLI::App& command, Options& options) {
  CountOptions& counting = options.counting;
  auto* exact = command.add_flag_callback(
      "--exact", [&] { counting.way = CountOptions::Way::kExact; }, "count exactly, however long it takes");
  command
      .add_flag_callback(
          "--approximate", [&] { counting.way = CountOptions::Way::kApproximate; },
          "estimate the number, unless it is very small")
      ->excludes(exact);
  command
      .add_option("--tolerance", counting.tolerance,
                  "an estimate is within a factor of 1 + so much (default 0.8)")
      ->check(CLI::Range(0.01, 1000.0));
  command.add_option("--confidence", counting.confidence, "with at least this probability (default 0.9)")
      ->check(CLI::Range(0.0, 0.999));
}

}  // namespace solitaire::app
