// A module that stands compressed in a script.

export const unpacked = async (packed) => {
  const bytes = new Blob([Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))]);
  const stream = new Response(bytes.stream().pipeThrough(new DecompressionStream("gzip")));
  return WebAssembly.instantiate(await stream.arrayBuffer());
};
