// Topics of documents: two of them (latent Dirichlet allocation), or any number (a hierarchical Dirichlet
// process). Weights are unknowns above 0, whose shares are the probabilities; with a gamma distribution of
// shape 1 each, these have a Dirichlet distribution of ones.
#include "bench/sampling/twins/restaurant.h"

namespace twins {
namespace {

constexpr std::size_t kDocuments = 21, kWords = 20, kTopics = 2, kVocabulary = 4;

struct Topics {
  explicit Topics(RandomStream& stream) {
    for (std::size_t d = 0; d < kDocuments; ++d) {
      for (std::size_t i = 0; i < kWords; ++i) {
        const std::size_t share = d / 7 == 0 ? 9 : (d / 7 == 1 ? 5 : 1);
        const bool first = ((7 * i + 3 * d) % 10 < share) != ((i + 2 * d) % 10 == 9);
        words[d][i] = (i + d) % 2 + (first ? 0 : 2);
        topic[d][i] = stream.below(kTopics);
      }
    }
    for (auto& weights : topics) weights.fill(1);
    for (auto& weights : mixes) weights.fill(1);
  }

  template <std::size_t n>
  static double log_share(const std::array<double, n>& weights, std::size_t which) {
    double sum = 0;
    for (const double each : weights) sum += each;
    return std::log(weights[which] / sum);
  }
  double word(std::size_t d, std::size_t i) const {
    return log_share(mixes[d], topic[d][i]) + log_share(topics[topic[d][i]], words[d][i]);
  }
  double document(std::size_t d) const {
    double sum = 0;
    for (std::size_t i = 0; i < kWords; ++i) sum += word(d, i);
    return sum;
  }
  double prior() const {
    double sum = 0;
    for (const auto& weights : topics)
      for (const double each : weights) sum -= each;
    for (const auto& weights : mixes)
      for (const double each : weights) sum -= each;
    return sum;
  }

  static constexpr std::size_t kOfTopics = kTopics * kVocabulary;
  static constexpr std::size_t kOfMixes = kDocuments * kTopics;
  static constexpr std::size_t kUnknowns = kOfTopics + kOfMixes + kDocuments * kWords;

  double& weight(std::size_t which) {
    if (which < kOfTopics) return topics[which / kVocabulary][which % kVocabulary];
    which -= kOfTopics;
    return mixes[which / kTopics][which % kTopics];
  }
  double shown() const { return topics[0][0] + topics[0][1]; }

