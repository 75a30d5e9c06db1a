#include "tests/browser/sample_studies.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace {

using namespace cognate;
using namespace cognate::problems;
using nlohmann::ordered_json;

constexpr const char* kFourBar = R"(kind = "analysis"
title = "Crank-rocker"

[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [100, 0]]
crank = 30
coupler = 90
rocker = 70
coupler_point = [45, 40]
)";

StudyVariable variable(std::string key, KeyPath path) {
  StudyVariable made;
  made.key = std::move(key);
  made.path = std::move(path);
  return made;
}

StudyVariable grid(const std::string& key, KeyPath path, double from, double to, int steps) {
  StudyVariable made = variable(key, std::move(path));
  for (int i = 0; i < steps; ++i) made.values.push_back(from + (to - from) * i / (steps - 1));
  return made;
}

StudyVariable sampled(const std::string& key, KeyPath path, double from, double to) {
  StudyVariable made = variable(key, std::move(path));
  made.range = Range{from, to};
  return made;
}

KeyPath link(const char* name) {
  return {"mechanism", name};
}
KeyPath place(const char* name, std::size_t i) {
  return {"mechanism", name, i};
}
const KeyPath kFrame{"mechanism", "fixed_pivots", std::size_t{1}, std::size_t{0}};

/// The acute transmission angle that is least over a turn, in degrees.
double least_transmission(const FourBar& linkage) {
  double least = 90;
  for (int i = 0; i < 180; ++i) {
    const auto pose = Motion(linkage).at(i * kPi / 90);
    if (!pose) return 0;
    const double angle = pose->transmission_angle * 180 / kPi;
    least = std::min({least, angle, 180 - angle});
  }
  return least;
}

struct CurveSize {
  double length = 0, width = 0, height = 0;
};

