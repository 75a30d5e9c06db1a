// Of many tests of one sort an ordinary run takes some; with WHOLE in the environment all.
import { test } from "node:test";

// Of many pages of one sort every third, which an ordinary run opens; with WHOLE in the environment all.
export const some = (list) => process.env.WHOLE ? list : list.filter((_, i) => i % 3 === 0);

// Of the tests of a file with many every second, likewise.
let tests = 0;
const oneOf = (share) => (name, ...rest) => tests++ % share === 0 || process.env.WHOLE ? test(name, ...rest) : test.skip(name);
export const inTurn = oneOf(2);

// Where each takes long, every fourth or eighth.
export const seldom = oneOf(4);
export const rarely = oneOf(8);

// What an ordinary run leaves out, since another test of it shows the same at less cost.
export const wholeOnly = process.env.WHOLE ? test : test.skip;
