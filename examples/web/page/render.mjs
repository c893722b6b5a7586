// The worker behind the tab "A scene". It renders the picture that it was asked for last, in passes of 1, 2, 4, … samples a
// pixel and half, and stops as soon as another is asked for. What it is told and tells:
//   in   { job, scene, tier, points, width, height, samples, seed }, all of them names and whole numbers; { job } stops
//   out  { ready: { scenes, tiers, points, plan, most, size, imports } }, { broken }, { job, refused }
//        { job, samples, from, light, rate }: rows of the mean of both halves, and samples a second
//        { job, hash }: that of the picture in the golden table, which is rendered before
//        { job, samples, error, last }: a pass has ended
// A pass begins anew, since strata are laid out for a number of samples. All passes before the last take as long as that one.

const HALVES = 2;
// How long rows are rendered before the next message is looked for, in milliseconds.
const TURN = 30;

class Module {
  constructor({ module, instance: { exports } }, size) {
    const most = exports.most_pixels();
    const at = exports.shared_memory();
    Object.assign(this, { exports, size, most, imports: WebAssembly.Module.imports(module).length });
    this.halves = Array.from({ length: HALVES }, (_, half) => new Float32Array(exports.memory.buffer, at + 12 * most * half, 3 * most));
    this.request = new Uint32Array(exports.memory.buffer, at + 12 * most * HALVES, 7);
    this.text = new Uint8Array(exports.memory.buffer, at + 12 * most * HALVES + 4 * 7, 64);
    const [, , , width, height, samples, seed] = this.request;
    this.plan = { width, height, samples, seed };
    [this.scenes, this.tiers, this.points] = [0, 1, 2].map((list) => this.names(list));
  }

  names(list) {
    const names = [];
    for (let length; (length = this.exports.name_length(list, names.length)) > 0;) {
      names.push(new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, this.exports.name(list, names.length), length)));
    }
    return names;
  }

  // Takes a request by its names; gives what is wrong with it, or an empty text.
  ask({ scene, tier, points, width, height, seed }) {
    const chosen = [["scene", this.scenes, scene], ["tier", this.tiers, tier], ["point set", this.points, points]];
    for (const [what, names, name] of chosen) {
      if (!names.includes(name)) return `There is no ${what} "${name}". There are ${names.join(", ")}.`;
    }
    this.request.set([...chosen.map(([, names, name]) => names.indexOf(name)), width, height, 1, seed]);
    return this.row(0);
  }

  // The hash of the picture in the golden table, of one seed.
  golden(choices) {
    this.ask({ ...choices, ...this.plan });
    this.request[5] = this.plan.samples;
    for (let row = 0; row < this.plan.height; row += 1) this.exports.render(0, row);
    return this.exports.hash(0) >>> 0;
  }

  row(row) {
    for (let half = 0; half < HALVES; half += 1) {
      const refused = this.exports.render(half, row);
      if (refused > 0) return `${new TextDecoder().decode(this.text.slice(0, refused))}.`;
    }
    return "";
  }
}

// The root of the mean square of half the difference of both halves, each channel in parts of its own mean.
function error([a, b], pixels) {
  const [squares, sums] = [[0, 0, 0], [0, 0, 0]];
  for (let k = 0; k < 3 * pixels; k += 1) {
    squares[k % 3] += ((a[k] - b[k]) / 2) ** 2;
    sums[k % 3] += (a[k] + b[k]) / 2;
  }
  const parts = squares.map((square, k) => (square * pixels) / sums[k] ** 2);
  return Math.sqrt((parts[0] + parts[1] + parts[2]) / 3);
}

const turn = () => new Promise((go) => setTimeout(go));
let latest = null;

async function render(module, { job, width, height, samples: most, ...choices }) {
  const refused = module.ask({ width, height, ...choices });
  if (refused) return postMessage({ job, refused });
  postMessage({ job, hash: module.golden(choices) });
  module.ask({ width, height, ...choices });
  let [paths, milliseconds] = [0, 0];
  for (let samples = 1; samples <= most; samples *= 2) {
    module.request[5] = samples;
    for (let row = 0; row < height;) {
      const [from, began] = [row, performance.now()];
      do module.row(row++); while (row < height && performance.now() - began < TURN);
      milliseconds += performance.now() - began;
      paths += (row - from) * width * samples * HALVES;
      const [a, b] = module.halves.map((half) => half.subarray(3 * width * from, 3 * width * row));
      const light = a.map((x, k) => (x + b[k]) / 2);
      postMessage({ job, samples: HALVES * samples, from, light, rate: (1000 * paths) / milliseconds }, [light.buffer]);
      await turn();
      if (latest !== job) return undefined;
    }
    postMessage({ job, samples: HALVES * samples, error: error(module.halves, width * height), last: 2 * samples > most });
  }
  return undefined;
}

async function start() {
  const response = await fetch(new URL("../scene.wasm", import.meta.url));
  if (!response.ok) throw new Error(`scene.wasm: ${response.status}. Build it first: examples/web/build`);
  const binary = await response.arrayBuffer();
  return new Module(await WebAssembly.instantiate(binary, {}), binary.byteLength);
}

const loading = start();
onmessage = async ({ data }) => {
  latest = data.job;
  const module = await loading.catch(() => null);
  if (module && data.scene !== undefined && latest === data.job) await render(module, data);
};
loading.then(
  ({ scenes, tiers, points, plan, most, size, imports }) => postMessage({ ready: { scenes, tiers, points, plan, most, size, imports } }),
  (problem) => postMessage({ broken: problem.message }),
);
