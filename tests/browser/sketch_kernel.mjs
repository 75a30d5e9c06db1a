// The search in the page of `cognate sketch` without a page. KERNEL: its module, as the page holds it.
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";
import { encoded } from "../../app/report/page/encoded.js";

const { instance: { exports: calls } } = await WebAssembly.instantiate(gunzipSync(Buffer.from(readFileSync(process.env.KERNEL, "utf8"), "base64")));
calls._initialize?.();

// What it answers to a question.
export function answer(question) {
  const numbers = [], text = new TextEncoder().encode(encoded(question, numbers)), at = calls.room(text.length);
  new Float64Array(calls.memory.buffer, calls.numbers(), numbers.length).set(numbers);
  new Uint8Array(calls.memory.buffer, at, text.length).set(text);
  const length = calls.sketch(1);
  return JSON.parse(new TextDecoder().decode(new Uint8Array(calls.memory.buffer, calls.text(), length)));
}
