/// @file The layers of links by brute force, sharing no code with the search: own closures by
/// angles and circles, positions sampled, own distances, and every assignment tried.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/layers/layers.hpp"
#include "problems/mechanism/named_mechanism.hpp"

namespace cognate::test {

/// What the samples say of parts of one layer: links by body, pins by place.
class BruteLayers {
 public:
  /// At `count` + 1 positions of the drive from `from` to `to`. Cranks with RRR, RRP and RPR alone.
  BruteLayers(const problems::NamedMechanism& mechanism, const problems::LayerSizes& sizes,
              double from, double to, int count);

  /// The worst interference of an assignment (a layer from 1 for each body by name; others have
  /// none): how much closer parts of one layer come than they may. Negative where none does.
  double interference(const problems::LayerResult& result) const;

  /// The fewest layers by trying all assignments; empty where there is none in as many as links.
  std::optional<int> fewest() const;

  /// Whether the sampled parts come closer than they may at the place that `conflict` names, up to
  /// `slack`, and at no sample before it by more than `slack`.
  bool confirms(const problems::LayerConflict& conflict, double slack) const;

 private:
  struct Pose {
    double x = 0, y = 0, angle = 0;
  };
  struct Part {
    std::string name;
    int body = 0;
    std::vector<Vec2d> corners;
    double radius = 0;
    std::vector<int> joins;  ///< of a pin: links, −1 for the base
  };

  std::vector<Pose> poses(double drive) const;
  void add_parts(const problems::LayerSizes& sizes);
  double distance(const Part& a, const Part& b, const std::vector<Pose>& at) const;
  double least(const Part& a, const Part& b) const;
  bool is_allowed(const std::vector<int>& layers) const;
  void measure();

  const problems::NamedMechanism& mechanism_;
  double clearance_;
  std::vector<double> drives_;
  std::vector<std::vector<Pose>> samples_;
  std::vector<Part> links_, pins_;
  std::vector<std::vector<double>> link_link_, pin_link_, pin_pin_;  ///< least room; < 0 collides
};

}  // namespace cognate::test
