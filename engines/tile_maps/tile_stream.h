#pragma once
#include <map>
#include <memory>
#include <string>

#include "engines/solution_stream.h"
#include "engines/solve/executions/traced_program.h"
#include "engines/tile_maps/derived_choices.h"
#include "engines/tiles/model/problem.h"

namespace solitaire {

/// Solutions of a program with maps of tiles (std/tiles.sol), in which the maps are sampled: they look like
/// their exemplars. A solver finds a solution; then the sites of its maps are redrawn by windows, from what
/// the exemplar says of maps, given that the program accepts them. All other choices stay as the solver found
/// them, anew for each solution. Each solution is run.
///
/// Maps that break an assert are put back, as rules about a whole map are (engines/tiles/sample). Solutions
/// are drawn independently of each other, and one may come again.
class TileStream : public SolutionStream, public Exploring, public Timed {
 public:
  /// The program has to outlive the stream.
  TileStream(const Program& program, ParamValues params, const TracingOptions& options);

  /// Throws NoTileMap if the solution that was found has no map, and UnequalSolutions if the program has
  /// wishes.
  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  void explore() override { traced_.explore(); }
  std::size_t graph_size() const override { return traced_.graph().size(); }
  EngineTimes times() const override { return traced_.times(); }

 private:
  ExecutionSolver::Outcome find();
  Solution sampled();
  std::vector<NodeId> conditions_beside_pairs();
  void redraw_maps(const Execution& start, LiveConditions& conditions, Valuation& values);
  void redraw(const TileMap& map, std::uint64_t number, const Execution& start, LiveConditions& conditions,
              const DerivedChoices& derived, Valuation& values);
  std::shared_ptr<const tiles::Style> style_of(const Value& source);
  /// Returns the variable of each choice that the execution of these values meets, by address.
  std::map<AddressId, NodeId> variables_of(Assignment& assignment) const;

  const Program& program_;
  TracingOptions options_;
  TracedProgram traced_;
  std::map<std::string, std::shared_ptr<const tiles::Style>> styles_;  // by the text of their source
  std::map<AddressId, NodeId> variables_;                              // of the present solution
  std::uint64_t number_ = 0;                                           // of the next solution
  Ending ending_ = Ending::kNone;
};

}  // namespace solitaire
