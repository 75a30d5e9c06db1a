// Values as the kernels of the pages read them (see kernel/document.hpp).

// The text of `value`; its numbers go into `numbers`. It names nothing outside itself: workers take it by its text.
export function encoded(value, numbers) {
  if (typeof value === "number") { numbers.push(value); return Number.isSafeInteger(value) ? "i" : "#"; }
  if (typeof value === "boolean") return value ? "+" : "-";
  if (typeof value === "string") return `s${new TextEncoder().encode(value).length}:${value}`;
  if (Array.isArray(value)) return `a${value.length}:${value.map((part) => encoded(part, numbers)).join("")}`;
  const entries = Object.entries(value).filter(([, part]) => part !== null && part !== undefined);
  return `t${entries.length}:${entries.map(([key, part]) => encoded(key, numbers) + encoded(part, numbers)).join("")}`;
}
