// A problem that is drawn on a page of the studio's program, on its way to the studio.

import { embedded } from "../embedded.js";
import { language } from "../words.js";
import { addressWithToken, TOKEN } from "./token.js";

const ON_ITS_WAY = `cognate-drawn ${TOKEN}`;

// Whether the page comes from a studio.
export const isServed = JSON.parse(embedded("data")).studio === true;

export function takeToStudio(text) {
  sessionStorage.setItem(ON_ITS_WAY, text);
  location.href = `${addressWithToken("/")}#${language}`;
}

// The text that was brought, once; null where there is none.
export function broughtText() {
  try {
    const text = sessionStorage.getItem(ON_ITS_WAY);
    sessionStorage.removeItem(ON_ITS_WAY);
    return text;
  } catch { return null; }
}
