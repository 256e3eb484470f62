#pragma once
#include <cstddef>
#include <cstdint>

// The constants of sampling by nested bounds; see engines/tuning.h for those of the other engines.
namespace solitaire::tuning {

/// Choices of which there are no more than so many are put into clusters (engines/count/nested/clusters.h)
/// that can be so many things at most. Of a condition that ties more than so many clusters it does not count
/// which. Judgement: a thing has some thousand places in a room, and more choices are never drawn in this
/// way.
constexpr std::size_t kMostChoicesInClusters = 256;
constexpr std::size_t kMostInCluster = 16'384;
constexpr std::size_t kMostClustersTied = 12;
/// The order of clusters is found from so many cases of each, in as many trials at most. Judgement.
constexpr std::size_t kCasesForOrder = 32;
constexpr std::size_t kTrialsForOrder = 100;
/// What the first and the last round of attempts take that prepare a NestedSampler, and those after which it
/// is given up if the bound does not fall any more; in units of about 3 nanoseconds. A workspace of one group
/// takes the first eight rounds, 12 s in all.
constexpr std::uint64_t kFirstWorkToPrepare = 10'000'000;
constexpr std::uint64_t kMostWorkToPrepare = 2'560'000'000;
constexpr std::uint64_t kWorkBeforeDoubt = 320'000'000;
/// It is given up, too, where all of that takes more, as where very many things can be in many places.
constexpr std::uint64_t kMostWorkInPreparing = 10'000'000'000;
/// A round that draws so many solutions is the last; and if the last one has more work for each solution than
/// that, about half a second, they are drawn from cells. Judgement.
constexpr std::uint64_t kManyDraws = 1000;
constexpr std::uint64_t kMostWorkToDraw = 200'000'000;
/// The cases of all places that are kept; each takes 16 bytes. Once there are so many, bounds stay as they
/// are, and there is nothing to prepare any more: it is settled by whether an attempt succeeds in a round of
/// so much work, which takes some tenths of a second.
constexpr std::size_t kMostCasesKept = 4'000'000;
constexpr std::uint64_t kWorkWithoutSuccess = 80'000'000;

}  // namespace solitaire::tuning
