// What a mechanism consists of, in lists beside the sheet: everything that a hand does there by fields.

import { byId, element } from "../dom.js";
import { number } from "../format.js";
import { say, term } from "../words.js";
import { moveJoint, putPivot, removeJoint, removeLink, removeLoad, removeSlider, rename, setDegrees, setDriven, setLoad, setMass, setWeighs } from "./edits.js";
import { canDrive, directionOf, driverOf, FRAME, isBlock, isFixed, jointOf, jointsOn, pinOf } from "./model.js";

const plain = (x) => String(Number(x.toFixed(4)));
const together = (names) => names.map(term).join("–");

export class Lists {
  // `on`: state(); change(next), null where nothing can be made of what was typed; chosen(), and select(one), of {joint}, {link}, {load}.
  constructor(on) {
    this.on = on;
    byId("weighs").addEventListener("change", (event) => on.change(setWeighs(on.state(), event.target.checked)));
  }

  // A field whose change gives another state by `make(state, value)`.
  #field(key, label, attributes, make, read = (input) => input.value.trim()) {
    const input = element("input", { "data-cell": key, "aria-label": label, autocomplete: "off", spellcheck: "false", ...attributes });
    input.addEventListener("change", () => { const value = read(input); this.on.change(value === null ? null : make(this.on.state(), value)); });
    return input;
  }

  #number(key, label, value, make, attributes = {}) {
    const read = (input) => (Number.isFinite(input.valueAsNumber) ? input.valueAsNumber : null);
    return this.#field(key, label, { type: "number", step: "any", value: plain(value), ...attributes }, make, read);
  }

  // Under its new name the row is another: its field has the focus again.
  #name(kind, name) {
    const field = this.#field(`${kind}.${name}.name`, say("build.name_of", { name }), { type: "text", value: name, class: "build-name", maxlength: 40 }, (state, to) => (to === name ? state : rename(state, name, to)));
    field.addEventListener("change", () => setTimeout(() => {
      if (document.activeElement === document.body) [...document.querySelectorAll("#lists [data-row]")].find((row) => row.dataset.row === `${kind}.${field.value.trim()}`)?.querySelector("input").focus();
    }));
    return field;
  }

  #tick(key, label, type, checked, make, attributes = {}) {
    return this.#field(key, label, { type, ...(checked ? { checked: "" } : {}), ...attributes }, make, (input) => input.checked);
  }

  #away(key, label, act) {
    const button = element("button", { type: "button", class: "build-away", "data-cell": key, "aria-label": label, title: label }, "×");
    button.addEventListener("click", () => this.on.change(act(this.on.state())));
    return button;
  }

  #row(one, cells) {
    const [kind] = Object.keys(one);
    const row = element("tr", { "data-row": `${kind}.${one[kind]}` }, ...cells.map((cell) => element("td", {}, cell)));
    row.addEventListener("focusin", () => { if (this.on.chosen()?.[kind] !== one[kind]) this.on.select(one); });
    return row;
  }

  #joint(state, joint) {
    const { name, at } = joint, axis = (k) => this.#number(`joint.${name}.${"xy"[k]}`, say("build.coordinate", { axis: "xy"[k], name }), at[k], (now, x) => moveJoint(now, name, jointOf(now, name).at.with(k, x)));
    return this.#row({ joint: name }, [this.#name("joint", name), axis(0), axis(1),
      this.#tick(`joint.${name}.fixed`, say("build.fix", { name }), "checkbox", isFixed(joint), (now) => putPivot(now, { joint: name })),
      this.#away(`joint.${name}.away`, say("build.remove_one", { name }), (now) => removeJoint(now, name))]);
  }

  #drives(state, name) {
    return this.#tick(`link.${name}.drives`, say("build.drives", { name }), "radio", driverOf(state) === name, (now) => setDriven(now, name), { name: "driver", ...(canDrive(state, name) ? {} : { disabled: "" }) });
  }

  #link(state, { name, mass }) {
    const joints = together(jointsOn(state, name).map((joint) => joint.name));
    return this.#row({ link: name }, [this.#name("link", name), joints, this.#drives(state, name),
      this.#number(`link.${name}.mass`, say("build.mass_of", { name }), mass, (now, value) => setMass(now, name, value), { min: 0 }),
      this.#away(`link.${name}.away`, say("build.remove_one", { name }), (now) => removeLink(now, name))]);
  }

  #slider(state, slider) {
    const { name, block, on } = slider, away = this.#away(`slider.${name}.away`, say("build.remove_one", { name: block }), (now) => removeSlider(now, name));
    const direction = this.#number(`slider.${name}.degrees`, say("build.direction_of", { name: block }), directionOf(state, slider), (now, degrees) => setDegrees(now, name, degrees));
    const where = say("build.slides_on", { pin: pinOf(state, slider).name, on: on === FRAME ? term(FRAME) : on });
    return this.#row({ link: block }, [block, where, this.#drives(state, block), direction, away]);
  }

  #load(state, { on, force }) {
    const part = (k) => this.#number(`load.${on}.${"xy"[k]}`, say("build.force_of", { axis: "xy"[k], name: on }), force[k], (now, x) => setLoad(now, on, force.with(k, x)));
    return this.#row({ load: on }, [on, part(0), part(1), say("build.newtons", { value: number(Math.hypot(...force), 4) }), this.#away(`load.${on}.away`, say("build.remove_load", { name: on }), (now) => removeLoad(now, on))]);
  }

  #table(id, rows) {
    renewRows(byId(`${id}-rows`), rows);
    byId(`${id}-list`).hidden = rows.length === 0;
  }

  // Which part is chosen.
  mark() {
    const [[kind, name] = []] = Object.entries(this.on.chosen() ?? {});
    for (const row of document.querySelectorAll("#lists [data-row]")) row.classList.toggle("chosen", row.dataset.row === `${kind}.${name}`);
  }

  show(state) {
    this.#table("joints", state.joints.map((joint) => this.#joint(state, joint)));
    this.#table("links", state.links.filter(({ name }) => !isBlock(state, name)).map((link) => this.#link(state, link)));
    this.#table("sliders", state.sliders.map((slider) => this.#slider(state, slider)));
    this.#table("loads", state.loads.map((load) => this.#load(state, load)));
    byId("weighs").checked = state.weighs;
    byId("lists-none").hidden = state.joints.length > 0;
    byId("weighs-choice").hidden = state.links.length === 0;
    this.mark();
  }
}

// A row as another says, in its place: what has the focus there keeps it.
function renewed(row, other) {
  [...row.cells].forEach((cell, i) => {
    const [now, then] = [other.cells[i].firstElementChild, cell.firstElementChild];
    if (then?.localName === "input") Object.assign(then, { value: now.value, checked: now.checked, disabled: now.disabled });
    else if (then?.localName !== "button") cell.textContent = other.cells[i].textContent;
  });
  return row;
}

// Brings the rows of a table to what they are to be; those that stay are not moved.
function renewRows(body, rows) {
  const wanted = new Set(rows.map((row) => row.dataset.row));
  for (const row of [...body.rows]) if (!wanted.has(row.dataset.row)) row.remove();
  const known = new Map([...body.rows].map((row) => [row.dataset.row, row]));
  rows.forEach((row, i) => {
    const there = known.get(row.dataset.row) ? renewed(known.get(row.dataset.row), row) : row;
    if (body.rows[i] !== there) body.insertBefore(there, body.rows[i] ?? null);
  });
}
