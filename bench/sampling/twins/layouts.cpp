// Two layouts of bench/sampling/layouts/, whose density is a number of wishes that are not met.
#include <array>

#include "bench/sampling/twins/measure.h"

namespace twins {
namespace {

constexpr double kWeight = 10;

struct PlatformIncremental {
  static constexpr std::size_t kPlatforms = 5;

  explicit PlatformIncremental(RandomStream&) {
    for (std::size_t i = 1; i <= kPlatforms; ++i) {
      gap[i] = 2;
      w[i] = 2;
      y[i] = static_cast<int>(1 + i % 2);
    }
  }
  /// Wishes that are not met of the jump to a platform.
  int jump(std::size_t to) const {
    const int rise = y[to] - y[to - 1];
    return (rise > 2 ? 1 : 0) + (rise == 0 ? 1 : 0) + (gap[to] == 4 && rise > 0 ? 1 : 0);
  }
  int end() const { return length < 22 || length > 26 ? 1 : 0; }
  int jumps_of(std::size_t i) const { return jump(i) + (i < kPlatforms ? jump(i + 1) : 0); }

  template <class Score>
  void take(int& changed, int value, Score score, RandomStream& stream) {
    const int before = changed, present = score();
    changed = value;
    if (!accepts(kWeight * (present - score()), stream)) changed = before;
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(3 * kPlatforms), i = 1 + which / 3;
    if (which % 3 == 0) return change_length(gap[i], 1 + static_cast<int>(stream.below(4)), i, stream);
    if (which % 3 == 1) return change_length(w[i], 1 + static_cast<int>(stream.below(3)), i, stream);
    take(
        y[i], static_cast<int>(stream.below(7)), [&] { return jumps_of(i); }, stream);
  }
  void change_length(int& changed, int value, std::size_t i, RandomStream& stream) {
    const int before = changed;
    const int present = jump(i) + end();
    length += value - before;
    changed = value;
    if (accepts(kWeight * (present - jump(i) - end()), stream)) return;
    length -= value - before;
    changed = before;
  }
  double shown() const { return length; }

  std::array<int, kPlatforms + 1> gap{}, w{0, 2, 2, 2, 2, 2}, y{1};
  int length = 2 + 4 * kPlatforms;
};

struct WorkspaceRescoring {
  static constexpr std::size_t kGroups = 3, kOfGroup = 8, kShelves = 8;
  static constexpr std::size_t kThings = kGroups * kOfGroup + kShelves;

  struct Thing {
    int x = 0, y = 0, w = 0, d = 0;
  };

  explicit WorkspaceRescoring(RandomStream& stream) {
    for (std::size_t i = 0; i < kThings; ++i) {
      Thing& made = things[i];
      made.x = static_cast<int>(stream.below(40));
      made.y = static_cast<int>(stream.below(40));
      const bool is_chair = i < kGroups * kOfGroup && i % kOfGroup >= 2 && i % kOfGroup < 6;
      made.w = is_chair ? 2 : (i < kGroups * kOfGroup ? 6 : 4);
      made.d = is_chair ? 2 : (i < kGroups * kOfGroup ? 3 : 1);
    }
    present = score();
  }
  static bool apart(const Thing& a, const Thing& b) {
    return a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.d <= b.y || b.y + b.d <= a.y;
  }
  static bool near(const Thing& a, const Thing& b) {
    return a.x <= b.x + b.w + 1 && b.x <= a.x + a.w + 1 && a.y <= b.y + b.d + 1 && b.y <= a.y + a.d + 1;
  }
  int score() const {
    int broken = 0;
    for (std::size_t i = 0; i < kThings; ++i) {
      const Thing& a = things[i];
      if (a.x + a.w > wide || a.y + a.d > deep) ++broken;
      for (std::size_t j = i + 1; j < kThings; ++j)
        if (!apart(a, things[j])) ++broken;
    }
    for (std::size_t group = 0; group < kGroups; ++group)
      for (std::size_t seat = 0; seat < 6; ++seat)
        if (!near(things[group * kOfGroup + 2 + seat], things[group * kOfGroup + seat % 2])) ++broken;
    return broken;
  }
  void step(RandomStream& stream) {
    const std::size_t which = stream.below(3 * kThings + 2);
    if (which >= 3 * kThings) {
      int& side = which == 3 * kThings ? wide : deep;
      const int before = side;
      side = 20 + static_cast<int>(stream.below(21));
      return take(stream, [&] { side = before; });
    }
    Thing& changed = things[which / 3];
    const Thing before = changed;
    if (which % 3 == 0) changed.x = static_cast<int>(stream.below(40));
    if (which % 3 == 1) changed.y = static_cast<int>(stream.below(40));
    if (which % 3 == 2) std::swap(changed.w, changed.d);
    take(stream, [&] { changed = before; });
  }
  template <class Undo>
  void take(RandomStream& stream, Undo undo) {
    const int proposed = score();
    if (accepts(kWeight * (present - proposed), stream)) {
      present = proposed;
    } else {
      undo();
    }
  }
  double shown() const { return wide; }

  std::array<Thing, kThings> things;
  int wide = 30, deep = 30;
  int present = 0;
};

}  // namespace

void measure_layouts(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<PlatformIncremental>("platform incremental", seed);
  measure.operator()<WorkspaceRescoring>("workspace rescoring", seed);
}

}  // namespace twins
