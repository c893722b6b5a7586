// What is in WASM modules, out of their name sections.
//   node wasm-functions.mjs FILE...          NAME BYTES FUNCTIONS of each; the bytes are those without names
//   node wasm-functions.mjs --names FILE     the names of its functions
import { readFileSync } from "node:fs";
import { basename } from "node:path";

// The sections of a module: their kind, where they begin and end, and a cursor at what is in them.
function* sections(bytes) {
  let at = 8;
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  };
  while (at < bytes.length) {
    const first = at;
    const kind = bytes[at++];
    const size = number();
    const end = at + size;
    yield { kind, first, end, number, at: (to) => (to === undefined ? at : (at = to)) };
    at = end;
  }
}

function text(bytes, section) {
  const length = section.number();
  const start = section.at();
  section.at(start + length);
  return bytes.subarray(start, start + length).toString();
}

function read(file) {
  const bytes = readFileSync(file);
  let size = 8;
  let functions = 0;
  let names;
  for (const section of sections(bytes)) {
    if (section.kind !== 0) size += section.end - section.first;
    if (section.kind === 3) functions = section.number();
    if (section.kind !== 0 || text(bytes, section) !== "name") continue;
    while (section.at() < section.end) {
      const kind = bytes[section.at()];
      section.at(section.at() + 1);
      const end = section.number() + section.at();
      if (kind === 1) {
        names = [];
        for (let left = section.number(); left > 0; left--) {
          section.number();
          names.push(text(bytes, section));
        }
      }
      section.at(end);
    }
  }
  if (names === undefined) throw new Error(`${file}: no names of functions`);
  return { size, functions, names };
}

const files = process.argv.slice(2);
if (files[0] === "--names") {
  for (const name of read(files[1]).names) console.log(name);
} else {
  for (const file of files) {
    const { size, functions } = read(file);
    console.log(basename(file), size, functions);
  }
}
