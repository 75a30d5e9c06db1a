// Rows of tables as others say, in their place: what has the focus there keeps it.

const fieldsIn = (cell) => [...cell.querySelectorAll("[data-cell]")];

function renewField(field, other) {
  const { value, checked, disabled, placeholder, title } = other;
  if (field.localName === "select") {
    field.replaceChildren(...other.children);
    field.value = value;
  }
  if (field.localName === "input") Object.assign(field, { value, checked, disabled, placeholder, title });
}

function renewCell(cell, other) {
  const [now, then] = [other, cell].map(fieldsIn), isSame = now.length === then.length && now.every((field, k) => field.dataset.cell === then[k].dataset.cell);
  if (isSame && now.length) { then.forEach((field, k) => renewField(field, now[k])); return; }
  const focused = then.find((field) => field === document.activeElement)?.dataset.cell;
  cell.replaceChildren(...other.childNodes);
  if (focused) fieldsIn(cell).find((field) => field.dataset.cell === focused)?.focus();
}

function renewed(row, other) {
  [...row.cells].forEach((cell, i) => renewCell(cell, other.cells[i]));
  return row;
}

// Brings the rows of a table to what they are to be; those that stay are not moved.
export function renewRows(body, rows) {
  const wanted = new Set(rows.map((row) => row.dataset.row));
  for (const row of [...body.rows]) if (!wanted.has(row.dataset.row)) row.remove();
  const known = new Map([...body.rows].map((row) => [row.dataset.row, row]));
  rows.forEach((row, i) => {
    const there = known.get(row.dataset.row) ? renewed(known.get(row.dataset.row), row) : row;
    if (body.rows[i] !== there) body.insertBefore(there, body.rows[i] ?? null);
  });
}
