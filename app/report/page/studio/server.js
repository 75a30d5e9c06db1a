// The program that serves this page.

import { TOKEN } from "./token.js";

// {status, body}; body.faults of a text that has some; status 0 where the program does not answer.
export async function ask(path, body, signal) {
  const headers = { "X-Cognate-Token": TOKEN, ...(body ? { "Content-Type": "application/json" } : {}) };
  try {
    const answer = await fetch(path, { headers, signal, ...(body ? { method: "POST", body: JSON.stringify(body) } : {}) });
    return { status: answer.status, body: await answer.json() };
  } catch (error) {
    return { status: 0, body: { error: String(error) } };
  }
}
