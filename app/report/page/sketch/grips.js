// What a hand or keys take hold of in the drawing.

import { set, svg } from "../dom.js";
import { round } from "../shapes.js";

// A handle with `attributes`. `on.move(event)` while it is dragged, `on.drop(moved)` after that, `on.key(event)` of a key
// without Control, Alt or Meta; whether it has used the key.
export function grip(attributes, on) {
  const handle = svg("circle", { class: "target-handle", tabindex: 0, ...attributes });
  let moved = false;
  handle.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    event.stopPropagation();
    handle.focus();
    handle.setPointerCapture(event.pointerId);
    moved = false;
  });
  handle.addEventListener("pointermove", (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    moved = true;
    on.move(event);
  });
  handle.addEventListener("lostpointercapture", () => on.drop(moved));
  handle.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !on.key(event)) return;
    event.preventDefault();
    event.stopPropagation();
  });
  return handle;
}

// Brings the handles in `holder` to `places`, pixels, with what `attributes(i)` gives for each; `make(i)` makes those missing.
export function arrange(handles, holder, places, make, attributes) {
  while (handles.length < places.length) handles.push(make(handles.length));
  for (const gone of handles.splice(places.length)) gone.remove();
  places.forEach(([x, y], i) => {
    set(handles[i], { cx: round(x), cy: round(y), ...attributes(i) });
    if (handles[i].parentNode !== holder) holder.append(handles[i]);
  });
}
