// Whether the classes of `microwarp/common`, as a bundler packs them, and their module have at most so many bytes compressed.
//   node common-size.mjs BUNDLE BYTES

import { readFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

const [bundle, most] = process.argv.slice(2);
const sum = (size, module) => [bundle, `node_modules/microwarp/${module}.wasm`].reduce((total, name) => total + size(readFileSync(name)), 0);
const [gzip, brotli] = [(file) => gzipSync(file, { level: 9 }).length, (file) => brotliCompressSync(file).length];
const [plain, vectors] = ["microwarp-common", "microwarp-common-simd"];
console.log(`common, bundled: ${sum(gzip, plain)} bytes by gzip, ${sum(brotli, plain)} by brotli; with vectors ${sum(gzip, vectors)} and ${sum(brotli, vectors)}`);
if (!(sum(gzip, plain) <= most && sum(brotli, vectors) <= most)) throw new Error(`more than ${most} bytes`);
