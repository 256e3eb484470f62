#include "engines/sample/shred/slice_sampler.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engines/sample/coordinate.h"

namespace solitaire {
namespace {

/// An interval is at most so many widths long. Judgement: widths are learned, and a few are enough then.
constexpr int kMostWidths = 64;
/// After so many values in vain the interval is as small as rounding lets it be.
constexpr int kMostShrinks = 200;

}  // namespace

/// The density along a choice, all others being what they are, as a function of a float.
class SliceSampler::Line {
 public:
  Line(Kernel& kernel, ChoiceNumber choice, RandomStream& stream)
      : kernel_(kernel),
        choice_(choice),
        domain_(kernel.domain(choice)),
        coordinate_(domain_),
        present_(kernel.value(choice)),
        start_(start(stream)) {}

  double start() const { return start_; }
  double first_width() const { return is_float() ? 2 * usual_step(domain_) : 2; }
  Scalar present() const { return present_; }

  /// Nothing where the point lies past all values.
  std::optional<Scalar> value(double at) const {
    if (is_float()) return Scalar::of(coordinate_.value(at));
    const double number = std::floor(at);
    if (!(number >= 0) || number > static_cast<double>(domain_.hi - domain_.lo)) return std::nullopt;
    return Scalar::of(domain_.value(static_cast<std::uint64_t>(number)));
  }

  /// The logarithm of the density, less that at the start.
  double height(double at) {
    const std::optional<Scalar> there = value(at);
    if (!there) return -HUGE_VAL;
    if (bits_of(*there) == bits_of(present_)) return 0;
    if (kernel_.propose(choice_, *there) != Kernel::Outcome::kScored) return -HUGE_VAL;
    if (!is_float()) return kernel_.difference();
    return kernel_.difference() + coordinate_.log_derivative(there->f) -
           coordinate_.log_derivative(present_.f);
  }

 private:
  bool is_float() const { return domain_.type() == Type::kFloat; }
  double start(RandomStream& stream) const {
    if (is_float()) return coordinate_.of(present_.f);
    return static_cast<double>((present_.i - domain_.lo) / domain_.step) + stream.uniform();
  }

  Kernel& kernel_;
  ChoiceNumber choice_;
  Distribution domain_;
  Coordinate coordinate_;
  Scalar present_;
  double start_;
};

Scalar SliceSampler::draw(Kernel& kernel, ChoiceNumber choice, bool learns) {
  Line line(kernel, choice, stream_);
  const double level = std::log(stream_.uniform());
  Width& width = widths_[kernel.program().choices[choice].address];
  int growths = 0, shrinks = 0;
  Interval interval = around(line, level, line.first_width() * std::exp(width.log_factor), growths);
  Scalar found = line.present();
  for (; shrinks < kMostShrinks; ++shrinks) {
    const double at = interval.low + stream_.uniform() * (interval.high - interval.low);
    if (line.height(at) > level) {
      found = *line.value(at);
      break;
    }
    (at < line.start() ? interval.low : interval.high) = at;
  }
  if (learns) learn(width, growths, shrinks);
  return found;
}

/// Steps out from an interval that lies anywhere around the start, until both ends lie below the level. How
/// many steps each end may go is drawn, so that the interval is found as often from any of its points.
SliceSampler::Interval SliceSampler::around(Line& line, double level, double width, int& growths) {
  const double low = line.start() - width * stream_.uniform();
  Interval interval{low, low + width};
  const int down = static_cast<int>(stream_.below(kMostWidths));
  const int up = kMostWidths - 1 - down;
  for (int i = 0; i < down && line.height(interval.low) > level; ++i, ++growths) interval.low -= width;
  for (int i = 0; i < up && line.height(interval.high) > level; ++i, ++growths) interval.high += width;
  return interval;
}

/// By the method of Robbins and Monro.
void SliceSampler::learn(Width& width, int growths, int shrinks) {
  width.told += 1;
  const double more = std::clamp(growths - shrinks, -2, 2);
  width.log_factor = std::clamp(width.log_factor + more / std::sqrt(width.told), -40.0, 40.0);
}

}  // namespace solitaire
