// Figures of a gear train in words.

import { factText } from "../fact_text.js";
import { say } from "../words.js";

// A fraction with a true minus.
export const fractionText = (text) => text.replace("-", "−");

export const trainFactName = (name) => say(`train.fact.${name}`);
export const trainFactText = (name, value) => (name === "ratio_exact" ? fractionText(value) : factText(value, ""));
