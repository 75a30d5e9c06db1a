// A six-bar as data: a crank, the dyad that makes a four-bar of it, and a dyad whose slider the
// joint C drives along the x axis.
#include <cognate/analysis.hpp>
#include <cognate/units.hpp>
#include <cstdio>

using namespace cognate::literals;

int main() {
  cognate::Mechanism<double> six_bar;
  six_bar.drive = cognate::Crank<double>{.pivot = {0, 0}, .length = 1};
  // Bodies: 0 the frame, 1 the crank, 2 and 3 the first dyad's links from B and from D to C.
  six_bar.dyads.push_back(cognate::Rrr<double>{.first = {.body = 1, .at = {1, 0}},
                                               .second = {.body = 0, .at = {13, 0}},
                                               .first_length = 13,
                                               .second_length = 15});
  // 4 and 5: a rod from C, at the end of body 3, and its slider on the x axis.
  six_bar.dyads.push_back(cognate::Rrp<double>{
      .point = {.body = 3, .at = {15, 0}}, .length = 13, .guide = {.body = 0}});

  cognate::MechanismMotion<1> motion(six_bar);
  if (!motion.move_to(180_deg)) return 1;
  const auto joint = motion.point({.body = 3, .at = {15, 0}});
  const auto slider = motion.point({.body = 5, .at = {0, 0}});
  std::printf("C = (%.3f, %.3f), slider at %.3f\n", joint[0].x, joint[0].y, slider[0].x);
  // The rod does not stretch: what C moves along it, the slider does, dx (9 - 4) = dC (5, -12).
  std::printf("slider by the crank's angle %.6f, by the rod %.6f\n", slider[1].x,
              (5 * joint[1].x - 12 * joint[1].y) / 5);
}

// C = (4.000, 12.000), slider at 9.000
// slider by the crank's angle 0.685714, by the rod 0.685714
