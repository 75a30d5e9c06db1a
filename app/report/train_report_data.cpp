#include "app/report/train_report_data.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/report/drawn_number.hpp"
#include "app/report/quantity_json.hpp"
#include "problems/train/resolve.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::GearTrainDesign;
using problems::ResolvedTrain;
using train::kFrame;

/// A pitch circle. `centre` is the axis of its carrier, or its own on the frame.
struct PitchCircle {
  int member = 0, carrier = kFrame, copies = 1, teeth = 0;
  double radius = 0, orbit = 0;
  Vec2d centre;
  bool internal = false;

  double reach() const { return orbit + radius; }
};

/// The pitch circles of a train, its epicyclic sets and what is on fixed axes side by side.
class TrainPicture {
 public:
  explicit TrainPicture(const ResolvedTrain& train) : train_(train) {}

  std::vector<PitchCircle> circles() && {
    std::vector<int> carriers;
    for (const auto& planet : train_.planets) {
      if (std::ranges::find(carriers, planet.carrier) == carriers.end()) {
        carriers.push_back(planet.carrier);
      }
    }
    for (const int carrier : carriers) add_set(carrier);
    add_fixed_axes();
    return std::move(circles_);
  }

 private:
  const train::Planet* planet(int member) const {
    const auto found = std::ranges::find(train_.planets, member, &train::Planet::member);
    return found == train_.planets.end() ? nullptr : &*found;
  }

  double orbit_of(const train::Planet& planet) const {
    const auto radii = orbit_radii(planet, train_.sized, train_.planets);
    return radii.empty() ? 0 : radii.front();
  }

  PitchCircle circle_of(const train::SizedMesh& sized, std::size_t side) const {
    const auto& mesh = sized.mesh;
    PitchCircle circle{.member = mesh.gears[side],
                       .carrier = mesh.carrier,
                       .teeth = mesh.teeth[side],
                       .radius = 0.5 * sized.module * mesh.teeth[side]};
    circle.internal = mesh.sense > 0 && !sized.is_bevel && mesh.teeth[side] > mesh.teeth[1 - side];
    if (const auto* own = planet(circle.member)) {
      circle.copies = own->count;
      circle.orbit = orbit_of(*own);
    }
    return circle;
  }

  void add(PitchCircle circle) {
    const auto is_same = [&](const PitchCircle& other) {
      return other.member == circle.member && other.carrier == circle.carrier &&
             other.radius == circle.radius && other.internal == circle.internal;
    };
    if (std::ranges::none_of(circles_, is_same)) circles_.push_back(circle);
  }

  void add_set(int carrier) {
    double reach = 0;
    const auto first = circles_.size();
    for (const auto& sized : train_.sized) {
      if (sized.mesh.carrier != carrier) continue;
      for (const std::size_t side : {0U, 1U}) {
        add(circle_of(sized, side));
        reach = std::max(reach, circle_of(sized, side).reach());
      }
    }
    place_beside(first, reach, reach);
  }

  /// Those from `first` on, which reach so far to the left and right of their own origin.
  void place_beside(std::size_t first, double left, double right) {
    const double gap = right_end_ > 0 ? 0.15 * (left + right) : 0;
    for (auto circle = circles_.begin() + std::ptrdiff_t(first); circle != circles_.end();
         ++circle) {
      circle->centre.x += right_end_ + gap + left;
    }
    right_end_ += gap + left + right;
  }

  /// Shafts in mesh on fixed axes, one beside the other as far as meshes lead.
  void add_fixed_axes() {
    std::map<int, double> places;
    std::size_t left = 0;
    for (const auto& sized : train_.sized) left += sized.mesh.carrier == kFrame ? 1 : 0;
    std::vector<bool> done(train_.sized.size(), false);
    while (left > 0) {
      const auto first = circles_.size();
      double from = 0, to = 0;
      places.clear();
      for (std::size_t step = 0; step < train_.sized.size(); ++step) {
        for (std::size_t k = 0; k < train_.sized.size(); ++k) {
          const auto& sized = train_.sized[k];
          const auto& [one, other] = sized.mesh.gears;
          if (done[k] || sized.mesh.carrier != kFrame) continue;
          if (!places.empty() && !places.contains(one) && !places.contains(other)) continue;
          if (places.empty()) places[one] = 0;
          const double distance = centre_distance(sized);
          if (!places.contains(other)) places[other] = places[one] + distance;
          if (!places.contains(one)) places[one] = places[other] + distance;
          done[k] = true;
          --left;
          for (const std::size_t side : {0U, 1U}) {
            PitchCircle circle = circle_of(sized, side);
            circle.centre.x = places[sized.mesh.gears[side]];
            from = std::min(from, circle.centre.x - circle.radius);
            to = std::max(to, circle.centre.x + circle.radius);
            add(circle);
          }
        }
      }
      place_beside(first, -from, to);
    }
  }

  const ResolvedTrain& train_;
  std::vector<PitchCircle> circles_;
  double right_end_ = 0;
};

ordered_json circles_json(const ResolvedTrain& train) {
  ordered_json list = ordered_json::array();
  for (const PitchCircle& circle : TrainPicture(train).circles()) {
    list.push_back({{"member", circle.member},
                    {"carrier", circle.carrier},
                    {"copies", circle.copies},
                    {"teeth", circle.teeth},
                    {"radius", drawn(circle.radius)},
                    {"orbit", drawn(circle.orbit)},
                    {"x", drawn(circle.centre.x)},
                    {"internal", circle.internal}});
  }
  return list;
}

ordered_json members_json(const GearTrainDesign& design) {
  const auto value = [](const std::optional<double>& x) {
    return x ? drawn(*x) : ordered_json(nullptr);
  };
  ordered_json list = ordered_json::array();
  for (const auto& member : design.members) {
    list.push_back({{"name", member.name},
                    {"role", member.role},
                    {"exact", member.speed_exact},
                    {"speed", drawn(member.speed)},
                    {"relative", value(member.relative_speed)},
                    {"torque", value(member.torque)},
                    {"power", value(member.power)},
                    {"inertia", value(member.equivalent_inertia)}});
  }
  return list;
}

const problems::TrainState* state_of(const GearTrainDesign& design) {
  const auto& states = design.settled.states;
  const auto found = std::ranges::find(states, design.state, &problems::TrainState::name);
  return found == states.end() ? nullptr : &*found;
}

}  // namespace

ordered_json train_report_data(const problems::GearTrainResult& result) {
  ordered_json designs = ordered_json::array();
  for (const auto& design : result.designs) {
    const ResolvedTrain train = resolved(design.settled, state_of(design));
    ordered_json meshes = ordered_json::array();
    for (const auto& mesh : design.settled.meshes) meshes.push_back(mesh.teeth);
    designs.push_back({{"state", design.state},
                       {"input", train.inputs.empty() ? 0 : train.inputs.front()},
                       {"members", members_json(design)},
                       {"circles", circles_json(train)},
                       {"teeth", meshes},
                       {"metrics", quantities_json(design.metrics)},
                       {"constraints", constraints_json(design.constraints)},
                       {"origin", design.origin}});
  }
  return {{"kind", "train"}, {"designs", designs}};
}

}  // namespace cognate::app
