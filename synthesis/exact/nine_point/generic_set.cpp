#include "synthesis/exact/nine_point/generic_set.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <random>
#include <string>

#include "analysis/numbers/parallel.hpp"
#include "synthesis/exact/nine_point/number_file.hpp"

namespace cognate::synthesis::constrained {
namespace {

using nine_point::FileKey;

/// Random complex numbers from a fixed seed.
class Draw {
 public:
  Complex operator()() { return {normal_(random_), normal_(random_)}; }

 private:
  std::mt19937_64 random_{20260101};
  std::normal_distribution<double> normal_{0, 0.7};
};

/// The displacement at which both dyads keep their lengths, the coupler having turned by t: of the
/// two, that of the larger root.
void plant(const PivotUnknowns<Complex>& u, Complex t, Complex& d, Complex& d_bar) {
  const Complex p = u[0] * t - u[2], p_bar = u[1] / t - u[3];
  const Complex q = u[4] * t - u[6], q_bar = u[5] / t - u[7];
  const Complex link_p = (u[0] - u[2]) * (u[1] - u[3]), link_q = (u[4] - u[6]) * (u[5] - u[7]);
  // (d + p)(d̄ + p̄) = link_p and the same with q: their difference is linear in d and d̄.
  const Complex alpha = p_bar - q_bar, beta = p - q;
  const Complex gamma = p * p_bar - link_p - q * q_bar + link_q;
  const Complex a = -alpha, b = beta * p_bar - alpha * p - gamma;
  const Complex c = beta * (p * p_bar - link_p) - p * gamma;
  const Complex root = std::sqrt(b * b - 4.0 * a * c);
  const Complex sum = std::abs(b + root) > std::abs(b - root) ? b + root : b - root;
  d = -sum / (2.0 * a);
  d_bar = -(alpha * d + gamma) / beta;
}

GenericSet planted(const PathClass& kind, const FixedParts& given, Draw& draw) {
  GenericSet set;
  State state;
  for (Complex& z : state.pivots) z = draw();
  const int count = kind.poses - 1 + kind.points;
  for (int j = 0; j < count; ++j) {
    const Complex log_t = Complex(0, 1.5) * draw();
    Complex d, d_bar;
    plant(state.pivots, std::exp(log_t), d, d_bar);
    set.data.d.push_back(d);
    set.data.d_bar.push_back(d_bar);
    if (j < kind.poses - 1) {
      set.data.t.push_back(std::exp(log_t));
    } else {
      state.log_t.push_back(log_t);
    }
  }
  set.data.conditions = side_conditions_at(given, state.pivots);
  set.states.push_back(state);
  return set;
}

/// Data of the same kind, unrelated to it.
Data other_data(const Data& data, const FixedParts& given, Draw& draw) {
  Data other = data;
  for (auto* numbers : {&other.d, &other.d_bar, &other.t}) {
    for (Complex& z : *numbers) z = draw();
  }
  PivotUnknowns<Complex> u;
  for (Complex& z : u) z = draw();
  other.conditions = side_conditions_at(given, u);
  return other;
}

/// Monodromy: a search that goes on from the solutions known.
class Monodromy {
 public:
  Monodromy(const PathClass& kind, const FixedParts& given, const GenericSearch& search)
      : given_(given), search_(search), set_(planted(kind, given, draw_)) {
    if (!converge(set_.states[0], set_.data)) set_.states.clear();
  }

  /// Null when stopped.
  std::shared_ptr<const GenericSet> run() {
    constexpr int kQuietLoops = 3, kMostLoops = 40;
    int quiet = 0;
    for (loops_ = 0; loops_ < kMostLoops && quiet < kQuietLoops; ++loops_) {
      const std::size_t known = set_.states.size();
      add(loop());
      if (stopped_) return nullptr;
      // One solution alone may come home from any loop.
      quiet = set_.states.size() > known || known < 2 ? 0 : quiet + 1;
    }
    set_.settled = quiet >= kQuietLoops || set_.states.size() == 1;
    return std::make_shared<const GenericSet>(std::move(set_));
  }

 private:
  /// The ends of a loop through two other problems, one for each state.
  std::vector<TrackedPath> loop() {
    const Data second = other_data(set_.data, given_, draw_);
    const Data third = other_data(set_.data, given_, draw_);
    const Data* legs[] = {&set_.data, &second, &third, &set_.data};
    std::vector<TrackedPath> ends(set_.states.size());
    std::atomic<int> done{0};
    parallel_for(int(ends.size()), search_.threads, [&](int i, int thread) {
      TrackedPath& path = ends[std::size_t(i)];
      path.state = set_.states[std::size_t(i)];
      for (int leg = 0; leg < 3; ++leg) {
        if (stopped_ || (search_.stop && search_.stop())) {
          stopped_ = true;
          path.end = PathEnd::lost;
          return;
        }
        path = follow(path.state, *legs[leg], *legs[leg + 1], {});
        if (path.end != PathEnd::finite) return;
      }
      ++done;
      if (thread == 0) report(double(done) / double(ends.size()));
    });
    return ends;
  }

