#include "problems/mechanism/dimensions.hpp"

#include <cmath>
#include <variant>

#include "problems/mechanism/mechanism_types.hpp"

namespace cognate::problems {
namespace {

using List = std::vector<Dimension>;

double distance(const Vec2d& from, const Vec2d& to) {
  return std::hypot(to.x - from.x, to.y - from.y);
}

/// Lengths of links come first, then the frame, then offsets.
enum class Rank { length, frame, offset };

/// Appends what a key of a type holds, if it is of rank `wanted`.
template <class Type>
struct AddDimension {
  const DimensionKey<Type>& key;
  const Type& mechanism;
  Rank wanted;
  List& list;

  void operator()(const LengthKey<Type>& length) const {
    add(Rank::length, key.name, mechanism.*length.of);
  }
  void operator()(const PivotsKey<Type>& pivots) const {
    add(Rank::frame, "frame", distance(mechanism.*pivots.first, mechanism.*pivots.second));
  }
  void operator()(const OffsetKey<Type>& offset) const {
    add(Rank::offset, key.name, mechanism.*offset.of);
  }
  void operator()(const NonzeroKey<Type>& offset) const {
    add(Rank::offset, key.name, mechanism.*offset.of);
  }
  template <class Other>
  void operator()(const Other&) const {}

 private:
  void add(Rank rank, std::string_view name, double value) const {
    if (rank == wanted) list.push_back({std::string(name), value});
  }
};

template <class Type>
List dimensions_of(const Type& mechanism) {
  List list;
  for (const Rank rank : {Rank::length, Rank::frame, Rank::offset}) {
    for (const auto& key : TypeTraits<Type>::kKeys) {
      std::visit(AddDimension<Type>{key, mechanism, rank, list}, key.holds);
    }
  }
  return list;
}

List dimensions_of(const ChainDescription& chain) {
  List list;
  if (const auto* crank = std::get_if<CrankDescription>(&chain.drive)) {
    list.push_back({crank->name, crank->length});
  }
  if (const auto* cylinder = std::get_if<CylinderDescription>(&chain.drive)) {
    list.push_back({cylinder->names[2], cylinder->length});
  }
  for (const auto& dyad : chain.dyads) {
    for (std::size_t i = 0; i < dyad.lengths.size(); ++i) {
      list.push_back({dyad.names[i], dyad.lengths[i]});
    }
  }
  if (chain.pivots.size() == 2) {
    list.push_back({"frame", distance(chain.pivots[0].at, chain.pivots[1].at)});
  }
  return list;
}

}  // namespace

std::vector<Dimension> main_dimensions(const NamedMechanism& mechanism) {
  List list = std::visit([](const auto& described) { return dimensions_of(described); },
                         mechanism.description);
  if (mechanism.type() != MechanismType::chain) return list;
  for (const auto& point : mechanism.extra_points) {
    list.push_back({point.on.front(), std::hypot(point.at.x, point.at.y)});
  }
  return list;
}

}  // namespace cognate::problems
