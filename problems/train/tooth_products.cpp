#include "problems/train/tooth_products.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

namespace cognate::problems {
namespace {

void collect(const std::array<int, 2>& bounds, int least, int count, ToothProduct so_far,
             std::vector<ToothProduct>& all) {
  if (count == 0) {
    all.push_back(so_far);
    return;
  }
  for (int teeth = least; teeth <= bounds[1]; ++teeth) {
    collect(bounds, teeth, count - 1,
            {so_far.product * static_cast<std::uint64_t>(teeth), so_far.sum + teeth}, all);
  }
}

/// Fills `teeth` with `count` numbers from `least` on whose product and sum these are.
bool factor(std::uint64_t product, int sum, const std::array<int, 2>& bounds, int least, int count,
            std::vector<int>& teeth) {
  if (count == 0) return product == 1 && sum == 0;
  for (int next = least; next <= bounds[1] && next <= sum; ++next) {
    const auto divisor = static_cast<std::uint64_t>(next);
    if (product % divisor != 0) continue;
    teeth.push_back(next);
    if (factor(product / divisor, sum - next, bounds, next, count - 1, teeth)) return true;
    teeth.pop_back();
  }
  return false;
}

/// Least sums over ranges of products.
class LeastSums {
 public:
  explicit LeastSums(const std::vector<ToothProduct>& products)
      : width_(std::bit_ceil(products.size())), least_(2 * width_, kNone) {
    for (std::size_t i = 0; i < products.size(); ++i) least_[width_ + i] = products[i].sum;
    for (std::size_t i = width_ - 1; i > 0; --i) {
      least_[i] = std::min(least_[2 * i], least_[2 * i + 1]);
    }
  }

  /// Calls `visit` with each place of [from, to) whose sum is at most `most()`.
  template <class Visit, class Most>
  void each(std::size_t from, std::size_t to, const Most& most, const Visit& visit) const {
    if (from < to) descend(1, 0, width_, from, to, most, visit);
  }

 private:
  static constexpr int kNone = 1 << 30;

  template <class Visit, class Most>
  void descend(std::size_t at, std::size_t begin, std::size_t end, std::size_t from, std::size_t to,
               const Most& most, const Visit& visit) const {
    if (end <= from || to <= begin || least_[at] > most()) return;
    if (end - begin == 1) {
      visit(begin);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    descend(2 * at, begin, middle, from, to, most, visit);
    descend(2 * at + 1, middle, end, from, to, most, visit);
  }

  std::size_t width_;
  std::vector<int> least_;
};

class QuotientFinder {
 public:
  QuotientFinder(const std::vector<ToothProduct>& products, int pairs, const QuotientSearch& search,
                 std::vector<ToothQuotient>& best)
      : products_(products), pairs_(pairs), search_(search), best_(best) {}

  void find() {
    if (search_.by_size) {
      find_by_size();
      return;
    }
    for (std::size_t i = 0; i < products_.size(); ++i) {
      if (i % 4096 == 0 && search_.is_over && search_.is_over()) return;
      const std::size_t middle = place_of(wanted(products_[i]));
      for (std::size_t k = middle; k-- > 0;) {
        if (!keep(products_[k], products_[i])) break;
      }
      for (std::size_t k = middle; k < products_.size(); ++k) {
        if (!keep(products_[k], products_[i])) break;
      }
    }
  }

 private:
  double wanted(const ToothProduct& driver) const {
    return search_.ratio * static_cast<double>(driver.product);
  }

  std::size_t place_of(double product) const {
    const auto found = std::ranges::lower_bound(
        products_, product, {}, [](const auto& each) { return static_cast<double>(each.product); });
    return static_cast<std::size_t>(found - products_.begin());
  }

  /// Whether those farther from the ratio may still be among the best.
  bool keep(const ToothProduct& driven, const ToothProduct& driver) {
    const bool is_full = best_.size() == search_.count;
    const double most = is_full && !search_.by_size ? best_.back().error : search_.tolerance;
    const double nearly = std::abs(static_cast<double>(driven.product) / wanted(driver) - 1);
    if (nearly > most + 4 * kExactRatio) return false;
    const double error = ratio_error(driven.product, driver.product, search_.ratio);
    if (error > search_.tolerance + kExactRatio) return false;
    const ToothQuotient found{driven, driver, pairs_, error};
    if (is_full && !search_.by_size && found.error > best_.back().error) return false;
    if (is_full && !search_.is_better(found, best_.back())) return true;
    const auto place = std::ranges::upper_bound(
        best_, found, [&](const auto& a, const auto& b) { return search_.is_better(a, b); });
    best_.insert(place, found);
    if (best_.size() > search_.count) best_.pop_back();
    return true;
  }

  void find_by_size() {
    const LeastSums least(products_);
    std::vector<const ToothProduct*> drivers;
    for (const auto& product : products_) drivers.push_back(&product);
    std::ranges::stable_sort(drivers, {}, [](const auto* each) { return each->sum; });
    std::size_t looked = 0;
    for (const ToothProduct* driver : drivers) {
      if (looked++ % 4096 == 0 && search_.is_over && search_.is_over()) return;
      const auto most = [&] {
        const bool is_full = best_.size() == search_.count;
        return is_full ? best_.back().size() - driver->sum : 1 << 29;
      };
      if (most() < drivers.front()->sum) return;
      const double margin = search_.tolerance + 4 * kExactRatio;
      least.each(place_of(wanted(*driver) * (1 - margin)),
                 std::min(products_.size(), place_of(wanted(*driver) * (1 + margin)) + 1), most,
                 [&](std::size_t k) { keep(products_[k], *driver); });
    }
  }

  const std::vector<ToothProduct>& products_;
  int pairs_;
  const QuotientSearch& search_;
  std::vector<ToothQuotient>& best_;
};

}  // namespace

double ratio_error(std::uint64_t driven, std::uint64_t driver, double wanted) {
  const std::uint64_t common = std::gcd(driven, driver);
  const double ratio = static_cast<double>(driven / common) / static_cast<double>(driver / common);
  const double error = std::abs(ratio / wanted - 1);
  return error <= kExactRatio ? 0 : error;
}

std::vector<ToothProduct> tooth_products(const std::array<int, 2>& bounds, int count) {
  std::vector<ToothProduct> all;
  collect(bounds, bounds[0], count, {}, all);
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return std::tie(a.product, a.sum) < std::tie(b.product, b.sum);
  });
  const auto [first, last] = std::ranges::unique(all, {}, &ToothProduct::product);
  all.erase(first, last);
  return all;
}

std::vector<int> teeth_of(const ToothProduct& product, const std::array<int, 2>& bounds,
                          int count) {
  std::vector<int> teeth;
  factor(product.product, product.sum, bounds, bounds[0], count, teeth);
  return teeth;
}

bool QuotientSearch::is_better(const ToothQuotient& a, const ToothQuotient& b) const {
  const auto rest = [](const ToothQuotient& q) {
    return std::tuple(q.pairs, q.driver.product, q.driven.product);
  };
  const auto key = [&](const ToothQuotient& q) {
    return by_size ? std::tuple(double(q.size()), q.error, rest(q))
                   : std::tuple(q.error, double(q.size()), rest(q));
  };
  return key(a) < key(b);
}

void add_quotients(const std::vector<ToothProduct>& products, int pairs,
                   const QuotientSearch& search, std::vector<ToothQuotient>& best) {
  QuotientFinder(products, pairs, search, best).find();
}

}  // namespace cognate::problems