CurveSize curve_size(const FourBar& linkage) {
  CurveSize size;
  std::optional<Vec2d> last;
  Vec2d low{1e9, 1e9}, high{-1e9, -1e9};
  for (int i = 0; i <= 180; ++i) {
    const auto pose = Motion(linkage).at(i * kPi / 90);
    if (!pose) continue;
    const Vec2d& p = *pose->coupler_point;
    if (last) size.length += norm(p - *last);
    last = p;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  size.width = high.x - low.x;
  size.height = high.y - low.y;
  return size;
}

bool is_grashof(const FourBar& linkage) {
  const auto l = lengths(linkage);
  std::array all{l.crank, l.coupler, l.rocker, l.frame};
  std::ranges::sort(all);
  return all[0] + all[3] <= all[1] + all[2];
}

std::string type_of(const FourBar& linkage) {
  if (!is_grashof(linkage)) return "triple-rocker";
  const auto l = lengths(linkage);
  const double least = std::min({l.crank, l.coupler, l.rocker, l.frame});
  if (least == l.crank) return "crank-rocker";
  if (least == l.frame) return "double-crank";
  return least == l.coupler ? "double-rocker" : "rocker-crank";
}

void add(SampleStudy& sample, std::vector<Cell> cells, bool best = false,
         RunStatus status = RunStatus::solved) {
  auto& rows = sample.rows;
  rows.ids.push_back(rows.total++);
  rows.statuses.push_back(status);
  rows.best.push_back(best);
  std::ranges::move(cells, std::back_inserter(rows.cells));
}

ordered_json document(const SampleStudy& sample, std::int64_t designs) {
  return {{"format", "cognate-study/1"},
          {"version", "0.1.0"},
          {"seed", 1},
          {"status", "done"},
          {"study", {{"title", sample.study.title}, {"base", sample.study.base}}},
          {"counts",
           {{"designs", designs},
            {"evaluated", designs},
            {"kept", sample.rows.total},
            {"filtered", designs - sample.rows.total}}},
          {"notes", ordered_json::array()},
          {"work", {{"seconds", 0.84}, {"threads", 2}}}};
}

void set_columns(SampleStudy& sample) {
  auto& columns = sample.rows.columns;
  for (const auto& varied : sample.study.variables) columns.push_back(varied.key);
  std::ranges::copy(sample.study.metrics, std::back_inserter(columns));
}

/// Marks the rows that no other beats in both of two columns, the first to be small, the second
/// great.
void mark_front(SampleStudy& sample, std::size_t small, std::size_t great) {
  auto& rows = sample.rows;
  const auto value = [&](std::size_t row, std::size_t column) {
    return std::get<double>(rows.cells[row * rows.columns.size() + column]);
  };
  for (std::size_t i = 0; i < rows.ids.size(); ++i) {
    rows.best[i] = true;
    for (std::size_t j = 0; j < rows.ids.size() && rows.best[i]; ++j) {
      const bool no_worse =
          value(j, small) <= value(i, small) && value(j, great) >= value(i, great);
      const bool same = value(j, small) == value(i, small) && value(j, great) == value(i, great);
      rows.best[i] = !no_worse || same;
    }
  }
}

/// 16 × 14 × 4 crank-rockers, those kept whose transmission angle is at least 25°.
SampleStudy crank_rockers() {
  SampleStudy sample{.name = "grid", .study = {}, .rows = {}, .document = {}};
  Study& study = sample.study;
  study.title = "Crank-rockers of moderate size";
  study.base = "crank-rocker.toml";
  study.base_text = kFourBar;
  study.variables = {grid("mechanism.coupler", link("coupler"), 60, 135, 16),
                     grid("mechanism.rocker", link("rocker"), 40, 105, 14),
                     grid("mechanism.crank", link("crank"), 20, 35, 4)};
  study.metrics = {"transmission_angle_deg.acute_min", "swing_deg", "size"};
  study.filters = {{.name = "transmission_angle_deg.acute_min", .min = 25, .words = {}}};
  study.objectives = {{"size", false}, {"transmission_angle_deg.acute_min", true}};
  set_columns(sample);
  for (const double coupler : study.variables[0].values) {
    for (const double rocker : study.variables[1].values) {
      for (const double crank : study.variables[2].values) {
        const FourBar linkage{{0, 0}, {100, 0},       crank,        coupler,
                              rocker, Assembly::open, Vec2d{45, 40}};
        const double transmission = least_transmission(linkage);
        if (transmission < 25 || type_of(linkage) != "crank-rocker") continue;
        double low = 10, high = -10;
        for (int i = 0; i < 180; ++i) {
          const double angle = Motion(linkage).at(i * kPi / 90)->rocker_angle;
          low = std::min(low, angle);
          high = std::max(high, angle);
        }
        add(sample, {coupler, rocker, crank, transmission, (high - low) * 180 / kPi,
                     coupler + rocker + crank + 100});
      }
    }
  }
  mark_front(sample, 5, 3);
  sample.document = document(sample, 896);
  return sample;
}

/// Five thousand rows of twelve columns, the best fifty by the curve's length.
SampleStudy sampled_four_bars() {
  SampleStudy sample{.name = "sobol", .study = {}, .rows = {}, .document = {}};
  Study& study = sample.study;
  study.title = "Five thousand four-bars";
  study.base = "crank-rocker.toml";
  study.base_text = kFourBar;
  study.variables = {sampled("mechanism.crank", link("crank"), 15, 60),
                     sampled("mechanism.coupler", link("coupler"), 30, 160),
                     sampled("mechanism.rocker", link("rocker"), 30, 160),
                     sampled("mechanism.coupler_point[0]", place("coupler_point", 0), -60, 120),
                     sampled("mechanism.coupler_point[1]", place("coupler_point", 1), -90, 90)};
  study.variables[0].logarithmic = true;
  study.samples = 9000;
  study.metrics = {"type",         "transmission_angle_deg.acute_min",
                   "curve_length", "curve_width",
                   "curve_height", "slenderness",
                   "size"};
  study.objectives = {{"curve_length", true}};
  set_columns(sample);
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  while (sample.rows.total < 5000) {
    const double crank = 15 * std::pow(4, uniform(0, 1)), coupler = uniform(30, 160),
                 rocker = uniform(30, 160), u = uniform(-60, 120), v = uniform(-90, 90);
    const FourBar linkage{{0, 0}, {100, 0}, crank, coupler, rocker, Assembly::open, Vec2d{u, v}};
    const CurveSize size = curve_size(linkage);
    if (size.length == 0) continue;
    const double transmission = least_transmission(linkage);
    Cell angle;
    if (transmission > 0) angle = transmission;
    add(sample,
        {crank, coupler, rocker, u, v, type_of(linkage), angle, size.length, size.width,
         size.height, size.width / std::max(size.height, 1e-3), crank + coupler + rocker + 100},
        size.length > 560);
  }
  sample.document = document(sample, 9000);
  return sample;
}

/// Coupler points on a grid for each of four linkages.
SampleStudy atlas() {
  SampleStudy sample{.name = "atlas", .study = {}, .rows = {}, .document = {}};
  Study& study = sample.study;
  study.title = "Atlas of coupler curves";
  study.base = "unit-crank.toml";
  study.base_text = kFourBar;
  study.variables = {grid("mechanism.coupler", link("coupler"), 90, 120, 2),
                     grid("mechanism.rocker", link("rocker"), 75, 100, 2),
                     grid("mechanism.coupler_point[0]", place("coupler_point", 0), -40, 120, 5),
                     grid("mechanism.coupler_point[1]", place("coupler_point", 1), -60, 60, 5)};
  study.metrics = {"curve_length", "curve_width"};
  set_columns(sample);
  for (const double coupler : study.variables[0].values) {
    for (const double rocker : study.variables[1].values) {
      for (const double u : study.variables[2].values) {
        for (const double v : study.variables[3].values) {
          const CurveSize size =
              curve_size({{0, 0}, {100, 0}, 30, coupler, rocker, Assembly::open, Vec2d{u, v}});
          add(sample, {coupler, rocker, u, v, size.length, size.width});
        }
      }
    }
  }
  sample.document = document(sample, 100);
  return sample;
}

/// Synthesis for a row of bounds, some designs failed, stopped early; markup in every text.
SampleStudy path_study() {
  const std::string text =
      "</script><script>document.title='injected'</script><img src=x onerror=alert(1)> \u2028 & "
      "<b>";
  SampleStudy sample{.name = "hostile", .study = {}, .rows = {}, .document = {}};
  Study& study = sample.study;
  study.title = text;
  study.base = text;
  study.base_text =
      "# " + text + "\nkind = \"path-generation\"\n[bounds]\ncrank = [1, 60]\nframe = [10, 80]\n";
  study.variables = {grid("bounds.crank[1]", {"bounds", "crank", std::size_t{1}}, 20, 60, 9),
                     grid("bounds.frame[1]", {"bounds", "frame", std::size_t{1}}, 40, 80, 5)};
  study.metrics = {"error.rms", "class", text};
  study.objectives = {{"error.rms", false}};
  study.keep_all = true;
  set_columns(sample);
  for (const double crank : study.variables[0].values) {
    for (const double frame : study.variables[1].values) {
      const bool failed = crank + frame > 120;
      Cell error, type, word = text;
      if (!failed) {
        error = 0.001 * std::pow(10, crank / 20) + frame / 500;
        type = std::string(crank > 40 ? "double-crank" : "crank-rocker");
      }
      add(sample, {crank, frame, error, type, word}, crank == 20 && frame == 40,
          failed ? RunStatus::no_solution : RunStatus::solved);
    }
  }
  sample.document = document(sample, 90);
  sample.document["status"] = "interrupted";
  sample.document["counts"]["evaluated"] = 45;
  sample.document["study"]["title"] = text;
  sample.document["notes"] = {text};
  return sample;
}

SampleStudy nothing_kept() {
  SampleStudy sample = crank_rockers();
  sample.name = "empty";
  sample.study.title = "A study without rows";
  sample.rows = {.columns = sample.rows.columns,
                 .ids = {},
                 .statuses = {},
                 .best = {},
                 .cells = {},
                 .total = 0};
  sample.document = document(sample, 896);
  return sample;
}

ordered_json pair(const Vec2d& p) {
  return {p.x, p.y};
}

ordered_json poses_of(const FourBar& linkage) {
  ordered_json angles = ordered_json::array(), points = ordered_json::array();
  const Motion motion(linkage);
  for (int i = 0; i < 24; ++i) {
    // The first is where a linkage that all but folds flat does so.
    const double angle = i == 0 ? frame_angle(linkage) + kPi : -3 + 0.26 * i;
    angles.push_back(angle);
    const auto pose = motion.at(angle);
    if (!pose) {
      points.push_back(nullptr);
      continue;
    }
    const auto& [b, c, p, rocker, transmission] = *pose;
    points.push_back({b.x, b.y, c.x, c.y, p->x, p->y});
  }
  return {{"linkage",
           {{"fixed_pivots", {pair(linkage.pivot_a), pair(linkage.pivot_d)}},
            {"crank", linkage.crank},
            {"coupler", linkage.coupler},
            {"rocker", linkage.rocker},
            {"assembly", linkage.assembly == Assembly::open ? "open" : "crossed"},
            {"coupler_point", pair(*linkage.coupler_point)}}},
          {"angles", angles},
          {"points", points}};
}

}  // namespace

std::vector<SampleStudy> sample_studies() {
  return {crank_rockers(), sampled_four_bars(), atlas(), path_study(), nothing_kept()};
}

nlohmann::ordered_json sample_poses() {
  std::mt19937_64 random(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  ordered_json all = ordered_json::array();
  for (int i = 0; i < 300; ++i) {
    FourBar linkage{.pivot_a = {uniform(-5, 5), uniform(-5, 5)},
                    .pivot_d = {uniform(6, 9), uniform(-5, 5)},
                    .crank = uniform(0.5, 6),
                    .coupler = uniform(0.5, 12),
                    .rocker = uniform(0.5, 12),
                    .assembly = i % 2 ? Assembly::open : Assembly::crossed,
                    .coupler_point = Vec2d{uniform(-5, 5), uniform(-5, 5)}};
    // Every tenth folds flat but for a hair.
    if (i % 10 == 0) {
      linkage.rocker = std::abs(linkage.crank + lengths(linkage).frame - linkage.coupler) +
                       std::pow(10, uniform(-9, -3));
    }
    all.push_back(poses_of(linkage));
  }
  return all;
}
