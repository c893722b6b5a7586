// A headless Chromium, driven over two pipes by its DevTools protocol; no package needed.

import { spawn } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

// Messages of JSON, each ended by a zero byte.
class Pipe {
  constructor(process) {
    this.out = process.stdio[3];
    this.sent = 0;
    this.waiting = new Map();
    this.heard = new Set();
    let rest = "";
    process.stdio[4].setEncoding("utf8").on("data", (chunk) => {
      const messages = (rest + chunk).split("\0");
      rest = messages.pop();
      messages.forEach((message) => this.take(JSON.parse(message)));
    });
  }

  take(message) {
    if (message.id === undefined) return this.heard.forEach((listener) => listener(message));
    const { done, failed, method } = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) failed(new Error(`${method}: ${message.error.message}`));
    else done(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    this.sent += 1;
    const id = this.sent;
    this.out.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((done, failed) => this.waiting.set(id, { done, failed, method }));
  }
}

export async function launch(program = "chromium") {
  const profile = await mkdtemp(join(tmpdir(), "microwarp-web-"));
  const flags = [
    "--headless=new", "--remote-debugging-pipe", `--user-data-dir=${profile}`, "--no-first-run", "--disable-gpu",
    "--disable-dev-shm-usage", "--hide-scrollbars", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--no-default-browser-check",
    // Chromium cannot sandbox itself as root nor in most containers, and loads nothing here but this page.
    "--no-sandbox",
    "about:blank",
  ];
  const child = spawn(program, flags, { stdio: ["ignore", "ignore", "pipe", "pipe", "pipe"] });
  let said = "";
  child.stderr.setEncoding("utf8").on("data", (chunk) => (said = (said + chunk).slice(-4000)));
  const ended = new Promise((resolve) => child.once("exit", resolve));
  const failed = new Promise((_, reject) => {
    child.once("error", reject);
    ended.then((code) => reject(new Error(`${program} ended with ${code}:\n${said}`)));
  });
  failed.catch(() => {});
  const pipe = new Pipe(child);
  child.stdio[3].on("error", () => {});
  return {
    open: (url, screen) => Promise.race([Page.open(pipe, url, screen), failed]),
    async close() {
      pipe.send("Browser.close").catch(() => {});
      const timer = setTimeout(() => child.kill("SIGKILL"), 3000);
      await ended;
      clearTimeout(timer);
      await rm(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

// One tab. `problems` has every console error, uncaught exception and failed request.
class Page {
  static async open(pipe, url, { width, height, scale = 1, mobile = false, features = [] }) {
    const { targetId } = await pipe.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await pipe.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(pipe, sessionId, targetId);
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
    await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile });
    await page.send("Emulation.setEmulatedMedia", { features });
    const loaded = page.once("Page.loadEventFired");
    await page.send("Page.navigate", { url });
    await loaded;
    return page;
  }

  constructor(pipe, sessionId, targetId) {
    Object.assign(this, { pipe, sessionId, targetId, problems: [], listeners: [] });
    this.hear = (message) => {
      if (message.sessionId === sessionId) this.note(message);
    };
    pipe.heard.add(this.hear);
  }

  send(method, params) {
    return this.pipe.send(method, params, this.sessionId);
  }

  once(method) {
    return new Promise((done) => this.listeners.push({ method, done }));
  }

  note({ method, params }) {
    const due = this.listeners.filter((listener) => listener.method === method);
    this.listeners = this.listeners.filter((listener) => listener.method !== method);
    due.forEach(({ done }) => done(params));
    if (method === "Runtime.consoleAPICalled" && ["error", "assert", "warning"].includes(params.type)) {
      this.problems.push(`console.${params.type}: ${params.args.map(({ value, description }) => value ?? description).join(" ")}`);
    } else if (method === "Runtime.exceptionThrown") {
      const { text, exception } = params.exceptionDetails;
      this.problems.push(`uncaught: ${exception?.description ?? text}`);
    } else if (method === "Log.entryAdded" && ["error", "warning"].includes(params.entry.level)) {
      this.problems.push(`log: ${params.entry.text} ${params.entry.url ?? ""}`);
    } else if (method === "Network.loadingFailed") {
      this.problems.push(`request failed: ${params.errorText}`);
    } else if (method === "Network.responseReceived" && params.response.status >= 400) {
      this.problems.push(`request: ${params.response.status} for ${params.response.url}`);
    }
  }

  // The value of an expression, awaited, in the page.
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  // Calls a function of the page's world with plain arguments.
  call(action, ...values) {
    return this.evaluate(`(${action})(...${JSON.stringify(values)})`);
  }

  async until(condition, seconds = 20) {
    const last = Date.now() + 1000 * seconds;
    while (!(await this.evaluate(condition))) {
      if (Date.now() > last) throw new Error(`after ${seconds} s still not: ${condition}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  async screenshot() {
    const { data } = await this.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: false });
    return Buffer.from(data, "base64");
  }

  async close() {
    await this.pipe.send("Target.closeTarget", { targetId: this.targetId });
    this.pipe.heard.delete(this.hear);
  }
}
