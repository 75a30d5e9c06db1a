// What a mechanism consists of, in lists beside the sheet: everything that a hand does there by fields.

import { byId, element } from "../dom.js";
import { number } from "../format.js";
import { say, term } from "../words.js";
import { spreadOf } from "./chain.js";
import { moveJoint, putPivot, removeJoint, removeLink, removeLoad, removeSlider, rename, setCentre, setDegrees, setDriven, setInertia, setLoad, setMass, setRate, setTorque, setWeighs, setWindow } from "./edits.js";
import { canDrive, directionOf, driverOf, drivesBySlide, FRAME, GRAVITY, isBlock, isFixed, jointOf, jointsOn, linkOf, loadNames, loadOf, pinOf } from "./model.js";
import { renewRows } from "./rows.js";
import { optionsOfWindow, windowOfOption } from "./windows.js";

// As many digits as a narrow page has room for.
const plain = (x) => String(Number(Number(x.toFixed(4)).toPrecision(7)));
const precise = (x) => String(Number(x.toPrecision(6)));
const together = (names) => names.map(term).join("–");

const hasForces = ({ loads, links }) => loads.length > 0 || links.some(({ mass, inertia }) => mass > 0 || inertia > 0);

const RATES = ["speed", "acceleration"];
const rateField = (key) => document.querySelector(`[data-cell="drive.${key}"]`);

// The number in a field; undefined where there is none.
const numberIn = (input) => (Number.isFinite(input.valueAsNumber) ? input.valueAsNumber : undefined);

// The centre of mass of a link with another coordinate; null, as of mass that is spread evenly, without one.
function withAxis(state, name, k, value) {
  const now = linkOf(state, name).centre ?? spreadOf(state, name)?.centre ?? [0, 0];
  return value === null ? null : now.with(k, value);
}

export class Lists {
  // `on`: state(); change(next, why), null where nothing can be made of what was typed in a "field" or a "number"; chosen(), and select(one), of {joint}, {link}, {load}.
  constructor(on) {
    this.on = on;
    byId("weighs").addEventListener("change", (event) => on.change(setWeighs(on.state(), event.target.checked)));
    for (const key of RATES) rateField(key).addEventListener("change", (event) => this.#take(event.target, numberIn, (state, value) => setRate(state, { [key]: value })));
  }

  // What was typed in a field gives another state by `make(state, value)`; an undefined value is none.
  #take(input, read, make) {
    const value = read(input);
    this.on.change(value === undefined ? null : make(this.on.state(), value), input.type === "number" ? "number" : "field");
  }

  // A field whose change gives another state by `make(state, value)`.
  #field(key, label, attributes, make, read = (input) => input.value.trim()) {
    const input = element("input", { "data-cell": key, "aria-label": label, autocomplete: "off", spellcheck: "false", ...attributes });
    input.addEventListener("change", () => this.#take(input, read, make));
    return input;
  }

