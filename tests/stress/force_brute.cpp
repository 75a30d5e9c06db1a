#include "tests/stress/force_brute.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/read.hpp"
#include "tests/stress/force_linkage.hpp"

namespace cognate::stress {
namespace {

struct Found {
  double least = 0, greatest = 0;
  bool falls = false, grows = false, unclear = false;
};

/// The golden section between two places about a sample.
double refine(const std::function<double(double)>& f, double a, double b) {
  constexpr double kShare = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double x = b - kShare * (b - a), y = a + kShare * (b - a);
    (f(x) < f(y) ? a : b) = f(x) < f(y) ? x : y;
  }
  return f(0.5 * (a + b));
}

/// Adds to `places`, which are in order, where the load's part of the stroke begins and ends, and
/// places within.
void add_stroke_ends(const Linkage& l, std::vector<double>& places) {
  const std::vector<double> all = places;
  for (const double part : {l.from, l.to, 0.5 * (l.from + l.to)}) {
    for (std::size_t i = 1; i < all.size(); ++i) {
      double a = all[i - 1], b = all[i];
      const bool below = part_of_stroke(l, a) < part;
      if (below == (part_of_stroke(l, b) < part)) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (a + b);
        ((part_of_stroke(l, middle) < part) == below ? a : b) = middle;
      }
      places.push_back(0.5 * (a + b));
    }
  }
}

Found search(const Linkage& l, ForceQuantity quantity, int samples) {
  const auto torque = [&](const Linkage& of, double q, bool loaded) {
    return force(of, quantity, q, loaded);
  };
  Found found{HUGE_VAL, -HUGE_VAL};
  for (const auto& [from, to] : ranges(l)) {
    const bool turns = to - from >= kTurn - 1e-9;
    std::vector<double> places;
    const int beyond = turns ? 1 : 0;  // so that what lies next to the start has two neighbours
    for (int i = -beyond; i <= samples + beyond; ++i) {
      const double share = static_cast<double>(i) / samples;
      const double bent = 0.5 - 0.5 * std::cos(kPi * share);
      places.push_back(from + (to - from) * (turns ? share : bent));
    }
    if (l.when == When::interval) {
      for (double q : {l.from * kDegree, l.to * kDegree, 0.5 * (l.from + l.to) * kDegree}) {
        q = from + std::fmod(std::fmod(q - from, kTurn) + kTurn, kTurn);
        if (q < to) places.push_back(q);
      }
    }
    if (l.when == When::stroke) add_stroke_ends(l, places);
    std::ranges::sort(places);
    if (!turns) {
      places.erase(places.begin());
      places.pop_back();
      for (const auto& [end, inward] : {std::pair(from, 1.0), std::pair(to, -1.0)}) {
        const bool loaded = acts(l, end + inward * 1e-7);
        const double near = torque(l, end + inward * 1e-9, loaded);
        const double far = torque(l, end + inward * 1e-7, loaded);
        const bool grows = std::abs(near) > 3 * std::abs(far);
        found.unclear |= std::abs(near) < 10 && std::abs(near) > 1e-6;
        if (grows && std::abs(near) > 1e-6) (near > 0 ? found.grows : found.falls) = true;
      }
    }
    const auto offer = [&](double value) {
      found.least = std::min(found.least, value);
      found.greatest = std::max(found.greatest, value);
    };
    std::vector<bool> loaded;
    std::vector<double> values;
    for (const double q : places) {
      loaded.push_back(acts(l, q));
      values.push_back(torque(l, q, loaded.back()));
      offer(values.back());
    }
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (loaded[i] != loaded[i - 1]) {
        double a = places[i - 1], b = places[i];
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (a + b);
          (acts(l, middle) == loaded[i - 1] ? a : b) = middle;
        }
        offer(torque(l, a, loaded[i - 1]));
        offer(torque(l, b, loaded[i]));
      } else if (i + 1 < places.size() && loaded[i] == loaded[i + 1]) {
        for (const double sense : {1.0, -1.0}) {
          const double here = sense * values[i];
          if (here < sense * values[i - 1] || here < sense * values[i + 1]) continue;
          const auto f = [&](double q) { return sense * torque(l, q, loaded[i]); };
          offer(sense * refine(f, places[i - 1], places[i + 1]));
        }
      }
    }
  }
  return found;
}

/// A reported of an extreme: where its value, its place and the place near which it is unbounded
/// stand.
struct ForceFact {
  std::string value, at, unbounded_at;
};

