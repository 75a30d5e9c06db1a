// What stands in the page beside its scripts: "words" of each language and the "kernel", which the build
// puts there, and "data", which the program does.

export const embedded = (id) => document.getElementById(id).textContent;
