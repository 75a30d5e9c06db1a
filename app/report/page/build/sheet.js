// The part of the plane to build in, in millimetres.
export const BUILD_SHEET = { x0: -60, y0: -42, x1: 60, y1: 42 };