  std::size_t words[kDocuments][kWords], topic[kDocuments][kWords];
  std::array<std::array<double, kVocabulary>, kTopics> topics{};
  std::array<std::array<double, kTopics>, kDocuments> mixes{};
};

struct TopicsRescoring : Topics {
  explicit TopicsRescoring(RandomStream& stream) : Topics(stream), present(score()) {}
  double score() const {
    double sum = prior();
    for (std::size_t d = 0; d < kDocuments; ++d) sum += document(d);
    return sum;
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(kUnknowns);
    if (which < kOfTopics + kOfMixes) {
      double& weight = this->weight(which);
      const double before = weight, walk = 0.5 * draw_normal(stream);
      weight *= std::exp(walk);
      take(walk, stream, [&] { weight = before; });
    } else {
      const std::size_t word = which - kOfTopics - kOfMixes;
      std::size_t& topic_of_word = topic[word / kWords][word % kWords];
      topic_of_word ^= 1;
      take(0, stream, [&] { topic_of_word ^= 1; });
    }
  }
  template <class Undo>
  void take(double ways, RandomStream& stream, Undo undo) {
    const double proposed = score();
    if (accepts(proposed - present + ways, stream)) {
      present = proposed;
    } else {
      undo();
    }
  }
  double present;
};

/// Counts say how often a topic has each word, and how often a document has each topic.
struct TopicsIncremental : Topics {
  explicit TopicsIncremental(RandomStream& stream) : Topics(stream) {
    for (std::size_t d = 0; d < kDocuments; ++d)
      for (std::size_t i = 0; i < kWords; ++i) count(d, i, 1);
  }
  void count(std::size_t d, std::size_t i, double by) {
    of_topic[topic[d][i]][words[d][i]] += by;
    of_document[d][topic[d][i]] += by;
  }
  /// The terms of one list of weights, with how often each was drawn.
  template <std::size_t n>
  static double score(const std::array<double, n>& weights, const std::array<double, n>& counts) {
    double sum = 0, all = 0, log = 0;
    for (std::size_t k = 0; k < n; ++k) {
      sum += weights[k];
      all += counts[k];
      log += counts[k] * std::log(weights[k]) - weights[k];
    }
    return log - all * std::log(sum);
  }
  double score_around(std::size_t which) const {
    if (which < kOfTopics) return score(topics[which / kVocabulary], of_topic[which / kVocabulary]);
    const std::size_t d = (which - kOfTopics) / kTopics;
    return score(mixes[d], of_document[d]);
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(kUnknowns);
    if (which < kOfTopics + kOfMixes) {
      double& weight = this->weight(which);
      const double before = weight, walk = 0.5 * draw_normal(stream), present = score_around(which);
      weight *= std::exp(walk);
      if (!accepts(score_around(which) - present + walk, stream)) weight = before;
      return;
    }
    const std::size_t word = which - kOfTopics - kOfMixes, d = word / kWords, i = word % kWords;
    const double present = this->word(d, i);
    topic[d][i] ^= 1;
    const bool accepted = accepts(this->word(d, i) - present, stream);
    topic[d][i] ^= 1;
    if (!accepted) return;
    count(d, i, -1);
    topic[d][i] ^= 1;
    count(d, i, 1);
  }
  std::array<std::array<double, kVocabulary>, kTopics> of_topic{};
  std::array<std::array<double, kTopics>, kDocuments> of_document{};
};

/// Two documents of five words together, so that little is left to be had by scoring less.
struct AnyTopics {
  static constexpr std::size_t kAll = 5, kFirst = 3;
  static constexpr std::size_t kSeen[kAll] = {0, 0, 1, 2, 3};

  explicit AnyTopics(RandomStream&)
      : dish(kAll), seats{Restaurant(kFirst), Restaurant(kAll - kFirst)}, present(score()) {}
  std::size_t topic(std::size_t word) const {
    return dish.seat(word < kFirst ? seats[0].seat(word) : kFirst + seats[1].seat(word - kFirst));
  }
  double score() const {
    double sum = 0;
    for (const auto& each : topics) sum += each.log_prior();
    for (std::size_t i = 0; i < kAll; ++i) sum += topics[topic(i)].log_share(kSeen[i]);
    return sum;
  }
  void step(RandomStream& stream) {
    std::uint64_t which = stream.below(kAll * kVocabulary + 2 * kAll);
    if (which < kAll * kVocabulary) {
      double& weight = topics[which / kVocabulary].weights[which % kVocabulary];
      const double before = weight, walk = 0.6 * draw_normal(stream);
      weight *= std::exp(walk);
      return take(walk, stream, [&] { weight = before; });
    }
    which -= kAll * kVocabulary;
    if (which < kAll) return link(dish, which, stream);
    which -= kAll;
    if (which < kFirst) return link(seats[0], which, stream);
    link(seats[1], which - kFirst, stream);
  }
  void link(Restaurant& restaurant, std::size_t customer, RandomStream& stream) {
    const std::size_t before = restaurant.link(customer);
    restaurant.link(customer, stream.below(customer + 1));
    take(0, stream, [&] { restaurant.link(customer, before); });
  }
  template <class Undo>
  void take(double ways, RandomStream& stream, Undo undo) {
    const double proposed = score();
    if (accepts(proposed - present + ways, stream)) {
      present = proposed;
    } else {
      undo();
    }
  }
  double shown() const { return topic(0) == topic(1) ? 1 : 0; }

  Restaurant dish;
  std::array<Restaurant, 2> seats;
  std::array<SimplexWeights<kVocabulary>, kAll> topics;
  double present;
};

}  // namespace

void measure_topics(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<TopicsIncremental>("lda incremental", seed);
  measure.operator()<TopicsRescoring>("lda rescoring", seed);
  measure.operator()<AnyTopics>("hdp rescoring", seed);
}

}  // namespace twins
