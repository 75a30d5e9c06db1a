#include "app/export/parts/nesting.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

constexpr double kSheetHair = 1e-9;  // of the rectangle, for rounding

struct FreeArea {
  Vec2d low{}, high{};
};

bool holds(const FreeArea& outer, const FreeArea& inner) {
  return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

/// By what the place of an item is chosen: lower first, then further left; or where the free area
/// that takes it has the least to spare.
enum class NestRule { bottom_left, short_side, area };
constexpr std::array kRules = {NestRule::bottom_left, NestRule::short_side, NestRule::area};

using Score = std::tuple<double, double>;

Score score(NestRule rule, const FreeArea& area, const Vec2d& size) {
  const Vec2d room = area.high - area.low, spare = room - size;
  const double least = std::min(spare.x, spare.y);
  if (rule == NestRule::bottom_left) return {area.low.y + size.y, area.low.x};
  if (rule == NestRule::short_side) return {least, std::max(spare.x, spare.y)};
  return {room.x * room.y - size.x * size.y, least};
}

/// One sheet with what is free on it, as all greatest rectangles.
class NestSheet {
 public:
  explicit NestSheet(const Vec2d& size) : free_{{{}, size}} {}

  /// The best place of a rectangle in one of `sizes`; empty where there is none.
  struct Found {
    Score score{kInfinity, kInfinity};
    std::size_t choice = 0;
    Vec2d corner{};
  };
  std::optional<Found> find(const std::vector<Vec2d>& sizes, NestRule rule) const {
    std::optional<Found> best;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      for (const FreeArea& area : free_) {
        const Vec2d room = area.high - area.low;
        if (!fits_sheet(sizes[i], room)) continue;
        const Score merit = score(rule, area, sizes[i]);
        if (!best || merit < best->score) best = Found{merit, i, area.low};
      }
    }
    return best;
  }

  void take(const Vec2d& corner, const Vec2d& size) {
    const FreeArea taken{corner, corner + size};
    std::vector<FreeArea> left;
    for (const FreeArea& area : free_) cut(area, taken, left);
    free_.clear();
    for (std::size_t i = 0; i < left.size(); ++i) {
      bool inside = false;
      for (std::size_t k = 0; k < left.size() && !inside; ++k) {
        inside = k != i && holds(left[k], left[i]) && (k < i || !holds(left[i], left[k]));
      }
      if (!inside) free_.push_back(left[i]);
    }
  }

 private:
  /// What is left of `area` beside `taken`.
  static void cut(const FreeArea& area, const FreeArea& taken, std::vector<FreeArea>& left) {
    const auto& [low, high] = area;
    if (taken.low.x >= high.x || taken.high.x <= low.x || taken.low.y >= high.y ||
        taken.high.y <= low.y) {
      left.push_back(area);
      return;
    }
    if (taken.low.x > low.x) left.push_back({low, {taken.low.x, high.y}});
    if (taken.high.x < high.x) left.push_back({{taken.high.x, low.y}, high});
    if (taken.low.y > low.y) left.push_back({low, {high.x, taken.low.y}});
    if (taken.high.y < high.y) left.push_back({{low.x, taken.high.y}, high});
  }

  std::vector<FreeArea> free_;
};

/// Items in this order, each on the first sheet with room for it.
Nesting nested(const std::vector<NestItem>& items, const std::vector<std::size_t>& order,
               const Vec2d& sheet, NestRule rule) {
  Nesting made{std::vector<NestPlace>(items.size()), 0};
  std::vector<NestSheet> sheets;
  for (const std::size_t item : order) {
    const auto& sizes = items[item].sizes;
    for (std::size_t s = 0;; ++s) {
      if (s == sheets.size()) sheets.emplace_back(sheet);
      const auto found = sheets[s].find(sizes, rule);
      if (!found) continue;
      sheets[s].take(found->corner, sizes[found->choice]);
      made.places[item] = {static_cast<int>(s), found->choice, found->corner};
      break;
    }
  }
  made.sheets = static_cast<int>(sheets.size());
  return made;
}

/// How high the last sheet is filled.
double last_height(const Nesting& made, const std::vector<NestItem>& items) {
  double height = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const NestPlace& place = made.places[i];
    if (place.sheet != made.sheets - 1) continue;
    height = std::max(height, place.corner.y + items[i].sizes[place.choice].y);
  }
  return height;
}

/// Orders by height, width, longer side, shorter side, area and perimeter, the greatest first.
std::vector<std::vector<std::size_t>> nest_orders(const std::vector<NestItem>& items) {
  std::vector<std::vector<std::size_t>> orders;
  const std::array<double (*)(const Vec2d&), 6> measures = {
      [](const Vec2d& size) { return size.y; },
      [](const Vec2d& size) { return size.x; },
      [](const Vec2d& size) { return std::max(size.x, size.y); },
      [](const Vec2d& size) { return std::min(size.x, size.y); },
      [](const Vec2d& size) { return size.x * size.y; },
      [](const Vec2d& size) { return size.x + size.y; }};
  for (const auto& measure : measures) {
    std::vector<std::size_t> order(items.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater{},
                             [&](std::size_t i) { return measure(items[i].sizes.front()); });
    orders.push_back(std::move(order));
  }
  return orders;
}

}  // namespace

bool fits_sheet(const Vec2d& size, const Vec2d& sheet) {
  return size.x <= sheet.x + kSheetHair * size.x && size.y <= sheet.y + kSheetHair * size.y;
}

std::optional<Nesting> nest(const std::vector<NestItem>& items, const Vec2d& sheet, double gap) {
  // With the gap at the right and above, so that neighbours keep it.
  const Vec2d margin{gap, gap};
  std::vector<NestItem> wider(items.size());
  std::vector<std::vector<std::size_t>> choices(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t k = 0; k < items[i].sizes.size(); ++k) {
      if (!fits_sheet(items[i].sizes[k], sheet)) continue;
      wider[i].sizes.push_back(items[i].sizes[k] + margin);
      choices[i].push_back(k);
    }
    if (choices[i].empty()) return std::nullopt;
  }
  std::optional<Nesting> best;
  double height = 0;
  for (const auto& order : nest_orders(wider)) {
    for (const NestRule rule : kRules) {
      Nesting made = nested(wider, order, sheet + margin, rule);
      const double reached = last_height(made, wider);
      if (best && std::tuple(made.sheets, reached) >= std::tuple(best->sheets, height)) continue;
      best = std::move(made);
      height = reached;
    }
  }
  for (std::size_t i = 0; best && i < items.size(); ++i) {
    std::size_t& choice = best->places[i].choice;
    choice = choices[i][choice];
  }
  return best;
}

}  // namespace cognate::app