  #number(key, label, value, make, attributes = {}) {
    return this.#field(key, label, { type: "number", step: "any", value: plain(value), title: plain(value), ...attributes }, make, numberIn);
  }

  // A number that may be left out: then it is the one that is shown in grey.
  #choice(key, label, value, otherwise, make, attributes = {}) {
    const read = (input) => (input.value === "" && !input.validity.badInput ? null : numberIn(input));
    return this.#field(key, label, { type: "number", step: "any", value: value === null ? "" : precise(value), placeholder: otherwise === undefined ? "" : number(otherwise, 3), title: label, ...attributes }, make, read);
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

  #row(one, cells, list = Object.keys(one)[0]) {
    const [kind] = Object.keys(one);
    const row = element("tr", { "data-row": `${list}.${one[kind]}`, "data-part": `${kind}.${one[kind]}` }, ...cells.map((cell) => element("td", {}, cell)));
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

  #link(state, { name }) {
    const joints = together(jointsOn(state, name).map((joint) => joint.name));
    return this.#row({ link: name }, [this.#name("link", name), joints, this.#drives(state, name),
      this.#away(`link.${name}.away`, say("build.remove_one", { name }), (now) => removeLink(now, name))]);
  }

  #slider(state, slider) {
    const { name, block, on } = slider, away = this.#away(`slider.${name}.away`, say("build.remove_one", { name: block }), (now) => removeSlider(now, name));
    const direction = this.#number(`slider.${name}.degrees`, say("build.direction_of", { name: block }), directionOf(state, slider), (now, degrees) => setDegrees(now, name, degrees));
    const where = say("build.slides_on", { pin: pinOf(state, slider).name, on: on === FRAME ? term(FRAME) : on });
    return this.#row({ link: block }, [block, where, this.#drives(state, block), direction, away]);
  }

  // A mass, and where it is and how large its inertia where that is not as of mass that is spread evenly.
  #mass(state, { name, mass, centre = null, inertia = null }) {
    const even = spreadOf(state, name), isNone = mass === 0 && inertia === null ? { disabled: "" } : {};
    const axis = (k) => this.#choice(`link.${name}.centre.${"xy"[k]}`, say("build.centre_of", { axis: "xy"[k], name }), centre && Number(plain(centre[k])), even?.centre[k],
      (now, value) => setCentre(now, name, withAxis(now, name, k, value)), isNone);
    return this.#row({ link: name }, [name, this.#number(`link.${name}.mass`, say("build.mass_of", { name }), mass, (now, value) => setMass(now, name, value), { min: 0, value: precise(mass), title: precise(mass) }), axis(0), axis(1),
      this.#choice(`link.${name}.inertia`, say("build.inertia_of", { name }), inertia, even ? mass * even.square * 1e-6 : undefined, (now, value) => setInertia(now, name, value), { min: 0, ...isNone })], "mass");
  }

  // When a load acts, with the ends of its windows.
  #acts(state, name, load) {
    const { options, value } = optionsOfWindow(state, load), window = load.window ?? null;
    const choice = element("select", { "data-cell": `load.${name}.acts`, "aria-label": say("build.acts_of", { name }) }, ...options.map(([key, text]) => element("option", { value: key, ...(key === value ? { selected: "" } : {}) }, text)));
    choice.addEventListener("change", () => this.on.change(setWindow(this.on.state(), name, windowOfOption(this.on.state(), loadOf(this.on.state(), name), choice.value))));
    const ends = (part, label) => [0, 1].map((k) => this.#number(`load.${name}.${part}.${k}`, say(label, { name, end: say(k ? "build.end_to" : "build.end_from") }), window[part][k],
      (now, x) => setWindow(now, name, { ...loadOf(now, name).window, [part]: loadOf(now, name).window[part].with(k, x) })));
    const fields = [...(Array.isArray(window?.when) ? ends("when", "build.when_of") : []), ...(window?.stroke ? ends("stroke", "build.stroke_of") : [])];
    return element("div", { class: "build-acts" }, choice, ...fields);
  }

  #load(state, load, name) {
    const { on, force, torque } = load, away = this.#away(`load.${name}.away`, say("build.remove_load", { name: on }), (now) => removeLoad(now, name));
    const part = (k) => this.#number(`load.${name}.${"xy"[k]}`, say("build.force_of", { axis: "xy"[k], name: on }), force[k], (now, x) => setLoad(now, name, loadOf(now, name).force.with(k, x)));
    const sizes = force ? [part(0), part(1)] : [this.#number(`load.${name}.torque`, say("build.torque_of", { name: on }), torque, (now, x) => setTorque(now, name, x), { value: precise(torque) })];
    return this.#row({ load: name }, [on, ...sizes, this.#acts(state, name, load), away]);
  }

  #loads(state) {
    const names = loadNames(state), rows = (isForce) => state.loads.map((load, i) => [load, names[i]]).filter(([{ force }]) => Boolean(force) === isForce).map(([load, name]) => this.#load(state, load, name));
    this.#table("loads", rows(true));
    this.#table("torques", rows(false));
  }

  // How the drive moves, and which gravity acts.
  #drive(state) {
    const units = drivesBySlide(state) ? ["build.speed_unit_slide", "build.acceleration_unit_slide"] : ["build.speed_unit_turn", "build.acceleration_unit_turn"];
    RATES.forEach((key, i) => {
      rateField(key).value = precise(state[key]);
      byId(`${key}-unit`).textContent = say(units[i]);
    });
    const { gravity } = state, isOwn = gravity && gravity.some((x, k) => x !== GRAVITY[k]);
    byId("weighs").checked = gravity !== null;
    byId("weighs-text").textContent = isOwn ? say("build.weighs_so", { x: number(gravity[0], 6), y: number(gravity[1], 6) }) : say("build.weighs");
  }

  #table(id, rows) {
    renewRows(byId(`${id}-rows`), rows);
    byId(`${id}-list`).hidden = rows.length === 0;
  }

  // Which part is chosen.
  mark() {
    const [[kind, name] = []] = Object.entries(this.on.chosen() ?? {});
    for (const row of document.querySelectorAll("#lists [data-row]")) row.classList.toggle("chosen", row.dataset.part === `${kind}.${name}`);
  }

  show(state) {
    this.#table("joints", state.joints.map((joint) => this.#joint(state, joint)));
    this.#table("links", state.links.filter(({ name }) => !isBlock(state, name)).map((link) => this.#link(state, link)));
    this.#table("sliders", state.sliders.map((slider) => this.#slider(state, slider)));
    this.#table("masses", state.links.map((link) => this.#mass(state, link)));
    this.#loads(state);
    this.#drive(state);
    byId("lists-none").hidden = state.joints.length > 0;
    byId("forces").hidden = state.links.length === 0;
    if (hasForces(state) && !this.hadForces) byId("forces").open = true;
    this.hadForces = hasForces(state);
    this.mark();
  }
}
