#include "problems/mechanism/drawn/read_drawn_chain.hpp"

#include <iterator>
#include <utility>

#include "problems/mechanism/drawn/check_drawing.hpp"
#include "problems/mechanism/drawn/describe_drawing.hpp"
#include "problems/mechanism/drawn/read_drawing.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/mechanism/write_mechanism.hpp"

namespace cognate::problems::reading {
namespace {

/// The dimensions of a drawing without faults; empty, with a fault, where it is no mechanism.
std::optional<DescribedDrawing> described(const Drawing& drawing, TableReader& place) {
  const std::size_t before = place.faults().size();
  const DrawnGroups groups = groups_of(drawing, drawing.driven);
  check_drawing(drawing, groups, place);
  if (place.faults().size() != before) return std::nullopt;
  return describe(drawing, groups, place.faults());
}

/// Of a drawing that is no mechanism what other tables refer to: the names of its points, and
/// whether a slider drives.
Chain unfinished(const Drawing& drawing) {
  Chain chain;
  chain.names.incomplete = true;
  for (const DrawnJoint& joint : drawing.joints) {
    chain.names.announce(joint.name);
    const bool drives = drawing.driven > 0 && joins(joint, drawing.driven) && joins(joint, 0);
    if (drives && joint.direction) chain.mechanism.drive = DrivingSlider<double>{};
  }
  return chain;
}

/// The chain as `type = "chain"` describes it by drive and dyads. What its reader refuses, such as
/// lengths beyond all measure, is a fault of the joints in `place`.
Chain chain_of(const DescribedDrawing& described, TableReader& place) {
  NamedMechanism named;
  named.description = described.chain;
  named.extra_points = described.points;
  const Table written = mechanism_writer(named).take();
  const Table nothing;
  FaultList faults;
  TableReader document(nothing, faults);
  TableReader mechanism(written, faults);
  Chain chain = read_chain(document, mechanism);
  const auto sorted = std::move(faults).sorted();  // the others follow from the first
  if (!sorted.empty()) place.fault("joint", "as drawn: " + sorted.front().message);
  chain.drawn = described.drive;
  return chain;
}

/// `[[point]]` beside the joints.
void add_points(TableReader& place, Chain& chain) {
  auto waiting = read_extra_points(place, chain.names);
  auto placed = place_extra_points(waiting, chain.names);
  std::ranges::move(placed, std::back_inserter(chain.points));
  fault_unplaced(waiting, chain.names, place.faults());
}

}  // namespace

Chain read_drawn_chain(TableReader& document, TableReader& mechanism) {
  const std::size_t before = document.faults().size();
  const Drawing drawing = read_drawing(document, mechanism);
  TableReader& place = holder("joint", document, mechanism);
  const bool is_sound = document.faults().size() == before;
  const auto dimensions = is_sound ? described(drawing, place) : std::nullopt;
  Chain chain = dimensions ? chain_of(*dimensions, place) : unfinished(drawing);
  add_points(holder("point", document, mechanism), chain);
  return chain;
}

}  // namespace cognate::problems::reading