ForceFact torque_fact(const std::string& which) {
  const std::string name = "torque_N_m." + which;
  return {name, name + "_at_deg", name + "_unbounded_at_deg"};
}

ForceFact reaction_fact(const std::string& joint) {
  return {"reaction_max_N." + joint, "reaction_max_at_deg." + joint,
          "reaction_max_unbounded_at_deg." + joint};
}

/// Holds one analysis against the brute force.
class Judge {
 public:
  Judge(const Linkage& linkage, ForceTally& tally) : linkage_(linkage), tally_(tally) {}

  void judge() {
    const auto problem = problems::parse_task<problems::AnalysisProblem>(file_of(linkage_));
    if (!problem) return disagree("file refused: " + problem.error().front().message);
    const auto result = problems::analyse(*problem, problems::Run{.threads = 1});
    for (const auto& reported : result.quantities) {
      if (const auto* value = std::get_if<double>(&reported.value)) facts_[reported.name] = *value;
    }
    ++tally_.linkages;
    constexpr int kSamples = 2500;
    const Found torque = search(linkage_, ForceQuantity::torque, kSamples);
    if (!torque.unclear) {
      const double range = torque.greatest - torque.least;
      compare(torque_fact("min"), ForceQuantity::torque, torque.least, torque.falls, range);
      compare(torque_fact("max"), ForceQuantity::torque, torque.greatest, torque.grows, range);
    }
    reactions(ForceQuantity::at_b, {"A_on_crank", "B_on_coupler"}, kSamples);
    if (linkage_.slides) {
      reactions(ForceQuantity::at_c, {"C_on_slider"}, kSamples);
      reactions(ForceQuantity::on_slide, {"frame_on_slider"}, kSamples);
    } else {
      reactions(ForceQuantity::at_c, {"C_on_rocker", "D_on_rocker"}, kSamples);
    }
  }

 private:
  void reactions(ForceQuantity quantity, const std::vector<std::string>& joints, int samples) {
    const Found found = search(linkage_, quantity, samples);
    if (found.unclear) return;
    for (const std::string& joint : joints) {
      compare(reaction_fact(joint), quantity, found.greatest, found.grows, 0);
      ++tally_.reactions;
    }
  }

  void compare(const ForceFact& reported, ForceQuantity quantity, double value, bool unbounded,
               double range) {
    const bool said = facts_.contains(reported.unbounded_at);
    if (said != unbounded) {
      return disagree(reported.value + (said ? " said" : " not said") + " unbounded");
    }
    if (unbounded) {
      ++tally_.unbounded;
      if (facts_.contains(reported.value)) disagree(reported.value + " both");
      return compare_place(facts_[reported.unbounded_at]);
    }
    if (!facts_.contains(reported.value)) return disagree(reported.value + " missing");
    const double size = std::max(std::abs(value), std::isfinite(range) && range < 1e6 ? range : 0);
    const double difference = size > 1e-9 ? std::abs(facts_[reported.value] - value) / size : 0;
    ++tally_.bounded;
    tally_.worst = std::max(tally_.worst, difference);
    if (difference > 2e-6) {
      return disagree(reported.value + " off by " + std::to_string(difference));
    }
    const double at = facts_[reported.at] * kDegree;
    double nearest = HUGE_VAL;
    for (const double step : {-1e-8, 0.0, 1e-8}) {
      for (const bool loaded : {true, false}) {
        nearest = std::min(nearest, std::abs(force(linkage_, quantity, at + step, loaded) - value));
      }
    }
    if (nearest > 1e-5 * size + 1e-9) disagree(reported.at + " holds another force");
  }

  void compare_place(double degrees) {
    for (const auto& [from, to] : ranges(linkage_)) {
      for (const double end : {from, to}) {
        if (std::abs(std::remainder(degrees - end / kDegree, 360)) < 1e-6) return;
      }
    }
    disagree("unbounded elsewhere");
  }

  void disagree(const std::string& what) {
    if (tally_.disagreements++ == 0) tally_.first_file = "# " + what + "\n" + file_of(linkage_);
  }

  const Linkage& linkage_;
  ForceTally& tally_;
  std::map<std::string, double> facts_;
};

}  // namespace

ForceTally check_forces(std::uint64_t seed, int count) {
  ForceTally tally;
  LinkageFamily family(seed);
  for (int i = 0; i < count; ++i) {
    const Linkage linkage = family.next();
    Judge(linkage, tally).judge();
  }
  return tally;
}

}  // namespace cognate::stress
