// Problem files, from tables as results hold them.

const tomlText = (text) => JSON.stringify(text).replace(/\u007f/g, "\\u007f");

function tomlValue(value) {
  if (typeof value === "string") return tomlText(value);
  if (Array.isArray(value)) return `[${value.map(tomlValue).join(", ")}]`;
  if (value !== null && typeof value === "object") return `{ ${Object.entries(value).map(([key, part]) => `${key} = ${tomlValue(part)}`).join(", ")} }`;
  // Digits alone would be an integer, which has a greatest one.
  return Number.isInteger(value) && !Number.isSafeInteger(value) ? value.toExponential() : String(value);
}

const isTableList = (value) => Array.isArray(value) && value.length > 0 && value.every((part) => part !== null && typeof part === "object" && !Array.isArray(part));

// `name` and its table, lists of tables after it.
function tomlTable(name, table) {
  const rows = Object.entries(table).filter(([, value]) => value !== null && value !== undefined);
  const own = rows.filter(([, value]) => !isTableList(value)).map(([key, value]) => `${key} = ${tomlValue(value)}`);
  const lists = rows.filter(([, value]) => isTableList(value)).flatMap(([key, list]) => list.flatMap((part) =>
    ["", `[[${name}.${key}]]`, ...Object.entries(part).map(([k, value]) => `${k} = ${tomlValue(value)}`)]));
  return ["", `[${name}]`, ...own, ...lists];
}

// A whole problem as results hold it: values first, then tables and lists of tables.
export function problemToml(problem) {
  const rows = Object.entries(problem).filter(([, value]) => !(Array.isArray(value) && value.length === 0));
  const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
  const own = rows.filter(([, value]) => !isTable(value) && !isTableList(value)).map(([key, value]) => `${key} = ${tomlValue(value)}`);
  const tables = rows.filter(([, value]) => isTable(value)).flatMap(([key, table]) => tomlTable(key, table));
  const lists = rows.filter(([, value]) => isTableList(value)).flatMap(([key, list]) => list.flatMap((part) => ["", `[[${key}]]`, ...Object.entries(part).map(([k, value]) => `${k} = ${tomlValue(value)}`)]));
  return [...own, ...tables, ...lists, ""].join("\n");
}
