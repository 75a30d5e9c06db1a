#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/exact/solve.hpp"

namespace cognate::problems {
namespace {

using synthesis::ExactPathSolutions;
using synthesis::ExactPathStatus;
using synthesis::RootSymmetry;

const char* unit_of(RootSymmetry symmetry) {
  switch (symmetry) {
    case RootSymmetry::cognates:
      return "triplets of Roberts cognates";
    case RootSymmetry::swapped_dyads:
      return "linkages, whichever end drives";
    case RootSymmetry::none:
      break;
  }
  return "linkages";
}

/// "1438 finite and 4 at infinity of 1442".
std::string ends(const ExactPathSolutions& found) {
  std::string text = fmt::format("{} finite", found.finite);
  const auto add = [&](int count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(found.at_infinity, "at infinity");
  add(found.singular, "where solutions meet");
  add(found.lost, "not reached");
  add(found.duplicates, "found twice");
  return text;
}

/// How many points are on one line, and on one circle.
struct MostTogether {
  int line = 0, circle = 0;
};

/// How far three points span a triangle, and where the circle through them is, whose middle is far
/// away where they do not.
struct CircleOfThree {
  double area = 0;  ///< twice that of the triangle
  Vec2d middle;
  double radius = 0;

  CircleOfThree(const Vec2d& p, const Vec2d& q, const Vec2d& r) {
    const Vec2d u = q - p, v = r - p;
    area = cross(u, v);
    const Vec2d w = squared_norm(u) * v - squared_norm(v) * u;
    const Vec2d to_middle = (-0.5 / area) * perp(w);
    middle = p + to_middle;
    radius = norm(to_middle);
  }
};

/// To within a part in ten million of their extent.
MostTogether most_on_line_and_circle(std::span<const Vec2d> points) {
  constexpr double kOn = 1e-7;
  double size = 0;
  for (const Vec2d& p : points) size = std::max(size, norm(p - points[0]));
  MostTogether most;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const Vec2d along = points[j] - points[i];
      if (!(norm(along) > kOn * size)) continue;
      most.line =
          std::max(most.line, int(std::ranges::count_if(points, [&](const Vec2d& p) {
                     return std::abs(cross(along, p - points[i])) <= kOn * size * norm(along);
                   })));
      for (std::size_t k = j + 1; k < count; ++k) {
        const CircleOfThree circle(points[i], points[j], points[k]);
        if (!(std::abs(circle.area) > kOn * size * size)) continue;
        most.circle =
            std::max(most.circle, int(std::ranges::count_if(points, [&](const Vec2d& p) {
                       return std::abs(norm(p - circle.middle) - circle.radius) <= kOn * size;
                     })));
      }
    }
  }
  return most;
}

bool is_sound(const TracedDesign& traced) {
  return all_satisfied(traced.design.constraints);
}

/// Designs that only one defect spoils.
int spoiled_by(const std::vector<TracedDesign>& designs, Defect defect) {
  return int(std::ranges::count_if(designs, [&](const TracedDesign& traced) {
    const auto& defects = traced.design.metrics.defects;
    return !is_sound(traced) && defects.size() == 1 && defects[0] == defect;
  }));
}

}  // namespace

void note_counts(const ExactPathSolutions& solutions, const ExactRoots& roots,
                 const Expectation& expected, Result& result) {
  const int real = int(std::ranges::count(roots.roots, true, &synthesis::PathRoot::real));
  const int certified = synthesis::count_distinct(roots.certificates, roots.symmetry);
  const int real_certified = int(std::ranges::count_if(
      roots.certificates, [](const auto& proof) { return proof.certified && proof.real; }));
  const auto add = [&](const char* name, int count) {
    result.quantities.push_back({name, double(count)});
  };
  add("expected_solutions", solutions.tracked);
  add("complex_solutions", solutions.finite);
  add("solutions_at_infinity", solutions.at_infinity);
  add("singular_solutions", solutions.singular);
  add("lost_paths", solutions.lost);
  add("certified_solutions", certified);
  add("real_solutions", real);
  add("certified_real_solutions", real_certified);

  result.notes.push_back(fmt::format("Of {} solutions over the complex numbers ({}{}): {}.",
                                     solutions.tracked, unit_of(roots.symmetry),
                                     expected.by_theory ? "" : "; counted by trial, not by theory",
                                     ends(solutions)));
  if (!expected.settled) {
    result.notes.push_back(
        "The count of solutions was still growing when it was broken off: there are more.");
  }
  if (solutions.at_infinity > 0) {
    result.notes.push_back(
        "Solutions at infinity have a pivot there: a slider replaces the crank or rocker.");
  }
  if (const int unknown = solutions.lost + solutions.duplicates; unknown > 0) {
    result.notes.push_back(fmt::format(
        "{} solutions are not known, so that there may be linkages that are not listed: positions "
        "so close together, or so nearly degenerate, are not distinguished with the digits there "
        "are. "
        "Fewer positions, farther apart, or least squares may find more.",
        unknown));
  }
  result.notes.push_back(fmt::format(
      "{} of the {} finite solutions are certified as true and distinct, {} of the {} real ones as "
      "real.",
      certified, solutions.finite, real_certified, real));
}

