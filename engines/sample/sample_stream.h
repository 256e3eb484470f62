#pragma once
#include "engines/sample/shred/shred.h"
#include "engines/solution_stream.h"

namespace solitaire {

/// Executions of a program as solutions, drawn by how probable they are. A solution may come again, as often
/// as it is probable. Each is run, and its density compared with the one that the chain has for it.
class SampleStream : public SolutionStream, public Timed {
 public:
  /// The program has to outlive the stream.
  SampleStream(const Program& program, ParamValues params, const Limits& limits, std::uint64_t seed);

  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  EngineTimes times() const override { return times_; }

 private:
  void sweep(std::uint64_t times);
  Solution solution();

  const Program& program_;
  ParamValues params_;
  Limits limits_;
  std::uint64_t seed_;
  std::unique_ptr<ShredChain> chain_;
  Ending ending_ = Ending::kNone;
  EngineTimes times_;
};

}  // namespace solitaire
