// Strikes the chain in the page: a form, a worker that runs the compiled library, a map that grows
// while it is computed, and the numbers with their errors. LIVE_STRIKE (strike.js) holds the module.
(() => {
  "use strict";

  // What runs in the worker; it knows nothing of the page. One instance a run.
  function worker() {
    let bytes;
    self.onmessage = async ({ data }) => {
      if (data.module) { bytes = data.module; return; }
      let memory, rows = [], last = 0;
      const text = (at, n) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, n));
      const numbers = (at, n) => new Float64Array(memory.buffer, at, n).slice();
      const flush = () => { if (rows.length) self.postMessage({ rows }); rows = []; last = performance.now(); };
      const facts = [];
      let profile = null;
      const page = {
        row(halvings, t, at, n) { rows.push([halvings, t, numbers(at, n)]); if (performance.now() - last > 30) flush(); },
        profile(y, v, e, n) { profile = { y: numbers(y, n), v: numbers(v, n), e: numbers(e, n) }; },
        fact(at, n, value, error) { facts.push([text(at, n), value, error]); },
        fail(at, n) { throw new Error(text(at, n)); },
      };
      const none = new Proxy({}, { get: (_, name) => () => { throw new Error(`the module asks for ${String(name)}`); } });
      const begin = performance.now();
      try {
        const { instance } = await WebAssembly.instantiate(bytes, { page, wasi_snapshot_preview1: none });
        memory = instance.exports.memory;
        instance.exports.__wasm_call_ctors();
        new Float64Array(memory.buffer, instance.exports.request(), data.request.length).set(data.request);
        instance.exports.run();
        flush();
        self.postMessage({ facts, profile, seconds: (performance.now() - begin) / 1000 });
      } catch (error) {
        flush();
        self.postMessage({ failure: error.message });
      }
    };
  }

  // The module travels as text: base64 of a gzip.
  let loaded = null;
  const load = () => loaded ??= (async () => {
    await new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = "strike.js";
      script.onload = resolve;
      script.onerror = () => reject(new Error("strike.js is missing"));
      document.head.append(script);
    });
    const packed = Uint8Array.from(atob(window.LIVE_STRIKE), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  })();

  // Parameters: what they are called on the command line, in words, and what is allowed.
  const FIELDS = [
    ["velocity", "impact velocity", 1.87, 1e-6, 100, "v₀"], ["s", "anharmonicity of the well", -1 / 6, -10, 10, "s"],
    ["precompression", "precompression", 0, 0, 100, "d"], ["time", "time", 587, 1, 5000, "t"], ["sites", "number of beads", 160, 2, 1500, "N"]];
  const shown = (x) => x === -1 / 6 ? "-1/6" : String(x);
  // A number, or a fraction of two.
  const parsed = (text) => {
    const found = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(?:\/\s*([\d.]+))?\s*$/i.exec(text);
    return found ? Number(found[1]) / (found[2] === undefined ? 1 : Number(found[2])) : NaN;
  };
  const make = (tag, attributes = {}, ...inside) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...inside);
    return element;
  };

  // As the programs print a value with its error: digits end where the error begins.
  const power = (x) => Math.floor(Math.log10(Math.abs(x)));
  const rounded = (x, digits) => x.toPrecision(digits).replace(/e\+?(-?)(\d+)/, (_, sign, n) => `·10${[...sign + n].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("")}`).replace("-", "−");
  const withError = (value, error) => {
    if (!Number.isFinite(value)) return "there is none";
    if (error === 0 || value === 0) return rounded(value, 6);
    const digits = Math.min(Math.max(power(value) - power(error) + 1, 1), 9);
    return `${rounded(value, digits)} ± ${rounded(error, 1)}`;
  };
  const QUANTITIES = {
    speed: ["speed of the packet beyond site 20", "sites per unit of time"], centre: ["where the packet is at the end", "site"],
    peak_energy_density: ["largest energy density of the packet", ""], packet_energy_fraction: ["share of the energy in the packet", ""],
    boundary_energy_fraction: ["share that stays on the first five beads", ""], energy_drift: ["relative drift of the energy", ""],
  };

  // The colours of the maps, from nothing to much.
  const STOPS = [[252, 253, 191], [254, 176, 120], [241, 96, 93], [183, 55, 121], [114, 31, 129], [44, 17, 95], [0, 0, 4]];
  const PALETTE = Array.from({ length: 256 }, (_, i) => {
    const at = i / 255 * (STOPS.length - 1), k = Math.min(Math.floor(at), STOPS.length - 2);
    return STOPS[k].map((a, c) => Math.round(a + (STOPS[k + 1][c] - a) * (at - k)));
  });

  class Panel {
    constructor(place, given = {}) {
      this.place = place;
      this.ask = Object.fromEntries(FIELDS.map(([name, , value]) => [name, value]));
      Object.assign(this.ask, { onsite: "quartic", show: "density" }, given);
      this.build();
      this.start();
    }

    build() {
      const form = make("form", { class: "controls", novalidate: "" });
      this.inputs = {};
      for (const [name, words, , , , symbol] of FIELDS) {
        const input = make("input", { type: "text", inputmode: "text", name, value: shown(this.ask[name]), autocomplete: "off", spellcheck: "false" });
        this.inputs[name] = input;
        form.append(make("label", { title: words }, `${symbol}, ${words} `, input));
      }
      const choice = (name, words, options) => {
        const select = make("select", { name });
        for (const [value, text] of options) select.append(make("option", { value }, text));
        select.value = this.ask[name];
        this.inputs[name] = select;
        form.append(make("label", {}, words + " ", select));
      };
      choice("onsite", "well", [["quartic", "quartic, Eq. (10)"], ["pendulum", "pendulum"]]);
      choice("show", "the map shows", [["density", "energy density"], ["force", "contact force"]]);
      this.go = make("button", { class: "button go", type: "submit" }, "Strike");
      form.append(this.go);
      this.status = make("p", { role: "status", class: "live-status" });
      this.map = make("canvas", { class: "live-map", role: "img" });
      this.profile = make("canvas", { class: "live-profile", role: "img" });
      this.budget = make("div", { class: "budget" });
      this.table = make("table");
      this.command = make("pre", { tabindex: "0" });
      this.link = make("a", { href: "#" }, "Link to these parameters");
      this.place.append(form, this.status, this.map, this.profile, this.budget, make("div", { class: "scroll", tabindex: "0" }, this.table), this.command, make("p", {}, this.link));
      form.addEventListener("submit", (event) => {
        event.preventDefault();
        if (this.place.dataset.state === "running") this.stop(); else this.start();
      });
      for (const name of ["onsite", "show"]) this.inputs[name].addEventListener("change", () => this.start());
      document.addEventListener("theme", () => this.draw());
      new ResizeObserver(() => this.draw()).observe(this.map);
    }

    // Reads the form; what cannot be used is said in words and nothing runs.
    read() {
      for (const [name, words, , least, most] of FIELDS) {
        const input = this.inputs[name], value = parsed(input.value);
        const whole = name !== "sites" || Number.isInteger(value);
        const good = value >= least && value <= most && whole;
        input.toggleAttribute("aria-invalid", !good);
        if (!good) {
          this.say(`${words} = ${input.value.trim() || "nothing"} cannot be used; allowed ${whole ? "is" : "are whole numbers"} from ${least} to ${most}`, true);
          input.focus();
          return false;
        }
        this.ask[name] = value;
      }
      this.ask.onsite = this.inputs.onsite.value;
      this.ask.show = this.inputs.show.value;
      return true;
    }

    stop() {
      this.worker?.terminate();
      this.become("stopped");
      this.say("stopped");
    }

    become(state) {
      this.place.dataset.state = state;
      this.go.textContent = state === "running" ? "Stop" : "Strike";
    }

    say(text, bad = false) {
      this.status.textContent = text;
      this.status.classList.toggle("discrepant", bad);
    }

    commandLine() {
      const a = this.ask;
      return `build/bin/sec34_impact run --velocity ${a.velocity} --time ${a.time} --sites ${a.sites}`
        + (a.onsite === "pendulum" ? " --onsite pendulum" : ` --s ${a.s}`) + (a.precompression ? ` --precompression ${a.precompression}` : "");
    }

    async start() {
      if (!this.read()) return;
      this.worker?.terminate();
      const a = this.ask;
      this.rows = []; this.level = 0; this.done = null; this.largest = 0;
      this.inputs.s.disabled = a.onsite === "pendulum";
      this.command.textContent = this.commandLine();
      const query = new URLSearchParams(Object.entries(a).map(([k, v]) => [k, shown(v)]));
      this.link.href = `strike.html?${query}`;
      this.budget.replaceChildren(); this.table.replaceChildren();
      this.become("running");
      this.say("computing …");
      const bytes = await load();
      const source = `(${worker})();`;
      this.worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
      this.worker.onmessage = ({ data }) => this.hear(data);
      this.worker.postMessage({ module: bytes });
      const forces = a.show === "force" ? 1 : 0;
      this.worker.postMessage({ request: [a.velocity, a.onsite === "pendulum" ? 1 : 0, a.s, a.precompression, a.time, a.sites, 1e-4, forces, 420] });
    }

    hear(data) {
      for (const [halvings, t, values] of data.rows || []) {
        if (halvings > this.level) { this.level = halvings; this.next = 0; }
        const at = halvings ? this.next++ : this.rows.length;
        this.rows[at] = { t, values };
      }
      if (data.failure !== undefined) {
        this.become("failed");
        const chaos = /two resolutions differ/.test(data.failure) ? "No number: the motion is too irregular for its end to be known after so long a time. " : "";
        this.say(chaos + data.failure, true);
      }
      if (data.facts) {
        this.done = data;
        this.facts = Object.fromEntries(data.facts.map(([name, value, error]) => [name, { value, error }]));
        this.report();
        this.become("done");
      } else if (data.rows && this.place.dataset.state === "running") {
        const last = this.rows[(this.level ? this.next : this.rows.length) - 1];
        this.say(`computing with step 0.2${this.level ? `/${2 ** this.level}` : ""}: t = ${last.t.toFixed(0)} of ${this.ask.time}`);
      }
      if (!this.pending) {
        this.pending = true;
        requestAnimationFrame(() => { this.pending = false; this.draw(); });
      }
    }

    report() {
      const { value } = this.facts.packet_energy_fraction, stays = this.facts.boundary_energy_fraction.value;
      const packet = Number.isFinite(value) ? value : 0;
      const near = this.facts.centre.value < 11;
      this.say(`computed in ${this.done.seconds.toFixed(2)} s; two runs, the finer with step 0.2/${2 ** this.level}, agree to 10⁻⁴, and their difference is the error`);
      const part = (name, share) => make("span", { class: name, style: `flex-grow: ${Math.max(share, 0.0005)}`, title: `${name} ${(100 * share).toFixed(1)} %` });
      if (!near) {
        const rest = Math.max(0, 1 - stays - packet);
        this.budget.append(make("div", { class: "bar", "aria-hidden": "true" }, part("stays", stays), part("rest", rest), part("packet", packet)),
          make("p", {}, `Where the energy is at the end: ${(100 * stays).toFixed(1)} % on the first five beads, ${(100 * packet).toFixed(1)} % in the packet, ${(100 * rest).toFixed(1)} % elsewhere.`));
      }
      for (const [name, [words, unit]] of Object.entries(QUANTITIES)) {
        const { value, error } = this.facts[name];
        this.table.append(make("tr", { "data-quantity": name, "data-value": String(value), "data-error": String(error) }, make("th", { scope: "row" }, words), make("td", {}, `${withError(value, error)}${unit && Number.isFinite(value) ? " " + unit : ""}`)));
      }
    }

    // Drawing: maps as in the figures, time to the right and sites upward.
    canvas(canvas, height) {
      const width = Math.max(200, canvas.clientWidth), scale = window.devicePixelRatio || 1;
      canvas.style.height = height + "px";
      if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
      if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
      const pen = canvas.getContext("2d");
      pen.setTransform(scale, 0, 0, scale, 0, 0);
      pen.clearRect(0, 0, width, height);
      const style = getComputedStyle(canvas);
      pen.font = `12px ${style.fontFamily}`;
      pen.fillStyle = pen.strokeStyle = style.color;
      pen.lineWidth = 1;
      return { pen, width, height, left: 46, right: 10, top: 8, bottom: 34 };
    }

    axes(c, xs, ys, x, y) {
      const { pen } = c, w = c.width - c.left - c.right, h = c.height - c.top - c.bottom;
      pen.strokeRect(c.left + 0.5, c.top + 0.5, w - 1, h - 1);
      const ticks = (least, most) => {
        const rough = (most - least) / 5, size = 10 ** Math.floor(Math.log10(rough));
        const each = [1, 2, 5, 10].map((k) => k * size).find((k) => k >= rough);
        const out = [];
        for (let v = Math.ceil(least / each) * each; v <= most * (1 + 1e-9) + 1e-12; v += each) out.push(Math.abs(v) < each * 1e-6 ? 0 : v);
        return out;
      };
      const name = (v) => String(Number(v.toPrecision(6))).replace("-", "−");
      pen.textAlign = "center"; pen.textBaseline = "top";
      for (const v of ticks(...xs)) {
        const px = c.left + (v - xs[0]) / (xs[1] - xs[0]) * w;
        pen.fillRect(px, c.top + h, 1, 4);
        pen.fillText(name(v), Math.min(px, c.width - 16), c.top + h + 5);
      }
      pen.fillText(x, c.left + w / 2, c.top + h + 20);
      pen.textAlign = "right"; pen.textBaseline = "middle";
      for (const v of ticks(...ys)) {
        const py = c.top + h - (v - ys[0]) / (ys[1] - ys[0]) * h;
        pen.fillRect(c.left - 4, py, 4, 1);
        pen.fillText(name(v), c.left - 6, py);
      }
      pen.save(); pen.translate(9, c.top + h / 2); pen.rotate(-Math.PI / 2); pen.textAlign = "center"; pen.fillText(y, 0, 0); pen.restore();
    }

    draw() {
      if (!this.rows?.length) return;
      const sites = this.ask.sites, time = this.ask.time, force = this.ask.show === "force";
      const c = this.canvas(this.map, Math.min(380, Math.max(230, this.map.clientWidth * 0.5)));
      const w = c.width - c.left - c.right, h = c.height - c.top - c.bottom;
      let largest = 0;
      for (const { t, values } of this.rows) if (t > 0.03 * time || this.rows.length < 5) for (const x of values) largest = Math.max(largest, Math.abs(x));
      const image = new ImageData(this.rows.length, sites);
      this.rows.forEach(({ values }, i) => {
        for (let n = 0; n < sites; ++n) {
          const share = Math.min(1, Math.abs(values[n] || 0) / (largest || 1));
          const colour = PALETTE[Math.round(255 * share ** 0.4)], at = 4 * ((sites - 1 - n) * this.rows.length + i);
          image.data[at] = colour[0]; image.data[at + 1] = colour[1]; image.data[at + 2] = colour[2]; image.data[at + 3] = 255;
        }
      });
      const strip = document.createElement("canvas");
      strip.width = image.width; strip.height = image.height;
      strip.getContext("2d").putImageData(image, 0, 0);
      c.pen.imageSmoothingEnabled = false;
      const reached = this.rows.at(-1).t / time;
      c.pen.drawImage(strip, c.left, c.top, Math.max(1, w * reached), h);
      this.axes(c, [0, time], [0.5, sites + 0.5], "time t", "site n");
      this.map.setAttribute("aria-label", `Map of the ${force ? "contact force" : "energy density"} over time and sites, up to ${largest.toPrecision(3)}`);
      if (!this.done?.profile) { this.canvas(this.profile, 170); return; }
      const p = this.canvas(this.profile, 170), v = this.done.profile.v;
      const most = 1.05 * v.reduce((m, x) => Math.max(m, Math.abs(x)), 0) || 1;
      const pw = p.width - p.left - p.right, ph = p.height - p.top - p.bottom;
      p.pen.beginPath();
      v.forEach((x, n) => p.pen.lineTo(p.left + (n + 0.5) / sites * pw, p.top + ph / 2 * (1 - x / most)));
      p.pen.lineWidth = 1.4; p.pen.lineJoin = "round";
      p.pen.stroke();
      p.pen.lineWidth = 1;
      this.axes(p, [0.5, sites + 0.5], [-most, most], `site n, at t = ${time}`, "velocity");
      this.profile.setAttribute("aria-label", "Velocities of all beads at the end");
    }
  }

  // The page of its own takes its parameters from the address; figures carry theirs.
  const from = (query) => {
    const given = {};
    for (const [name, value] of new URLSearchParams(query)) {
      if (FIELDS.some(([known]) => known === name) && Number.isFinite(parsed(value))) given[name] = parsed(value);
      if (name === "onsite" && /^(quartic|pendulum)$/.test(value)) given[name] = value;
      if (name === "show" && /^(density|force)$/.test(value)) given[name] = value;
    }
    return given;
  };
  const own = document.getElementById("strike");
  if (own) new Panel(own, from(location.search));
  for (const link of document.querySelectorAll("a.live")) {
    link.setAttribute("role", "button");
    link.addEventListener("click", (event) => {
      event.preventDefault();
      const figure = link.closest("figure");
      figure.querySelector(".panel")?.remove();
      const place = make("div", { class: "panel" });
      figure.append(place);
      new Panel(place, from(link.search));
    });
  }
})();
