/// @file The drawing of a mechanism that is given by its dimensions.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "problems/mechanism/drawn/drawing.hpp"
#include "problems/mechanism/named_mechanism.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems {

/// The joints and points of `mechanism` where it stands at `drive` (an angle in radians, or a
/// slider's displacement). Links are numbered as the bodies; a slider that has the name of its pin
/// takes another. A sentence where it cannot be assembled there, or where no link of the frame
/// drives it: a trammel, a cylinder.
tl::expected<reading::Drawing, std::string> drawing_of(const NamedMechanism& mechanism,
                                                       double drive);

/// `[mechanism]` with its joints, from which a file is read.
reading::TableWriter drawing_writer(const reading::Drawing& drawing);

}  // namespace cognate::problems
