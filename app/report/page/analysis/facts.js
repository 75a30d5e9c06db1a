// What holds for the motion as a whole, and the values at the present position.

import { breakable, byId, element, fact } from "../dom.js";
import { factName, factRows } from "../fact_text.js";
import { degrees, number, sentence } from "../format.js";
import { isOfComputation, showMore } from "../meaning.js";
import { errorText } from "../rounding.js";
import { RADIANS } from "../sampling.js";
import { say, term } from "../words.js";
import { landmarkColour } from "./sheets.js";
import { partName, unitText } from "./table.js";

export function showFacts(facts, drive, mechanism) {
  const unit = drive.kind === "slider" ? "" : "°";
  const range = say("range.to", { from: `${number(drive.from, 6)}${unit}`, to: `${number(drive.to, 6)}${unit}` });
  const speed = drive.kind === "slider" ? `${number(drive.speed, 5)} ${say("unit.speed")}` : `${number(drive.speed * RADIANS, 5)} rad/s`;
  byId("facts-list").replaceChildren(
    ...[...factRows(facts.filter(({ name }) => !isOfComputation(name) && !/^(tolerance_|layers\.)/.test(name)))].flatMap(([key, { text = "", place, exact }]) =>
      fact(factName(key), place ? say("fact.at", { value: text, place }).trim() : text, typeof exact === "number" ? String(exact) : undefined)),
    ...fact(say("facts.drive", { name: term(drive.name) }), range), ...fact(say("facts.drive_speed"), speed), ...fact(say("facts.moving_bodies"), String(mechanism.bodies.length - 1)));
  // Residuals are relative: of a size of one.
  showMore(byId("facts"), facts.filter(({ name }) => isOfComputation(name)).map(({ name, value }) => [name, factName(name), errorText(value, 1, (x) => number(x, 3)), value]));
}

// A row for each landmark; its button goes there.
export function showLandmarks(landmarks, mechanism, driveText, goTo) {
  byId("landmarks").hidden = landmarks.length === 0;
  const output = mechanism.bodies[mechanism.output];
  const turns = Array.isArray(output?.deg);
  const value = (v) => (v === null ? "–" : turns ? degrees(v / RADIANS, 2) : number(v, 6));
  const head = [[say("landmarks.landmark"), ""], [say("landmarks.of"), ""], [sentence(byId("drive-name").textContent), "number"], [say("landmarks.output"), "number"]];
  byId("landmarks-table").tHead.replaceChildren(element("tr", {}, ...head.map(([name, kind]) => element("th", { scope: "col", class: kind }, name))));
  byId("landmarks-rows").replaceChildren(...landmarks.map((landmark) => {
    const button = element("button", { type: "button", class: "link", title: say("landmarks.show") }, sentence(term(landmark.kind)));
    const again = landmark.again === undefined ? [] : [element("span", { class: "muted" }, say("landmarks.again", { place: driveText(landmark.again) }))];
    button.addEventListener("click", () => goTo(landmark.drive));
    return element("tr", {}, element("td", {}, element("span", { class: "landmark" }, element("span", { class: "dot", style: `background:var(${landmarkColour(landmark.kind)})` }), button, ...again)),
      element("td", {}, term(landmark.of)), element("td", { class: "number" }, driveText(landmark.drive)), element("td", { class: "number" }, value(landmark.value)));
  }));
}

// The columns of the parts chosen, with their values where the mechanism stands.
export class Values {
  constructor(table) {
    this.table = table;
    const head = ["column", "of", "now", "least", "greatest", "unit"];
    byId("values").tHead.replaceChildren(element("tr", {}, ...head.map((name, i) => element("th", { scope: "col", class: i === 1 || i === 5 ? "wide" : i ? "number" : "" }, say(`values.${name}`)))));
  }

  build(parts) {
    const columns = this.table.columns.filter((c) => c.quantity !== "drive" && parts.has(c.of));
    this.cells = columns.map((column) => ({ column, cell: element("td", { class: "number now" }) }));
    byId("values-rows").replaceChildren(...this.cells.map(({ column, cell }) => element("tr", {},
      element("td", {}, element("code", {}, ...breakable(column.name))), element("td", { class: "wide" }, partName(column.of)), cell,
      element("td", { class: "number" }, number(column.least, 5)), element("td", { class: "number" }, number(column.greatest, 5)),
      element("td", { class: "wide" }, unitText(column.unit)))));
    byId("values-count").textContent = say("values.count", { n: columns.length, all: this.table.columns.length - 1 });
  }

  move(drive) {
    for (const { column, cell } of this.cells) cell.textContent = number(this.table.at(column, drive), 6);
  }
}
