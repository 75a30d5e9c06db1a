// Where on the sheet a function is drawn, and where linkages stand that generate it.

// In units of the sheet: the part of it that is seen, the diagram, below it the errors, and the stage of the linkage, on the right; below both in a
// narrow window.
const SIDE_BY_SIDE = { sheet: { x0: -60, y0: -42, x1: 60, y1: 42 }, diagram: { x0: -47, y0: -16, x1: 4, y1: 41 }, errors: { y0: -40, y1: -31 }, stage: { x0: 15, y0: -33, x1: 57, y1: 32 } };
const STACKED = { sheet: { x0: -40, y0: -66, x1: 40, y1: 66 }, diagram: { x0: -27, y0: 3, x1: 37, y1: 54 }, errors: { y0: -22, y1: -13 }, stage: { x0: -36, y0: -64, x1: 36, y1: -26 } };

// As the style sheets have it.
const narrow = typeof matchMedia === "undefined" ? null : matchMedia("(max-width: 39.99rem)");

export const layout = () => (narrow?.matches ? STACKED : SIDE_BY_SIDE);
export const onLayout = (act) => narrow?.addEventListener("change", act);

const BESIDE = 6;             // units beside the diagram within which a hand means its edge

const shareOf = (value, from, to) => (value - from) / (to - from);
const within = (share) => Math.max(0, Math.min(1, share));

// Where a pair [input, output] stands; `ranges`: of both, the second with its sign.
export function placeOf([input, output], [across, upwards]) {
  const { x0, y0, x1, y1 } = layout().diagram;
  return [x0 + (input / across) * (x1 - x0), y0 + (output / upwards) * (y1 - y0)];
}

// The shares of both ranges at a place, that of the nearest edge beside the diagram.
export function sharesOf([x, y]) {
  const { x0, y0, x1, y1 } = layout().diagram;
  return [within(shareOf(x, x0, x1)), within(shareOf(y, y0, y1))];
}

export function isNear([x, y]) {
  const { x0, y0, x1, y1 } = layout().diagram;
  return x > x0 - BESIDE && x < x1 + BESIDE && y > y0 - BESIDE && y < y1 + BESIDE;
}
