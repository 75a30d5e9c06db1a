// What holds for the motion as a whole, and the values at the present position.

function showFacts(facts, drive, mechanism) {
  const unit = drive.kind === "slider" ? "" : "°";
  const range = `${number(drive.from, 6)}${unit} to ${number(drive.to, 6)}${unit}`;
  const speed = drive.kind === "slider" ? `${number(drive.speed, 5)} units/s` : `${number(drive.speed * RADIANS, 5)} rad/s`;
  byId("facts-list").replaceChildren(
    ...[...factRows(facts)].flatMap(([key, { text = "", place, exact }]) =>
      fact(factName(key), place ? `${text} at ${place}`.trim() : text, typeof exact === "number" ? String(exact) : undefined)),
    ...fact(`Drive (${drive.name})`, range), ...fact("Speed of the drive", speed), ...fact("Moving bodies", String(mechanism.bodies.length - 1)));
}

// A row for each landmark; its button goes there.
function showLandmarks(landmarks, mechanism, driveText, goTo) {
  byId("landmarks").hidden = landmarks.length === 0;
  const output = mechanism.bodies[mechanism.output];
  const turns = Array.isArray(output?.deg);
  const value = (v) => (v === null ? "–" : turns ? degrees(v / RADIANS, 2) : number(v, 6));
  const head = [["Landmark", ""], ["Of", ""], [sentence(byId("drive-name").textContent), "number"], ["Output", "number"]];
  byId("landmarks-table").tHead.replaceChildren(element("tr", {}, ...head.map(([name, kind]) => element("th", { scope: "col", class: kind }, name))));
  byId("landmarks-rows").replaceChildren(...landmarks.map((landmark) => {
    const button = element("button", { type: "button", class: "link", title: "Show this position" }, sentence(landmark.kind));
    const again = landmark.again === undefined ? [] : [element("span", { class: "muted" }, `also at ${driveText(landmark.again)}`)];
    button.addEventListener("click", () => goTo(landmark.drive));
    return element("tr", {}, element("td", {}, element("span", { class: "landmark" }, element("span", { class: "dot", style: `background:var(${landmarkColour(landmark.kind)})` }), button, ...again)),
      element("td", {}, landmark.of), element("td", { class: "number" }, driveText(landmark.drive)), element("td", { class: "number" }, value(landmark.value)));
  }));
}

// The columns of the parts chosen, with their values where the mechanism stands.
class Values {
  constructor(table) {
    this.table = table;
    const head = ["Column", "Of", "Now", "Least", "Greatest", "Unit"];
    byId("values").tHead.replaceChildren(element("tr", {}, ...head.map((name, i) => element("th", { scope: "col", class: i === 1 || i === 5 ? "wide" : i ? "number" : "" }, name))));
  }

  build(parts) {
    const columns = this.table.columns.filter((c) => c.quantity !== "drive" && parts.has(c.of));
    this.cells = columns.map((column) => ({ column, cell: element("td", { class: "number now" }) }));
    byId("values-rows").replaceChildren(...this.cells.map(({ column, cell }) => element("tr", {},
      element("td", {}, element("code", {}, ...breakable(column.name))), element("td", { class: "wide" }, column.of), cell,
      element("td", { class: "number" }, number(column.least, 5)), element("td", { class: "number" }, number(column.greatest, 5)),
      element("td", { class: "wide" }, unitText(column.unit)))));
    byId("values-count").textContent = `${plural(columns.length, "column")} of ${this.table.columns.length - 1}`;
  }

  move(drive) {
    for (const { column, cell } of this.cells) cell.textContent = number(this.table.at(column, drive), 6);
  }
}
