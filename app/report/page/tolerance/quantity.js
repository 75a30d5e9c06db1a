// What results tell of a quantity that tolerances change.

export const isTransmission = ({ name }) => name.endsWith(" transmission");

// A distance has no sense: it is 0 at least.
export const isDistance = ({ distance }) => distance === true;