void note_status(const ExactPathSolutions& solutions, Result& result) {
  if (solutions.status == ExactPathStatus::coincident) {
    result.notes.push_back(fmt::format(
        "Positions {} and {} coincide: they are one condition, and a curve of solutions passes "
        "through all positions. Leave one out or move it.",
        solutions.coincident[0] + 1, solutions.coincident[1] + 1));
  } else if (solutions.status == ExactPathStatus::not_finite) {
    result.notes.push_back("A coordinate is too large to be squared; use a larger unit of length.");
  } else if (solutions.status == ExactPathStatus::dependent) {
    result.notes.push_back(
        "Positions and given parts determine one dyad more than once: no four-bar satisfies all of "
        "them in general. Leave a given part or a pose out.");
  } else if (solutions.status == ExactPathStatus::interrupted) {
    result.notes.push_back(
        "The run was ended while the generic problem of this kind was being solved, which has to "
        "be done once before any solution is known; give it more time.");
  }
}

bool note_points_on_a_circle(std::span<const Vec2d> points, Result& result) {
  constexpr int kMostOnPath = 6, kDegenerate = 4;
  const auto [line, circle] = most_on_line_and_circle(points);
  if (line > kMostOnPath) {
    result.notes.push_back(fmt::format(
        "{} of the points lie on one line. The path of a four-bar meets a line in six points at "
        "most, so that no four-bar passes through all of them; a slider on that line does. Give at "
        "most six points of one line, or use kind = \"straight-line\" or least squares.",
        line));
  } else if (circle > kMostOnPath) {
    result.notes.push_back(fmt::format(
        "{} of the points lie on one circle. The path of a four-bar meets a circle in six points "
        "at most unless it contains that circle: that of a point on the crank's moving pivot does, "
        "the crank turning about the middle of the circle, and so does that of any point of a "
        "parallelogram with cranks of its radius. These are a family, not single solutions; give "
        "at most six points of one circle, or use least squares.",
        circle));
  } else if (line >= kDegenerate || circle > kDegenerate) {
    result.notes.push_back(fmt::format(
        "{} of the points lie on one {}, which the path of a four-bar meets in six points at most: "
        "some of the solutions that points in general have are at infinity here, or meet.",
        std::max(line, circle), line >= circle ? "line" : "circle"));
  }
  return line > kMostOnPath || circle > kMostOnPath;
}

void note_equal_angles(std::span<const double> angles, Result& result) {
  constexpr double kSame = 1e-9;
  constexpr std::ptrdiff_t kDetermined = 3;
  for (const double angle : angles) {
    const auto alike = std::ranges::count_if(angles, [&](double other) {
      return std::abs(std::remainder(other - angle, kTurn)) <= kSame;
    });
    if (alike < kDetermined) continue;
    result.notes.push_back(fmt::format(
        "{} of the poses have the same angle. A four-bar moves its coupler so without a turn only "
        "where it is a parallelogram, whose points move on equal circles: a family, not single "
        "solutions. Poses on no common circle need sliders.",
        alike));
    return;
  }
}

void note_exact_designs(const std::vector<TracedDesign>& designs, Result& result) {
  const auto sound = std::ranges::count_if(designs, is_sound);
  if (designs.empty()) {
    result.notes.push_back("None of the solutions that were found is a linkage of the real plane.");
    return;
  }
  result.notes.push_back(fmt::format("{} of {} linkages of the real plane meet every constraint.",
                                     sound, designs.size()));
  if (sound > 0) return;
  result.notes.push_back(
      fmt::format("Near misses: {} linkages have a branch defect alone, {} meet the positions in "
                  "another order, "
                  "{} need another circuit; they are starts for least squares.",
                  spoiled_by(designs, Defect::branch), spoiled_by(designs, Defect::order),
                  spoiled_by(designs, Defect::circuit)));
}

}  // namespace cognate::problems
