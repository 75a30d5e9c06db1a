#include "problems/mechanism/drawn/drawing_of.hpp"

#include <algorithm>
#include <utility>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/angle.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::problems {
namespace {

using reading::DrawnJoint;

bool drives_from_frame(const Drive<double>& drive) {
  return std::holds_alternative<Crank<double>>(drive) ||
         std::holds_alternative<DrivingSlider<double>>(drive);
}

tl::unexpected<std::string> refusal(const char* sentence) {
  return tl::unexpected<std::string>(sentence);
}

class Draughtsman {
 public:
  explicit Draughtsman(const NamedMechanism& mechanism)
      : mechanism_(mechanism), motion_(mechanism.mechanism), names_(joint_names(mechanism)) {}

  tl::expected<reading::Drawing, std::string> draw(double drive) {
    if (!drives_from_frame(mechanism_.mechanism.drive)) {
      return refusal("the mechanism is driven by no link that has a joint with the frame");
    }
    if (!move_followed(motion_, drive)) {
      return refusal("the mechanism cannot be assembled where its drive begins");
    }
    add_joints();
    add_points();
    name_links();
    drawing_.driven = 1;
    return std::move(drawing_);
  }

 private:
  Vec2d place(const Attached<double>& at) const { return motion_.point(at)[0]; }

  DrawnJoint* find(const std::string& name) {
    auto& joints = drawing_.joints;
    const auto joint = std::ranges::find(joints, name, &DrawnJoint::name);
    return joint == joints.end() ? nullptr : &*joint;
  }

  static void join(DrawnJoint& joint, int body) {
    const auto link = static_cast<std::size_t>(body);
    if (!reading::joins(joint, link)) joint.of.push_back(link);
  }

  /// Pins at one place, which have one name, are one.
  void add_joints() {
    const JointList list = joints(mechanism_.mechanism);
    for (std::size_t i = 0; i < list.joints.size(); ++i) {
      const Joint& joint = list.joints[i];
      const bool slides = joint.type == JointType::prismatic;
      DrawnJoint* known = slides ? nullptr : find(names_[i]);
      if (!known) {
        DrawnJoint drawn{.name = names_[i], .of = {}, .at = place(joint.at), .where = {}};
        if (slides) {
          const auto& along = motion_.bodies()[static_cast<std::size_t>(joint.at.body)];
          drawn.direction = along.direction * joint.direction;
        }
        drawing_.joints.push_back(std::move(drawn));
        known = &drawing_.joints.back();
      }
      join(*known, joint.first);
      join(*known, joint.second);
    }
  }

  void add_points() {
    for (const NamedPoint& point : mechanism_.points) {
      if (point.at.body == 0 || find(point.name)) continue;
      drawing_.joints.push_back({.name = point.name,
                                 .of = {static_cast<std::size_t>(point.at.body)},
                                 .at = place(point.at),
                                 .where = {}});
    }
  }

  void name_links() {
    drawing_.links = mechanism_.bodies;
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
      std::string& name = drawing_.links[i];
      while (i > 0 && find(name)) name += "-link";
    }
  }

  const NamedMechanism& mechanism_;
  MechanismMotion<0> motion_;
  std::vector<std::string> names_;
  reading::Drawing drawing_;
};

}  // namespace

tl::expected<reading::Drawing, std::string> drawing_of(const NamedMechanism& mechanism,
                                                       double drive) {
  return Draughtsman(mechanism).draw(drive);
}

reading::TableWriter drawing_writer(const reading::Drawing& drawing) {
  using reading::node;
  reading::Array joints;
  for (const DrawnJoint& joint : drawing.joints) {
    reading::TableWriter table;
    table.set("name", joint.name);
    if (joint.direction) {
      table.set_deg("direction_deg", angle_of(*joint.direction));
    } else {
      table.set("at", joint.at);
    }
    std::vector<std::string> of;
    for (const std::size_t link : joint.of) of.push_back(drawing.links[link]);
    joints.push_back(node(table.set("of", of)));
  }
  reading::TableWriter mechanism;
  return mechanism.set("type", "chain")
      .set("driven", drawing.links[drawing.driven])
      .set("joint", joints);
}

}  // namespace cognate::problems
