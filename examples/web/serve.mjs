// Serves a directory to this machine's browsers, since a page may not load WASM from file://.
//   node serve.mjs [PORT] [DIRECTORY]     default: 8000 and the directory of this file
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { dirname, extname, join, normalize, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const types = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".csv": "text/csv; charset=utf-8",
  ".wasm": "application/wasm",
};

// The content of a path; `instead` has what is served in place of a file, null for a file that is to be missing.
async function content(root, path, instead) {
  const name = normalize(decodeURIComponent(path)).replace(/^[/\\]+/, "") || "index.html";
  if (instead[name] === null) throw new Error("missing");
  if (name in instead) return { name, body: instead[name] };
  if (name.split(sep).includes("..")) throw new Error("outside the directory");
  return { name, body: await readFile(join(root, name)) };
}

// Starts a server; port 0 means any free port.
export async function serve(root, { port = 0, instead = {} } = {}) {
  const server = createServer(async (request, response) => {
    try {
      const { name, body } = await content(root, new URL(request.url, "http://localhost").pathname, instead);
      response.writeHead(200, { "Content-Type": types[extname(name)] ?? "application/octet-stream", "Cache-Control": "no-store" });
      response.end(body);
    } catch {
      response.writeHead(404, { "Content-Type": "text/plain" });
      response.end("not found");
    }
  });
  await new Promise((listening, failed) => server.once("error", failed).listen(port, "127.0.0.1", listening));
  return { url: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [port = "8000", root = dirname(fileURLToPath(import.meta.url))] = process.argv.slice(2);
  const { url } = await serve(root, { port: Number(port) });
  console.log(`serving ${url} (end with Ctrl-C)`);
}
