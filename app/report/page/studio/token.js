// The token by which the program that serves a page knows it.

export const TOKEN = new URLSearchParams(location.search).get("token") ?? "";

// The address of `path` for what cannot set a header.
export const addressWithToken = (path) => `${path}${path.includes("?") ? "&" : "?"}token=${TOKEN}`;
