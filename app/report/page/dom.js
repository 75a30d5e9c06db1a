// Elements, made without ever parsing text as markup.

export const byId = (id) => document.getElementById(id);

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(made, attributes);
  made.append(...children);
  return made;
}

export function set(target, attributes) {
  for (const [key, value] of Object.entries(attributes)) target.setAttribute(key, value);
}

export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// A name and its value in a description list.
export function fact(name, value, title) {
  const dd = element("dd", title ? { title } : {}, value);
  if (dd.textContent.length > 32) dd.className = "long"; // no number is so long: it may be broken anywhere
  return [element("dt", {}, name), dd];
}

// A key that may be broken after its joints.
export const breakable = (key) => key.split(/(?<=[._])/).flatMap((part) => [part, element("wbr")]);
