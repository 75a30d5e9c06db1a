#include "problems/evaluation/as_drawn.hpp"

#include <algorithm>
#include <utility>

#include "analysis/mechanism/followed_motion.hpp"
#include "problems/mechanism/drawn/drawing_of.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"

namespace cognate::problems {
namespace {

using reading::Entry;
using reading::Table;

/// A mechanism, and a position of its drive.
struct Standing {
  const NamedMechanism& mechanism;
  double drive = 0;
};

/// Places of bodies of one mechanism as those of bodies of another that stands in the same
/// position.
class Redrawn {
 public:
  Redrawn(const Standing& before, const Standing& after, const reading::Drawing& drawing)
      : before_(before.mechanism.mechanism), after_(after.mechanism.mechanism) {
    move_followed(before_, before.drive);
    move_followed(after_, after.drive);
    const auto& bodies = after.mechanism.bodies;
    for (const std::string& link : drawing.links) {
      const auto body = std::ranges::find(bodies, link);
      body_.push_back(static_cast<int>(body - bodies.begin()));
    }
  }

  Attached<double> place(const Attached<double>& at) const {
    const int body = body_[static_cast<std::size_t>(at.body)];
    const auto& to = after_.bodies()[static_cast<std::size_t>(body)];
    return {body, conj(to.direction) * (before_.point(at)[0] - to.origin[0])};
  }

  std::vector<Inertia> inertias(const std::vector<Inertia>& given) const {
    std::vector<Inertia> all(given.size());
    for (std::size_t i = 1; i < given.size(); ++i) {
      const auto [body, centre] = place({static_cast<int>(i), given[i].centre});
      const bool heavy = given[i].mass > 0;
      all[static_cast<std::size_t>(body)] = {given[i].mass, heavy ? centre : Vec2d{},
                                             given[i].moment};
    }
    return all;
  }

 private:
  MechanismMotion<0> before_, after_;
  std::vector<int> body_;
};

/// The mechanism that a reader makes of the drawing, or its first fault.
tl::expected<NamedMechanism, std::string> read_again(const Table& mechanism) {
  const Table nothing;
  reading::FaultList faults;
  reading::TableReader document(nothing, faults), table(mechanism, faults);
  auto read = reading::read_whole_mechanism(document, table);
  if (!faults.empty()) {
    return tl::unexpected("where its drive begins, " + std::move(faults).sorted().front().message);
  }
  return std::move(read->mechanism);
}

/// The problem with another description of its mechanism, whose drive counts from where it begins
/// if it slides.
AnalysisProblem with(const NamedMechanism& drawn, const reading::Drawing& drawing,
                     const AnalysisProblem& given) {
  AnalysisProblem problem = given;
  const double zero = drive_slides(given) ? given.drive.start : 0;
  problem.drive.start -= zero;
  problem.drive.end -= zero;
  problem.mechanism = drawn;
  const Redrawn redrawn({given.mechanism, given.drive.start}, {drawn, problem.drive.start},
                        drawing);
  problem.inertias = redrawn.inertias(given.inertias);
  for (LoadRule& load : problem.loads) {
    load.at = redrawn.place(load.at);
    if (!load.between) continue;
    load.between->first -= zero;
    load.between->second -= zero;
  }
  problem.output = {};  // what names points by their numbers
  problem.tolerances.reset();
  problem.layers.reset();
  return problem;
}

/// The joint of the drawing at a place of a body; null where there is none.
const reading::DrawnJoint* joint_at(const reading::Drawing& drawing, const Attached<double>& at,
                                    const MechanismMotion<0>& motion) {
  constexpr double kSame = 1e-12;  // of the drawing: rounding of places in other axes
  double size = 0;
  for (const auto& joint : drawing.joints) size = std::max(size, norm1(joint.at));
  const Vec2d place = motion.point(at)[0];
  const auto link = static_cast<std::size_t>(at.body);
  const auto joint = std::ranges::find_if(drawing.joints, [&](const reading::DrawnJoint& other) {
    return !other.direction && reading::joins(other, link) &&
           norm(other.at - place) <= kSame * size;
  });
  return joint == drawing.joints.end() ? nullptr : &*joint;
}

/// Loads at joints by the names of these.
void name_joints_of_loads(const AnalysisProblem& problem, const reading::Drawing& drawing,
                          Table& document) {
  const auto entry = std::ranges::find(document, "load", &Entry::key);
  if (entry == document.end()) return;
  MechanismMotion<0> motion(problem.mechanism.mechanism);
  move_followed(motion, problem.drive.start);
  auto& loads = std::get<reading::Array>(entry->node.value);
  for (std::size_t i = 0; i < problem.loads.size(); ++i) {
    const auto* joint = joint_at(drawing, problem.loads[i].at, motion);
    if (!joint) continue;
    auto& load = std::get<Table>(loads[i].value);
    std::erase_if(load, [](const Entry& key) { return key.key == "at"; });
    std::ranges::find(load, "on", &Entry::key)->node = reading::node(joint->name);
  }
}

}  // namespace

tl::expected<Table, std::string> written_as_drawn(const AnalysisProblem& problem) {
  const auto drawn = drawing_of(problem.mechanism, problem.drive.start);
  if (!drawn) return tl::unexpected(drawn.error());
  const Table mechanism = drawing_writer(*drawn).take();
  const auto read = read_again(mechanism);
  if (!read) return tl::unexpected(read.error());
  auto written = KindTraits<AnalysisProblem>::written(with(*read, *drawn, problem));
  const auto entry = std::ranges::find(written.document, "mechanism", &Entry::key);
  entry->node = reading::node(mechanism);
  name_joints_of_loads(problem, *drawn, written.document);
  std::erase_if(written.document, [](const Entry& table) { return table.key == "output"; });
  return std::move(written.document);
}

}  // namespace cognate::problems
