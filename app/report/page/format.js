// Numbers as a reader wants them: few digits, a true minus, powers of ten written out.

export const SUPERSCRIPTS = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

export function powerOfTen(exponent) {
  return "10" + [...String(exponent)].map((c) => SUPERSCRIPTS[c]).join("");
}

// `x` to `digits` significant digits; very large and small numbers as a power of ten.
export function number(x, digits = 5) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-3) {
    const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
    const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
    return `${short.replace("-", "−")}×${powerOfTen(Number(exponent))}`;
  }
  return String(Number(x.toPrecision(digits))).replace("-", "−");
}

// A text with its numbers as this page writes them: "-78.79" and "1.3e+04" have a true minus and a power of ten.
export const writtenOut = (text) => text.replace(/(?<![\w.])(-?)(\d+(?:\.\d+)?)(?:e([+-]?\d+))?(?![\w-])/g,
  (_, sign, digits, exponent) => `${sign && "−"}${digits}${exponent ? `×${powerOfTen(Number(exponent))}` : ""}`);

// `x` with a fixed count of decimals, so that running values do not jump about.
export function fixed(x, decimals) {
  if (x === null || x === undefined || !Number.isFinite(x)) return "–";
  const text = x.toFixed(decimals);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

// A time of computing.
export function duration(seconds) {
  const [scale, unit] = seconds >= 1 ? [1, "s"] : seconds >= 1e-3 ? [1e3, "ms"] : [1e6, "µs"];
  return `${number(scale * seconds, 3)} ${unit}`;
}

export const degrees = (x, decimals = 2) => `${fixed(x, decimals)}°`;
export const degreesShort = (x, digits = 6) => `${number(x, digits)}°`;
export const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

// The power of a thousand that brings `size` near one, as an exponent: 0 where none is needed.
export function engineeringExponent(size) {
  if (!(size > 0) || (size >= 0.02 && size < 1e5)) return 0;
  return 3 * Math.floor(Math.log10(size) / 3);
}
