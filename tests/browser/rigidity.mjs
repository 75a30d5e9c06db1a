// Whether what the page of built mechanisms draws holds together as it moves.

const STEPS = 15;

// Of a mechanism in motion the largest error in pixels, over its drive: of distances between joints of a link, of places of fixed pivots, and of pins beside
// the line of their slider on the frame; at the start of the drive it is where it is drawn.
export const gapOf = (page) => page.evaluate((steps) => {
  const slider = document.getElementById("drive"), value = slider.value;
  const go = (drive) => { slider.value = drive; slider.dispatchEvent(new Event("input")); };
  const pins = () => Object.fromEntries([...document.querySelectorAll("[data-pin]")].map((pin) => [pin.dataset.pin, ["cx", "cy"].map((key) => Number(pin.getAttribute(key)))]));
  const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
  const links = [...document.querySelectorAll("#links-rows tr")].map((row) => row.cells[1].textContent.split("–"));
  const fixed = [...document.querySelectorAll("#joints-rows tr")].filter((row) => row.querySelector("[type=checkbox]").checked).map((row) => row.querySelector("input").value);
  const guides = [...document.querySelectorAll("#sliders-rows tr")].map((row) => ({ where: row.cells[1].textContent.split(" on "), angle: (Number(row.querySelector("[type=number]").value) * Math.PI) / 180 }))
    .filter(({ where }) => where[1] === "frame").map(({ where, angle }) => ({ pin: where[0], across: [Math.sin(angle), Math.cos(angle)] }));
  const [from, to] = [Number(slider.min), Number(slider.max)];
  go(from);
  const first = pins();
  let gap = 0;
  for (let i = 1; i <= steps; ++i) {
    go(from + ((to - from) * i) / steps);
    const now = pins();
    for (const names of links) for (const a of names) for (const b of names) gap = Math.max(gap, Math.abs(apart(now[a], now[b]) - apart(first[a], first[b])));
    for (const name of fixed) gap = Math.max(gap, apart(now[name], first[name]));
    for (const { pin, across } of guides) gap = Math.max(gap, Math.abs(now[pin].reduce((sum, x, k) => sum + across[k] * (x - first[pin][k]), 0)));
  }
  go(value);
  return gap;
}, STEPS);
