#include "problems/mechanism/read_whole_mechanism.hpp"

#include <fmt/core.h>

#include <utility>
#include <variant>

#include "problems/mechanism/read_chain.hpp"
#include "problems/mechanism/read_extra_points.hpp"
#include "problems/mechanism/read_simple_mechanism.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kType = "type";
constexpr std::string_view kOutput = "output";

std::optional<MechanismType> read_type(TableReader& mechanism) {
  if (mechanism.has(kType)) return mechanism.choice<MechanismType>(kType);
  std::vector<std::string_view> allowed;
  for (const auto& named : names<MechanismType>()) allowed.push_back(named.name);
  mechanism.fault(kType, fmt::format("is missing; allowed are {}", quoted_list(allowed)));
  return std::nullopt;
}

WholeMechanism read_simple(TableReader& document, TableReader& mechanism, MechanismType type) {
  WholeMechanism read;
  auto whole = read_simple_mechanism(mechanism, type);
  if (whole.sound) {
    read.names = PartNames(std::move(whole.parts));
  } else {  // of the points only the names are right
    read.names = PartNames({std::move(whole.parts.bodies), {}});
    for (const PointOnLink& point : whole.parts.points) read.names.announce(point.name);
    read.names.incomplete = true;
  }
  read.mechanism.mechanism = std::move(whole.mechanism);
  read.mechanism.description = std::move(whole.description);
  auto points = read_extra_points(holder("point", document, mechanism), read.names);
  read.mechanism.extra_points = place_extra_points(points, read.names);
  fault_unplaced(points, read.names, document.faults());
  read.mechanism.output = whole.output;
  return read;
}

/// The body that `mechanism.output` names, else the last.
int read_output_body(TableReader& mechanism, const WholeMechanism& chain) {
  const Mechanism<double>& bodies = chain.mechanism.mechanism;
  const int last = body_count(bodies) - 1;
  if (!mechanism.has(kOutput)) return last;
  const auto mention = read_mention(mechanism, kOutput);
  const auto body = mention ? find_body(chain.names, *mention, mechanism.faults()) : std::nullopt;
  if (!body || chain.names.incomplete) return last;
  if (*body > 1) return *body;
  mechanism.fault(kOutput, fmt::format("is {}, which {}; expected a body that the drive moves",
                                       in_quotes(mention->name),
                                       *body == 0 ? "does not move" : "is the drive itself"));
  return last;
}

WholeMechanism read_chain_mechanism(TableReader& document, TableReader& mechanism) {
  Chain chain = read_chain(document, mechanism);
  WholeMechanism read;
  read.names = std::move(chain.names);
  read.drawn = chain.drawn;
  read.mechanism.mechanism = std::move(chain.mechanism);
  read.mechanism.description = std::move(chain.description);
  read.mechanism.extra_points = std::move(chain.points);
  read.mechanism.output = read_output_body(mechanism, read);
  return read;
}

WholeMechanism read_mechanism(TableReader& document, TableReader& mechanism, MechanismType type) {
  WholeMechanism read = type == MechanismType::chain ? read_chain_mechanism(document, mechanism)
                                                     : read_simple(document, mechanism, type);
  for (const Body& body : read.names.parts().bodies) read.mechanism.bodies.push_back(body.name);
  for (const PointOnLink& point : read.names.parts().points) {
    read.mechanism.points.push_back({point.name, point.on.front()});
  }
  return read;
}

}  // namespace

std::optional<WholeMechanism> read_whole_mechanism(TableReader& document, TableReader& mechanism) {
  const auto type = read_type(mechanism);
  if (!type) return std::nullopt;
  return read_mechanism(document, mechanism, *type);
}

PartNames unknown_parts(TableReader& document) {
  document.know({"pivot", "crank", "slider", "cylinder", "dyad", "joint", "point"});
  PartNames unknown;
  unknown.incomplete = true;
  return unknown;
}

bool is_slider_driven(const NamedMechanism& mechanism) {
  return driven_by_length(mechanism.mechanism.drive);
}

}  // namespace cognate::problems::reading
