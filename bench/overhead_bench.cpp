// What the main job costs beside the solver: parsing, passes, encoding, replay and files, as a share of the
// whole.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include "bench/programs.h"
#include "engines/solve/tracing.h"
#include "library/freeze.h"
#include "library/scene_of.h"
#include "scene/assets.h"
#include "scene/gltf/writer.h"
#include "scene/page/drawing/plan.h"
#include "scene/scene.h"

namespace solitaire {
namespace {

constexpr int kSolutions = 8;

void write_scene(const Solution& solution, const SourceSet& sources, AssetLibrary& assets,
                 const std::filesystem::path& folder, int number) {
  const Scene scene =
      api::scene_of(api::frozen(solution, static_cast<std::uint64_t>(number), sources), "workspace", assets);
  write_glb(scene, folder / fmt::format("workspace-{}.glb", number));
  benchmark::DoNotOptimize(svg_plan(scene));
}

/// Eight solutions of workspace.sol with that many groups, each written as a scene.
void generate_workspace(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("solitaire-bench-{}", getpid());
  std::filesystem::create_directory(folder);
  double solving = 0;
  double whole = 0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    const auto start = StopSignal::Clock::now();
    const Program program = load_example("workspace.sol");
    TracingOptions options;
    options.seed = seed++;
    TracingEngine engine(program, {{"groups", Value(state.range(0))}}, options);
    AssetLibrary assets(kSourceFolder / "assets", program.folder());
    for (int i = 0; i < kSolutions; ++i) {
      const auto solution = engine.next();
      if (!solution) return state.SkipWithError("no solution");
      write_scene(*solution, program.sources, assets, folder, i);
    }
    whole += std::chrono::duration<double>(StopSignal::Clock::now() - start).count();
    solving += engine.times().solve;
  }
  state.counters["overhead_percent"] = 100 * (whole - solving) / whole;
  std::filesystem::remove_all(folder);
}
BENCHMARK(generate_workspace)->DenseRange(1, 4)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace solitaire
