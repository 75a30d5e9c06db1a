#include <fmt/core.h>

#include "tests/stress/ranges/single_loop.hpp"

namespace cognate::stress {

std::string file_of(const SingleLoop& l) {
  const std::string pivots =
      fmt::format("fixed_pivots = [[0, 0], [{:.17g}, {:.17g}]]\n", l.frame_x, l.frame_y);
  const std::string slide =
      fmt::format("offset = {:.17g}\ndirection_deg = {:.17g}\n", l.offset, l.direction);
  const std::string crank = fmt::format("crank = {:.17g}\n", l.crank);
  const std::string assembly = fmt::format("assembly = \"{}\"\n", l.side > 0 ? "open" : "crossed");
  const auto with_type = [](const char* type) { return fmt::format("type = \"{}\"\n", type); };
  std::string text;
  switch (l.type) {
    case LoopType::four_bar:
      text = with_type("four-bar") + pivots + crank +
             fmt::format("coupler = {:.17g}\nrocker = {:.17g}\n", l.coupler, l.rocker) + assembly;
      break;
    case LoopType::slider_crank:
    case LoopType::fixed_block:
      text = with_type(l.type == LoopType::fixed_block ? "fixed-block" : "slider-crank") + crank +
             fmt::format("coupler = {:.17g}\n", l.coupler) + slide + assembly;
      break;
    case LoopType::guide_bar:
    case LoopType::oscillating_block:
      text = with_type(l.type == LoopType::guide_bar ? "guide-bar" : "oscillating-block") + pivots +
             crank + fmt::format("offset = {:.17g}\n", l.offset) + (l.offset == 0 ? "" : assembly);
      break;
    case LoopType::scotch_yoke:
      text = with_type("scotch-yoke") + crank + slide + fmt::format("slot_deg = {:.17g}\n", l.slot);
      break;
    case LoopType::tangent_generator:
      text = with_type("tangent-generator") + slide;
      break;
    case LoopType::elliptic_trammel:
      text = with_type("elliptic-trammel") +
             fmt::format("length = {:.17g}\ndirection_deg = {:.17g}\nsecond_line_deg = {:.17g}\n",
                         l.crank, l.direction, l.slot);
      break;
    case LoopType::oldham_coupling:
      text = with_type("oldham-coupling") + pivots + fmt::format("slot_deg = {:.17g}\n", l.slot);
      break;
  }
  return "kind = \"analysis\"\n[mechanism]\n" + text +
         fmt::format(
             "[drive]\nstart_deg = {:.17g}\nend_deg = {:.17g}\nsteps = 7\n[output]\n"
             "velocity = false\nacceleration = false\n",
             l.start, l.end);
}

}  // namespace cognate::stress
