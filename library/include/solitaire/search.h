#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <solitaire/export.h>
#include <solitaire/options.h>
#include <solitaire/program.h>
#include <solitaire/solution.h>
#include <vector>

namespace solitaire::api {

/// Says why a search has no further solution.
enum class Ending : std::uint8_t {
  kNone,        // it may have one, or as many came as were wanted
  kExhausted,   // it is proved that there is none
  kUnexplored,  // there is none on the paths that were explored; others were not looked at
  kWrapped,     // there is none for a solver whose ints wrap
  kStopped,     // a stop was asked for, or a limit came first
};

/// Says where the time went, in seconds, and how many times a solution was run again.
struct Times {
  double explore = 0, encode = 0, solve = 0, replay = 0;
  std::uint64_t replays = 0;
};

/// Says what a search came to so far.
struct Summary {
  std::uint64_t solutions = 0;  // with those of earlier runs
  std::uint64_t earlier = 0;    // of these, solutions of earlier runs
  std::uint64_t alike = 0;      // solutions that were left out because they look like others
  bool names_differed = false;  // whether some of these differ in names or extras of placed things
  /// The mean distance of all pairs of solutions, 0..1; see docs/formats.md.
  double choice_distance = 0;
  /// That of the choices of the two nearest, unless there are fewer than two solutions or very many.
  std::optional<double> nearest_choices;
  double result_distance = 0;
  Times times;  // as of the last solution
};

/// Is told how far a search is, on the thread that calls next(). Whatever it throws comes out of next().
class SOLITAIRE_API SearchObserver {
 public:
  virtual ~SearchObserver();
  /// The search for a further solution begins.
  virtual void begun() {}
  /// The paths are explored, as far as that is done beforehand; the graph has so many nodes.
  virtual void explored(std::size_t nodes);
  /// A solution was found that is better than those before it, while the best one is looked for.
  virtual void improved(const Solution& best);
};

/// Looks for solutions of a program, one after the other. Use one search from one thread at a time; where it
/// is said, other threads may look in meanwhile. Programs that call themselves very deeply need the stack of
/// run_on_large_stack().
class SOLITAIRE_API Search {
 public:
  /// Throws Error: kUsage for pins and options, kFile for a pin file.
  Search(const Program& program, const SearchOptions& options);
  ~Search();
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  /// Returns the next solution, or nothing: then ending() says why. Throws Error: kProgram for an error that
  /// an execution can come to, kUsage for a pin that matches no choice. After std::bad_alloc or an error the
  /// search cannot go on.
  std::optional<Solution> next();
  Ending ending() const;
  /// Returns why the search stopped, or would now: the options' token, or a limit of the search itself. Any
  /// thread may call this, and keep what it returns.
  StopToken stop_token() const;

  /// Tells the observer from now on; it has to live as long as the search, or until it is replaced by
  /// nullptr.
  void observe(SearchObserver* observer);

  /// Goes on after solutions that came from an earlier search with the same program and options, up to
  /// `count` of all. Only their choices count. Returns them, run again. To be called before next(). Throws
  /// Error (kFile) if one of them is no solution of this program.
  std::vector<Solution> resume(const std::vector<std::vector<Choice>>& earlier);

  /// Returns what the search came to. Any thread may call this.
  Summary summary() const;
  /// Returns the best solution found so far of those that only get better, and counts it as one that came.
  /// Any thread may call this, where it cannot wait for the search to end.
  std::optional<Solution> take_best_so_far();

  /// Writes what holds in the solutions that are left, as SMT-LIB (.smt2) or as clauses (.cnf), as the name
  /// ends. Throws Error (kFile).
  void write_formula(const std::filesystem::path& path);

  /// An input iterator, for loops over all that next() gives.
  class Iterator {
   public:
    explicit Iterator(Search* search) : search_(search) {
      if (search_ != nullptr) ++*this;
    }
    const Solution& operator*() const { return *solution_; }
    const Solution* operator->() const { return &*solution_; }
    Iterator& operator++() {
      solution_ = search_->next();
      return *this;
    }
    friend bool operator!=(const Iterator& a, const Iterator& b) {
      return a.solution_.has_value() != b.solution_.has_value();
    }

   private:
    Search* search_;
    std::optional<Solution> solution_;
  };
  Iterator begin() { return Iterator(this); }
  Iterator end() { return Iterator(nullptr); }

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace solitaire::api
