/// @file When a load acts.
#pragma once

namespace cognate::problems {

/// `advance`: while the body it acts on moves in its positive sense (along its guide, or
/// counter-clockwise), `retreat` (written "return"): in the negative sense.
enum class LoadSense { always, advance, retreat };

}  // namespace cognate::problems
