// Elements, made without ever parsing text as markup.

const byId = (id) => document.getElementById(id);

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(made, attributes);
  made.append(...children);
  return made;
}

function set(target, attributes) {
  for (const [key, value] of Object.entries(attributes)) target.setAttribute(key, value);
}

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// A name and its value in a description list.
function fact(name, value, title) {
  const dd = element("dd", title ? { title } : {}, value);
  return [element("dt", {}, name), dd];
}

// A key that may be broken after its joints.
const breakable = (key) => key.split(/(?<=[._])/).flatMap((part) => [part, element("wbr")]);
