// One position of a four-bar: where its points are, and its transmission angle.
#include <cognate/analysis.hpp>
#include <cognate/units.hpp>
#include <cstdio>

using namespace cognate::literals;

int main() {
  // Stretched back over the frame the crank puts B at (-1, 0): a triangle of sides 13, 14 and 15
  // stands over BD.
  const cognate::FourBar linkage{.pivot_a = {0, 0},
                                 .pivot_d = {13, 0},
                                 .crank = 1,
                                 .coupler = 13,
                                 .rocker = 15,
                                 .coupler_point = cognate::Vec2d{6.5, 0}};
  const auto pose = cognate::Motion(linkage).at(180_deg);
  if (!pose) return 1;  // it does not close there
  std::printf("B = (%.3f, %.3f), C = (%.3f, %.3f)\n", pose->b.x, pose->b.y, pose->c.x, pose->c.y);
  std::printf("coupler point (%.3f, %.3f)\n", pose->coupler_point->x, pose->coupler_point->y);
  std::printf("transmission angle %.3f degrees\n", pose->transmission_angle / 1_deg);
}

// B = (-1.000, 0.000), C = (4.000, 12.000)
// coupler point (1.500, 6.000)
// transmission angle 59.490 degrees
