// Where on the sheet a function is drawn, and where linkages stand that generate it.

// In units of the sheet.
export const DIAGRAM = { x0: -47, y0: -16, x1: 4, y1: 41 };
export const STAGE = { x0: 15, y0: -33, x1: 57, y1: 32 };

const BESIDE = 6;             // units beside the diagram within which a hand means its edge

const shareOf = (value, from, to) => (value - from) / (to - from);
const within = (share) => Math.max(0, Math.min(1, share));

// Where a pair [input, output] stands; `ranges`: of both, the second with its sign.
export const placeOf = ([input, output], [across, upwards]) =>
  [DIAGRAM.x0 + (input / across) * (DIAGRAM.x1 - DIAGRAM.x0), DIAGRAM.y0 + (output / upwards) * (DIAGRAM.y1 - DIAGRAM.y0)];

// The shares of both ranges at a place, that of the nearest edge beside the diagram.
export const sharesOf = ([x, y]) => [within(shareOf(x, DIAGRAM.x0, DIAGRAM.x1)), within(shareOf(y, DIAGRAM.y0, DIAGRAM.y1))];

export const isNear = ([x, y]) => x > DIAGRAM.x0 - BESIDE && x < DIAGRAM.x1 + BESIDE && y > DIAGRAM.y0 - BESIDE && y < DIAGRAM.y1 + BESIDE;
