#include "problems/path/curve/svg_path_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/toml/number_rules.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::size_t kMostSegments = 20'000;
constexpr std::string_view kCommands = "MZLHVCSQTA";
constexpr std::array<int, 10> kArguments{2, 0, 2, 1, 1, 6, 4, 4, 2, 7};

Vec2d mix(const Vec2d& from, const Vec2d& to, double share) {
  return from + share * (to - from);
}

PathSegment line(const Vec2d& from, const Vec2d& to) {
  return {PathSegment::Kind::line, from, to, {}, {}, {}};
}

PathSegment cubic(const Vec2d& from, const Vec2d& a, const Vec2d& b, const Vec2d& to) {
  return {PathSegment::Kind::cubic, from, to, a, b, {}};
}

PathSegment quadratic(const Vec2d& from, const Vec2d& control, const Vec2d& to) {
  return cubic(from, mix(from, control, 2.0 / 3), mix(to, control, 2.0 / 3), to);
}

/// From the two ends of an elliptic arc to its centre: SVG 1.1, appendix F.6.5 and F.6.6. Radii
/// that are too short are enlarged; without radii it is a line.
PathSegment arc(const Vec2d& from, const Vec2d& to, Vec2d radii, double axis, bool large,
                bool positive) {
  radii = {std::abs(radii.x), std::abs(radii.y)};
  if (radii.x < kLeastMagnitude || radii.y < kLeastMagnitude || from == to) return line(from, to);
  const Vec2d turn = unit_vector(axis);
  const Vec2d half = conj(turn) * (0.5 * (from - to));
  Vec2d unit{half.x / radii.x,
             half.y / radii.y};  // half the chord where the arc is of a unit circle
  const double reach = std::sqrt(squared_norm(unit));
  if (!(reach >= kLeastMagnitude)) return line(from, to);
  if (reach > 1) {
    radii = reach * radii;
    unit = (1 / reach) * unit;
  }
  const double square = std::min(1.0, squared_norm(unit));
  const double away = std::sqrt((1 - square) / square) * (large == positive ? -1 : 1);
  const Vec2d centre{away * unit.y, -away * unit.x};
  const Vec2d first = unit - centre, last = Vec2d{-unit.x, -unit.y} - centre;
  const double start = std::atan2(first.y, first.x);
  double sweep = std::atan2(last.y, last.x) - start;
  if (positive && sweep < 0) sweep += kTurn;
  if (!positive && sweep > 0) sweep -= kTurn;
  const Vec2d middle = mix(from, to, 0.5);
  return {.kind = PathSegment::Kind::arc,
          .from = from,
          .to = to,
          .a = radii.x * turn,
          .b = radii.y * perp(turn),
          .centre = middle + turn * Vec2d{radii.x * centre.x, radii.y * centre.y},
          .start = start,
          .sweep = sweep};
}

