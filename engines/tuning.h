#pragma once
#include <cstddef>
#include <cstdint>

// The constants of the engines that were tuned, or chosen by judgement. Each says what it decides and where
// it comes from: a table of docs/engine.md, a publication, or judgement, where nobody has measured. What a
// proof or a format fixes (such as CellSampler::kSlots) stands where it is used.
namespace solitaire::tuning {

// Distances (engines/distance.h).

/// The distance of the nearest two out of a set is given up after comparing so many names: about a tenth of a
/// second.
constexpr std::uint64_t kNamesCompared = 20'000'000;

// Exploration (engines/solve/executions/explore.h).

/// Branch sides that the first passes, and each later one, may open without being asked. Judgement: most
/// programs are covered at once, and a pass of as many sides takes well under a second.
constexpr std::size_t kUnaskedSides = 4000;
/// Levels of undecided branches that the first pass opens; each further pass opens four times as many.
/// Judgement, as is the factor.
constexpr std::uint32_t kFirstLevels = 4;
constexpr std::uint32_t kLevelGrowth = 4;
constexpr std::uint32_t kMostLevels = 1U << 20;  // deeper than any program that can be solved
/// Levels that come with the first sides that are opened because a core asks for it; the number doubles each
/// time. Judgement.
constexpr std::uint32_t kFirstGrant = 8;
/// Steps, and calls within each other, that a path of only some executions may take before it is cut, and the
/// factor by which both grow when a core names a cut. Judgement: far more than layouts need, and soon over
/// where a loop has no end.
constexpr std::uint64_t kFuelSteps = 100'000;
constexpr std::uint32_t kFuelDepth = 200;
constexpr std::uint32_t kFuelGrowth = 4;
/// The search for rooms that are over-full looks at so many things in windows at most for each group of
/// things, and at no longer windows, so that areas stay within 62 bits. Judgement: that takes some
/// milliseconds.
constexpr std::size_t kMostWindowWork = 1'000'000;
constexpr std::int64_t kLongestWindow = 1'000'000'000;
/// Permutations are looked for among so many pairs of ints that differ, with so many looks at whether two
/// differ, and said in so many equations in all. Judgement: that takes some hundredths of a second.
constexpr std::size_t kMostPermutationPairs = 20'000;
constexpr std::size_t kMostPermutationWork = 300'000;
constexpr std::size_t kMostPermutationEquations = 25'000;
/// The sums that are looked at for some that ask for too much have so many terms at most, by themselves and
/// in all, and ranges are narrowed so often. Judgement: reading as many takes some milliseconds.
constexpr std::size_t kMostLinearTerms = 20'000;
constexpr std::size_t kMostNarrowings = 8;
/// Before a contradiction is looked for, a point at which all sums hold is, in so many rounds. Judgement:
/// where there is one, ten are mostly enough, and a round takes as long as reading the sums.
constexpr std::size_t kMostRelaxations = 50;
/// Passes after which a program counts as one with endlessly many paths. Judgement.
constexpr std::size_t kMostPasses = 200;
/// Passes that look for choices which a pin names before the pin counts as wrong. Judgement.
constexpr std::size_t kPassesForPins = 8;

// Different solutions (engines/solve/executions/exclusion.h, series.h, symmetry.h).

/// The solver is told of every known solution once more than a quarter of them, and of this number of others,
/// came again. docs/engine.md, "Different solutions", has what a solution costs after 10, 100 and more.
constexpr std::size_t kRepeatsWorthTelling = 4;
constexpr std::size_t kFewKnown = 16;
/// A block of solutions does not know what is found in this number of blocks before it, so one more than that
/// can be worked on at a time. Judgement: machines with up to eight processors are kept busy.
constexpr std::size_t kUnknownBlocks = 7;
/// The sizes of the first blocks, 4, 8 and 16, so that few solutions, too, are found side by side; and the
/// least and usual size of the later ones. Those grow with the number of solutions before them, to an eighth
/// of it, or a quarter where blocks follow one another, so that starting anew stays a small part of the work.
/// Judgement.
constexpr std::size_t kFirstBlock = 4;
constexpr std::size_t kSmallBlocks = 3;
constexpr std::size_t kUsualBlock = 32;
constexpr std::size_t kBlockShare = 8;
constexpr std::size_t kBestFirstBlockShare = 4;
/// At the first of these numbers of solutions, and whenever there are so many times as many, a series looks
/// whether there are few in all: at most so many times as many as came, out of at most so many times as many
/// combinations of values. Then it goes through the rest. Of 10,000 solutions it does from the 2,300th on;
/// all of them took 3.5 s, and take 0.2 s.
constexpr std::size_t kFirstLookForFew = 256;
constexpr std::size_t kLookForFewGrowth = 8;
constexpr std::size_t kFewSolutions = 8;
constexpr std::size_t kMostCombinations = 8;
/// A solution that is nearer than this to another one (the second where they are to be far apart) is put
/// aside, as long as no more than so many are, among so many solutions that come first. docs/engine.md,
/// "Random values", has what that does.
constexpr double kNearSolutions = 0.3;
constexpr double kNearFarApart = 0.6;
constexpr std::size_t kMostAside = 16;
constexpr std::size_t kKeptApart = 64;
/// Nodes that the search for symmetries looks at in all: some seconds of work.
constexpr std::size_t kMostNodesForSymmetry = 20'000'000;

// Explanations (engines/explain/, engines/solve/executions/provenance.h, wide_choices.h).

/// The search for what depends on choices lets them lie outside of their ranges: by this many times the span
/// of the range, at least by kLeastReach, and at most by kMostReach, since products of larger values would
/// grow past 62 bits. Judgement, like kProvenanceReach, which is more than most lengths that a layout
/// compares with.
constexpr std::int64_t kReachInSpans = 4;
constexpr std::int64_t kLeastReach = 64;
constexpr std::int64_t kMostReach = std::int64_t{1} << 28;
constexpr std::int64_t kProvenanceReach = 4096;
/// A core of so many conditions is first looked for by the places of the text at which they stand. Judgement:
/// a question about single conditions is dear where they are hundreds.
constexpr std::size_t kManyConditions = 64;
/// Conflicts of the search after which the question whether a member of a conflict can be left out is put
/// off, after how many of these the members stay as they are where they are many, and the effort for the
/// ranges of such. Judgement: some tenths of a second, and some seconds in all.
constexpr std::uint64_t kEffortForMember = 2000;
constexpr std::size_t kMostOpenMembers = 8;
constexpr std::uint64_t kEffortForEnds = 10'000;
/// Only the least and the greatest value are looked for of a choice with more values. Judgement: each value
/// costs a question.
constexpr std::uint64_t kMostValuesListed = 256;
/// Different solutions that are looked at before single values are asked for: they show most values that
/// occur. Judgement.
constexpr std::uint64_t kSamplesOfValues = 16;

// Counting and sampling (engines/count/).

/// The most that is listed of what a part of the choices can be, rather than estimated or drawn from cells.
/// Judgement: listing as many takes seconds at the most (docs/engine.md, "Sampling and counting").
constexpr std::uint64_t kMostListedToCount = 20'000;
constexpr std::uint64_t kMostListedToSample = 10'000;
/// So many times as many may be gone through without being kept, which takes no longer than to list them as
/// solutions. An estimate takes some seconds, in which mostly more are gone through.
constexpr std::uint64_t kGoneThroughForOneListed = 10;
/// Up to so many models are listed, even where an estimate is asked for, because an estimate needs more than
/// a few.
constexpr std::uint64_t kFewModels = 64;
/// Models that a trial cell has at most on the average. The bound of xor_sampler.h holds for any number below
/// kMostInCell; a larger one makes trials longer, and a smaller one makes more of them necessary. Judgement.
constexpr std::size_t kModelsInTrialCell = 10;
/// Draws in vain that are no reason yet to list all that is left, however little that is. Judgement.
constexpr double kFewDraws = 1000;

// Sampling by Markov chains (engines/sample/).

/// Executions that are drawn to find one to start from. Judgement: a program of which fewer are possible is
/// better said in another way.
constexpr std::uint64_t kMostStarts = 10'000;
/// Possible executions that are drawn for a start, of which the best one is taken. Judgement.
constexpr std::size_t kStartsCompared = 20;
/// A choice with more values than this is not drawn by comparing all of them. Judgement.
constexpr std::uint64_t kMostValuesCompared = 64;
/// Of more floats variances alone are learned: to learn their covariances takes longer than a warm-up.
/// Judgement.
constexpr std::size_t kMostCovariances = 30;
/// Traces of so many paths are kept. Judgement: each takes some kilobytes for each choice.
constexpr std::size_t kMostTraces = 256;
/// A step that leaves its path is tried on at most so many others before the program is run. Judgement: to
/// find that a path is another one takes a hundredth of a run.
constexpr std::size_t kMostPassages = 8;
/// Of the steps that were made by running the program and refused, one in so many is traced. Judgement: to
/// trace takes as long as some runs.
constexpr std::uint64_t kStepsToTrace = 10;
/// An execution is run anew after so many sweeps, to compare its density with that of the trace.
constexpr std::uint64_t kSweepsBetweenChecks = 1000;
/// A trace's density and that of the execution agree to so much of their size: sums differ in their order.
constexpr double kDensityTolerance = 1e-9;
/// Of a chain that makes scenes: sweeps before the first, and from one to the next. Judgement: nobody looks
/// at how much neighbours depend on each other as closely as at means.
constexpr std::uint64_t kSceneWarmup = 1000;
constexpr std::uint64_t kSceneSweeps = 50;
/// Above this split R-hat chains do not agree, and below this effective size quantiles are not to be trusted
/// (Vehtari and others 2021, section 4).
constexpr double kMostRHat = 1.01;
constexpr double kLeastEffective = 400;

// The published way (engines/thesis/).

/// The dissertation's "all values represented as 16-bit integers" (section 4.2.1).
constexpr unsigned kPublishedWidth = 16;

/// Conflicts of the search after which the question for a better solution is given up at first, and by how
/// much more it gets once all such questions have been given up. Judgement: some tenths of a second.
constexpr std::uint64_t kEffortForBetter = 5000;
constexpr std::uint64_t kEffortGrowth = 4;
constexpr std::uint64_t kMostEffortForBetter = std::uint64_t{1} << 40;  // no solver comes to that

/// A cost of so many terms is looked into by cores, if each term has so few steps. Judgement.
constexpr std::size_t kManyCosts = 8;
constexpr std::int64_t kMostStepsOfCost = 64;

/// Conflicts of the search after which the question whether a near miss can come nearer is given up.
constexpr std::uint64_t kEffortForNearness = 2000;

/// How many solutions that look like earlier ones an enumeration passes over, beside one for each that does
/// not, before it asks a solver for what looks different.
inline constexpr std::size_t kMostAlikePassedOver = 30;

}  // namespace solitaire::tuning
