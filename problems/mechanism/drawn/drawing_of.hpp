/// @file The drawing of a mechanism that is given by its dimensions.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems {

/// A drawing, and the link that each body of the mechanism is there.
struct DrawnMechanism {
  reading::Drawing drawing;
  std::vector<std::size_t> link_of_body;
};

/// The joints and points of `mechanism` where it stands at `drive` (an angle in radians, or a
/// slider's displacement). A slider that has the name of its pin takes another. A sentence where it
/// cannot be assembled there, or where no link of the frame drives it: a trammel, a cylinder.
tl::expected<DrawnMechanism, std::string> drawing_of(const NamedMechanism& mechanism, double drive);

/// `[mechanism]` with its joints, from which a file is read.
reading::TableWriter drawing_writer(const reading::Drawing& drawing);

}  // namespace cognate::problems