bool is_among(char c, std::string_view all) {
  return all.find(c) != std::string_view::npos;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  tl::expected<std::vector<Subpath>, PathDataFault> take() {
    for (skip_space(); !fault_ && next_ < text_.size(); skip_space()) command();
    if (fault_) return tl::unexpected(*fault_);
    std::erase_if(subpaths_, [](const Subpath& subpath) { return subpath.segments.empty(); });
    return std::move(subpaths_);
  }

 private:
  using Arguments = std::array<double, 7>;

  void fail(std::size_t offset, std::string message) {
    if (!fault_) fault_ = PathDataFault{offset, std::move(message)};
  }

  void skip_space() {
    while (next_ < text_.size() && is_among(text_[next_], " \t\n\r\f")) ++next_;
  }

  void skip_comma() {
    skip_space();
    if (next_ == text_.size() || text_[next_] != ',') return;
    ++next_;
    skip_space();
  }

  /// Whether a number begins at `at`: infinities and the like do not.
  bool number_begins(std::size_t at) const {
    if (at < text_.size() && (text_[at] == '+' || text_[at] == '-')) ++at;
    if (at < text_.size() && text_[at] == '.') ++at;
    return at < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at]));
  }

  double number() {
    if (fault_) return 0;
    if (!number_begins(next_)) {
      fail(next_, fmt::format("has no number here; {} takes {}", command_, argument_count()));
      return 0;
    }
    const std::size_t begin = next_;
    if (text_[next_] == '+') ++next_;
    double value = 0;
    const char* const first = text_.data() + next_;
    const auto read = std::from_chars(first, text_.data() + text_.size(), value);
    next_ += static_cast<std::size_t>(read.ptr - first);
    if (read.ec != std::errc() || std::abs(value) > kGreatestMagnitude) {
      fail(begin, "has a number beyond bounds; expected 0 or a number of magnitude up to 1e100");
    }
    return value;
  }

  /// One character, which need not be parted from what follows.
  double flag() {
    if (fault_) return 0;
    if (next_ < text_.size() && (text_[next_] == '0' || text_[next_] == '1')) {
      return text_[next_++] - '0';
    }
    fail(next_, "has no flag of an arc here; expected 0 or 1");
    return 0;
  }

  std::string_view argument_count() const {
    constexpr std::array<std::string_view, 8> kWords{"none", "one",  "two", "three",
                                                     "four", "five", "six", "seven"};
    const std::size_t at = kCommands.find(static_cast<char>(std::toupper(command_)));
    return kWords[static_cast<std::size_t>(kArguments[at])];
  }

  void command() {
    command_ = text_[next_];
    const auto upper = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
    const std::size_t which = kCommands.find(upper);
    if (which == std::string_view::npos) {
      return fail(next_, fmt::format("has no command here; the commands of path "
                                     "data are {} and their lower-case letters",
                                     kCommands));
    }
    if (subpaths_.empty() && upper != 'M') {
      return fail(next_, "does not begin with a move; expected M or m first");
    }
    ++next_;
    if (upper == 'Z') return close();
    skip_space();
    char drawn = upper;
    do {
      const Arguments arguments = read_arguments(kArguments[which], upper == 'A');
      if (fault_) return;
      draw(drawn, arguments);
      if (drawn == 'M') drawn = 'L';
      last_ = drawn;
    } while (!fault_ && number_begins(next_));
  }

  Arguments read_arguments(int count, bool of_arc) {
    Arguments all{};
    for (int i = 0; i < count; ++i) {
      if (i > 0) skip_comma();
      all[static_cast<std::size_t>(i)] = of_arc && (i == 3 || i == 4) ? flag() : number();
    }
    // Before a further command there is no comma, before further numbers there may be.
    skip_space();
    const std::size_t here = next_;
    skip_comma();
    if (!number_begins(next_)) next_ = here;
    return all;
  }

  void close() {
    subpaths_.back().closed = true;
    here_ = subpaths_.back().start;
    last_ = 'Z';
  }

  void add(const PathSegment& segment, const Vec2d& reflected) {
    if (subpaths_.back().closed) subpaths_.push_back({here_, {}, false});
    subpaths_.back().segments.push_back(segment);
    here_ = segment.to;
    control_ = reflected;
    if (++segments_ > kMostSegments) {
      fail(next_,
           fmt::format("has more than {} segments; at most so many are allowed", kMostSegments));
    }
  }

  /// The last control point mirrored, where the command before was one of `family`.
  Vec2d mirrored(std::string_view family) const {
    return is_among(last_, family) ? here_ + (here_ - control_) : here_;
  }

  void draw(char upper, const Arguments& n) {
    const bool relative = command_ != std::toupper(command_);
    const Vec2d base = relative ? here_ : Vec2d{};
    const auto point = [&](std::size_t i) { return base + Vec2d{n[i], n[i + 1]}; };
    switch (upper) {
      case 'M':
        here_ = point(0);
        subpaths_.push_back({here_, {}, false});
        break;
      case 'L':
        add(line(here_, point(0)), {});
        break;
      case 'H':
        add(line(here_, {base.x + n[0], here_.y}), {});
        break;
      case 'V':
        add(line(here_, {here_.x, base.y + n[0]}), {});
        break;
      case 'C':
        add(cubic(here_, point(0), point(2), point(4)), point(2));
        break;
      case 'S':
        add(cubic(here_, mirrored("CS"), point(0), point(2)), point(0));
        break;
      case 'Q':
        add(quadratic(here_, point(0), point(2)), point(0));
        break;
      case 'T': {
        const Vec2d control = mirrored("QT");
        add(quadratic(here_, control, point(0)), control);
        break;
      }
      default:
        add(arc(here_, point(5), {n[0], n[1]}, radians(std::fmod(n[2], 360)), n[3] != 0, n[4] != 0),
            {});
    }
  }

  std::string_view text_;
  std::size_t next_ = 0;
  std::optional<PathDataFault> fault_;
  char command_ = ' ';  ///< as written
  char last_ = ' ';     ///< the command before, in upper case
  Vec2d here_, control_;
  std::vector<Subpath> subpaths_;
  std::size_t segments_ = 0;
};

}  // namespace

Vec2d PathSegment::at(double t) const {
  if (kind == Kind::line) return mix(from, to, t);
  if (kind == Kind::arc) {
    const double angle = start + t * sweep;
    return centre + std::cos(angle) * a + std::sin(angle) * b;
  }
  const Vec2d ab = mix(a, b, t);
  return mix(mix(mix(from, a, t), ab, t), mix(ab, mix(b, to, t), t), t);
}

tl::expected<std::vector<Subpath>, PathDataFault> parse_path_data(std::string_view text) {
  return Reader(text).take();
}

}  // namespace cognate::problems::reading
