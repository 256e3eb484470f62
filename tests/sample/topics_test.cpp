// Topics of two tiny documents, with two topics (LDA) and with any number of them (HDP), against sums over
// all assignments of words to topics, in which the distributions of topics and words are integrated in closed
// form.
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <map>

#include "engines/sample/diagnostics/draw_summary.h"
#include "engines/sample/sampling.h"
#include "tests/sample/enumeration.h"

namespace solitaire {
namespace {

const std::vector<int> kWords = {0, 0, 1, 2, 3};
constexpr std::size_t kOfFirst = 3;  // words of the first document
constexpr const char* kDocuments = "documents = [[0, 0, 1], [2, 3]];\n";

/// log of the probability of draws from a distribution that has a Dirichlet distribution of ones, with so
/// many parts; `counts` says how often each part was drawn.
double log_marginal(const std::map<int, int>& counts, int parts) {
  double log = std::lgamma(parts);
  int all = 0;
  for (const auto& [part, count] : counts) {
    log += std::lgamma(count + 1);
    all += count;
  }
  return log - std::lgamma(parts + all);
}

double log_words(const std::vector<int>& topics) {
  std::map<int, std::map<int, int>> words;
  for (std::size_t i = 0; i < kWords.size(); ++i) ++words[topics[i]][kWords[i]];
  double log = 0;
  for (const auto& [topic, counts] : words) log += log_marginal(counts, 4);
  return log;
}

/// The pairs of words whose having one topic is returned.
constexpr std::pair<std::size_t, std::size_t> kPairs[] = {{0, 1}, {0, 2}, {0, 3}, {3, 4}};

class PairShares {
 public:
  void add(const std::vector<int>& topics, double log_weight) {
    const double weight = std::exp(log_weight + log_words(topics));
    all_ += weight;
    for (std::size_t i = 0; i < 4; ++i)
      if (topics[kPairs[i].first] == topics[kPairs[i].second]) together_[i] += weight;
  }
  double operator[](std::size_t pair) const { return together_[pair] / all_; }

 private:
  double all_ = 0;
  double together_[4] = {};
};

/// Calls with each list of links, of which the i-th is from 0 to i, and with what the process makes of it:
/// the table of each customer. All links but one to a table of one's own are alike, as alpha is 1: so are all
/// lists.
void each_seating(std::size_t customers, const std::function<void(const std::vector<int>&)>& call) {
  std::vector<int> seats;
  const std::function<void()> seat_next = [&] {
    if (seats.size() == customers) return call(seats);
    const auto own = static_cast<int>(seats.size());
    for (int link = 0; link <= own; ++link) {
      seats.push_back(link == own ? own : seats[static_cast<std::size_t>(link)]);
      seat_next();
      seats.pop_back();
    }
  };
  seat_next();
}

PairShares of_two_topics() {
  PairShares shares;
  for (int bits = 0; bits < 32; ++bits) {
    std::vector<int> topics;
    std::map<int, int> first, second;
    for (std::size_t i = 0; i < kWords.size(); ++i) {
      topics.push_back((bits >> i) & 1);
      ++(i < kOfFirst ? first : second)[topics.back()];
    }
    shares.add(topics, log_marginal(first, 2) + log_marginal(second, 2));
  }
  return shares;
}

PairShares of_any_topics() {
  PairShares shares;
  each_seating(kWords.size(), [&](const std::vector<int>& dish) {
    each_seating(kOfFirst, [&](const std::vector<int>& first) {
      each_seating(kWords.size() - kOfFirst, [&](const std::vector<int>& second) {
        std::vector<int> topics;
        for (const int table : first) topics.push_back(dish[static_cast<std::size_t>(table)]);
        for (const int table : second) topics.push_back(dish[kOfFirst + static_cast<std::size_t>(table)]);
        shares.add(topics, 0);
      });
    });
  });
  return shares;
}

constexpr const char* kTwoTopics =
    "topics = [dirichlet([1, 1, 1, 1]) for k in 0..1]; served = [];\n"
    "for words in documents {\n"
    "  mix = dirichlet([1, 1]);\n"
    "  for w in words { t = categorical(mix); observe(Categorical(topics[t]), w); served = served + [t]; }\n"
    "}\n";

constexpr const char* kAnyTopics =
    "import \"std/process.sol\";\n"
    "dish = crp(5, 1.0); topics = [dirichlet([1, 1, 1, 1]) for i in 1..5]; served = []; before = 0;\n"
    "for words in documents {\n"
    "  seat = crp(length(words), 1.0);\n"
    "  for i in 0..length(words) - 1 {\n"
    "    t = dish[before + seat[i]]; observe(Categorical(topics[t]), words[i]); served = served + [t];\n"
    "  }\n"
    "  before += length(words);\n"
    "}\n";

void check_shares(const std::string& text, SamplingOptions::Engine engine, std::uint64_t draws,
                  const PairShares& exact) {
  const Program program = sampled_program(text +
                                          "return served[0] == served[1], served[0] == served[2], served[0] "
                                          "== served[3], served[3] == served[4];");
  const ParamValues params;
  SamplingOptions options;
  options.engine = engine;
  options.seed = 3;
  options.warmup = 300;
  options.draws = draws;
  const DrawTable table = run_chains({{&program, &params}}, options, 1, {[] {}})[0].draws;
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(table.names()[i]);
    const DrawSummary found = summarize({table.column(table.names()[i])});
    CAPTURE(found.mean);
    CHECK(std::abs(found.mean - exact[i]) < 4 * found.mcse);
    CHECK(found.ess_bulk > 100);
  }
}

TEST_CASE("topics: two of them, as by summing over all assignments") {
  const std::string text = std::string(kDocuments) + kTwoTopics;
  check_shares(text, SamplingOptions::Engine::kShred, 4000, of_two_topics());
  check_shares(text, SamplingOptions::Engine::kLightweight, 2000, of_two_topics());
}

TEST_CASE("topics: any number of them, as by summing over all seatings") {
  const std::size_t end = std::string(kAnyTopics).find('\n') + 1;
  const std::string any = kAnyTopics;
  const std::string text = any.substr(0, end) + kDocuments + any.substr(end);
  check_shares(text, SamplingOptions::Engine::kShred, 3000, of_any_topics());
}

}  // namespace
}  // namespace solitaire