  void add(const std::vector<TrackedPath>& ends) {
    for (const TrackedPath& path : ends) {
      if (path.end != PathEnd::finite) continue;
      const bool is_new = std::ranges::none_of(
          set_.states, [&](const State& state) { return are_same(state, path.state); });
      if (is_new) set_.states.push_back(path.state);
    }
  }

  /// How many loops there will be is not known; five to ten are common.
  void report(double share_of_loop) const {
    constexpr double kHalfDone = 5;
    const double loops = loops_ + share_of_loop;
    if (search_.progress) search_.progress(loops / (loops + kHalfDone));
  }

  const FixedParts& given_;
  const GenericSearch& search_;
  Draw draw_;
  GenericSet set_;
  int loops_ = 0;
  std::atomic<bool> stopped_{false};
};

/// What a kind of problem is: poses, points, and a bit for each given part.
FileKey key_of(const PathClass& kind, const FixedParts& parts) {
  std::uint64_t given = 0;
  for (const bool is_given :
       {parts.pivot_a.has_value(), parts.pivot_d.has_value(), parts.coupler_point.has_value(),
        parts.frame_angle.has_value(), parts.crank.has_value(), parts.coupler.has_value(),
        parts.rocker.has_value(), parts.frame.has_value()}) {
    given = 2 * given + is_given;
  }
  return {std::uint64_t(kind.poses), std::uint64_t(kind.points), 256 + given};
}

std::filesystem::path file_in(const std::filesystem::path& folder, const FileKey& key) {
  return folder / ("path-given-" + std::to_string(key[0]) + "-" + std::to_string(key[1]) + "-" +
                   std::to_string(key[2]));
}

/// Beyond, a file is not one of solutions.
constexpr std::size_t kMostStates = 100'000;

std::size_t numbers_of(const State& state) {
  return 2 * (state.pivots.size() + state.log_t.size());
}

/// Only the solutions are kept: the data are drawn again.
bool write(const std::filesystem::path& file, const FileKey& key, const GenericSet& set) {
  std::vector<double> numbers;
  const auto put = [&](const Complex& z) {
    numbers.push_back(z.real());
    numbers.push_back(z.imag());
  };
  for (const State& state : set.states) {
    for (const Complex& z : state.pivots) put(z);
    for (const Complex& z : state.log_t) put(z);
  }
  return nine_point::write_numbers(file, key, numbers);
}

}  // namespace

bool are_same(const State& a, const State& b) {
  constexpr double kNear = 1e-6;
  for (std::size_t i = 0; i < a.pivots.size(); ++i) {
    if (std::abs(a.pivots[i] - b.pivots[i]) > kNear * (1 + std::abs(a.pivots[i]))) return false;
  }
  for (std::size_t j = 0; j < a.log_t.size(); ++j) {
    if (std::abs(std::exp(a.log_t[j] - b.log_t[j]) - 1.0) > kNear) return false;
  }
  return true;
}

int generic_rank(const PathClass& kind, const FixedParts& given) {
  Draw draw;
  const GenericSet set = planted(kind, given, draw);
  return rank(set.states[0], set.data);
}

std::shared_ptr<const GenericSet> read_generic_set(const std::filesystem::path& folder,
                                                   const PathClass& kind, const FixedParts& given) {
  const FixedParts parts = without_repetition(given);
  const FileKey key = key_of(kind, parts);
  Draw draw;
  GenericSet set = planted(kind, parts, draw);
  State state = set.states[0];
  const std::size_t each = numbers_of(state);
  const auto numbers = nine_point::read_numbers(file_in(folder, key), key, kMostStates * each);
  if (!numbers || numbers->empty() || numbers->size() % each != 0) return nullptr;
  set.states.clear();
  for (auto next = numbers->begin(); next != numbers->end();) {
    const auto take = [&](Complex& z) {
      const double re = *next++;
      z = {re, *next++};
    };
    for (Complex& z : state.pivots) take(z);
    for (Complex& z : state.log_t) take(z);
    set.states.push_back(state);
  }
  constexpr double kSolved = 1e-6;
  const bool solved = std::ranges::all_of(
      set.states, [&](const State& one) { return quality(one, set.data).residual <= kSolved; });
  set.settled = true;
  return solved ? std::make_shared<const GenericSet>(std::move(set)) : nullptr;
}

std::shared_ptr<const GenericSet> generic_set(const PathClass& kind, const FixedParts& given,
                                              const GenericSearch& search) {
  static std::mutex guard;
  static std::map<FileKey, std::shared_ptr<const GenericSet>> known;
  const FixedParts parts = without_repetition(given);
  const FileKey key = key_of(kind, parts);
  {
    const std::scoped_lock lock(guard);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  auto set = search.cache.empty() ? nullptr : read_generic_set(search.cache, kind, parts);
  if (!set) {
    set = Monodromy(kind, parts, search).run();
    if (!set) return nullptr;
    if (!search.cache.empty() && set->settled) write(file_in(search.cache, key), key, *set);
  }
  const std::scoped_lock lock(guard);
  return known.try_emplace(key, std::move(set)).first->second;
}

}  // namespace cognate::synthesis::constrained
