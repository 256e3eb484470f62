// Which citations are of the same paper, and what it is called.
#include "bench/sampling/twins/restaurant.h"

namespace twins {
namespace {

constexpr std::size_t kCitations = 5;
constexpr int kDistance[kCitations][kCitations] = {
    {0, 3, 2, 21, 20}, {3, 0, 3, 22, 20}, {2, 3, 0, 20, 19}, {21, 22, 20, 0, 4}, {20, 20, 19, 4, 0}};

struct Citations {
  explicit Citations(RandomStream&) : papers(kCitations) {
    for (std::size_t i = 0; i < kCitations; ++i) title[i] = i;
  }
  double cited(std::size_t c) const { return -0.5 * kDistance[c][title[papers.seat(c)]]; }
  double apart(std::size_t a, std::size_t b) const {
    if (papers.seat(a) != a || papers.seat(b) != b) return 0;
    return -2.0 * std::max(0, 10 - kDistance[title[a]][title[b]]);
  }
  double score() const {
    double sum = 0;
    for (std::size_t c = 0; c < kCitations; ++c) sum += cited(c);
    for (std::size_t a = 0; a < kCitations; ++a)
      for (std::size_t b = a + 1; b < kCitations; ++b) sum += apart(a, b);
    return sum;
  }
  double shown() const { return papers.seat(0) == papers.seat(1) ? 1 : 0; }

  Restaurant papers;
  std::array<std::size_t, kCitations> title{};
};

struct CitationsRescoring : Citations {
  explicit CitationsRescoring(RandomStream& stream) : Citations(stream), present(score()) {}
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(2 * kCitations);
    const std::size_t i = which % kCitations, title_before = title[i], link_before = papers.link(i);
    if (which < kCitations) {
      title[i] = stream.below(kCitations);
    } else {
      papers.link(i, stream.below(i + 1));
    }
    const double proposed = score();
    if (accepts(proposed - present, stream)) {
      present = proposed;
      return;
    }
    title[i] = title_before;
    if (which >= kCitations) papers.link(i, link_before);
  }
  double present;
};

/// A title matters to the citations of its paper and to the pairs that the paper is in. A link can seat all
/// customers behind it anew, so there all is scored.
struct CitationsIncremental : Citations {
  using Citations::Citations;
  double score_of_title(std::size_t i) const {
    if (papers.seat(i) != i) return 0;
    double sum = 0;
    for (std::size_t c = i; c < kCitations; ++c)
      if (papers.seat(c) == i) sum += cited(c);
    for (std::size_t b = 0; b < kCitations; ++b)
      if (b != i) sum += apart(std::min(i, b), std::max(i, b));
    return sum;
  }
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(2 * kCitations);
    const std::size_t i = which % kCitations;
    if (which < kCitations) {
      const std::size_t before = title[i];
      const double present = score_of_title(i);
      title[i] = stream.below(kCitations);
      if (!accepts(score_of_title(i) - present, stream)) title[i] = before;
    } else {
      const std::size_t before = papers.link(i);
      const double present = score();
      papers.link(i, stream.below(i + 1));
      if (!accepts(score() - present, stream)) papers.link(i, before);
    }
  }
};

}  // namespace

void measure_citations(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<CitationsIncremental>("citations incremental", seed);
  measure.operator()<CitationsRescoring>("citations rescoring", seed);
}

}  // namespace twins
