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

std::optional<DescribedDrawing> read_described(TableReader& document, TableReader& mechanism) {
  const auto drawing = read_drawing(document, mechanism);
  if (!drawing) return std::nullopt;
  TableReader& place = holder("joint", document, mechanism);
  const std::size_t before = place.faults().size();
  const DrawnGroups groups = groups_of(*drawing, drawing->driven);
  check_drawing(*drawing, groups, place);
  if (place.faults().size() != before) return std::nullopt;
  return describe(*drawing, groups, place.faults());
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
  const auto described = read_described(document, mechanism);
  Chain chain;
  if (described) {
    chain = chain_of(*described, holder("joint", document, mechanism));
  } else {
    chain.names.incomplete = true;
  }
  add_points(holder("point", document, mechanism), chain);
  return chain;
}

}  // namespace cognate::problems::reading
