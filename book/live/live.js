// Live pages: what they share. A panel is a form, a worker that runs the compiled library, and what it
// draws while numbers arrive. The modules (NAME.module.js) hold the library; nothing is fetched.
window.Live = (() => {
  "use strict";

  // What runs in the worker; it knows nothing of the page. One instance a run.
  function worker() {
    let bytes;
    self.onmessage = async ({ data }) => {
      if (data.module) { bytes = data.module; return; }
      let memory, rows = [], last = 0;
      const facts = [], lists = {};
      const text = (at, n) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, n));
      const numbers = (at, n) => new Float64Array(memory.buffer, at, n).slice();
      const flush = () => { if (rows.length) self.postMessage({ rows }); rows = []; last = performance.now(); };
      const page = {
        row(halvings, t, at, n) { rows.push([halvings, t, numbers(at, n)]); if (performance.now() - last > 30) flush(); },
        list(at, length, values, n) { lists[text(at, length)] = numbers(values, n); self.postMessage({ lists }); },
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
        self.postMessage({ facts, lists, seconds: (performance.now() - begin) / 1000 });
      } catch (error) {
        flush();
        self.postMessage({ failure: error.message });
      }
    };
  }

  // A module travels as text, base64 of a gzip, in a script that is loaded when it is wanted.
  const loaded = {};
  const load = (name) => loaded[name] ??= (async () => {
    await new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = `${name}.module.js`;
      script.onload = resolve;
      script.onerror = () => reject(new Error(`${script.src} is missing`));
      document.head.append(script);
    });
    const packed = Uint8Array.from(atob(window.LIVE_MODULES[name]), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  })();

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
  const raised = (text) => [...text].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
  const rounded = (x, digits) => x.toPrecision(digits).replace(/^-/, "−").replace(/e\+?(-?\d+)/, (_, n) => `·10${raised(n)}`);
  const withError = (value, error) => {
    if (!Number.isFinite(value)) return "none";
    if (error === 0 || value === 0) return rounded(value, 6);
    const digits = Math.min(Math.max(power(value) - power(error) + 1, 1), 12);
    return `${rounded(value, digits)} ± ${rounded(error, 1)}`;
  };

  // Parameters are given as [name, words, value, least, most, symbol], choices as [name, words, options, chosen], where
  // the first is chosen if none is.
  class Panel {
    constructor(name, place, given) {
      Object.assign(this, { name, place });
      this.ask = Object.fromEntries([...this.fields().map(([name, , value]) => [name, value]),
        ...this.choices().map(([name, , options, chosen]) => [name, chosen ?? options[0][0]])]);
      for (const [name, value] of new URLSearchParams(given)) this.take(name, value);
      this.build();
      this.start();
    }

    choices() { return []; }
    canvases() { return ["map"]; }

    take(name, value) {
      if (this.fields().some(([known]) => known === name) && Number.isFinite(parsed(value))) this.ask[name] = parsed(value);
      for (const [known, , options] of this.choices())
        if (known === name && options.some(([option]) => option === value)) this.ask[name] = value;
    }

    build() {
      const form = make("form", { class: "controls", novalidate: "" });
      this.inputs = {};
      for (const [name, words, , , , symbol] of this.fields()) {
        const input = make("input", { type: "text", name, value: shown(this.ask[name]), autocomplete: "off", spellcheck: "false" });
        this.inputs[name] = input;
        const [letter, ...below] = symbol.split("_");
        form.append(make("label", {}, letter, ...below.map((text) => make("sub", {}, text)), `, ${words} `, input));
      }
      for (const [name, words, options] of this.choices()) {
        const select = make("select", { name });
        for (const [value, text] of options) select.append(make("option", { value }, text));
        select.value = this.ask[name];
        select.addEventListener("change", () => this.start());
        this.inputs[name] = select;
        form.append(make("label", {}, words + " ", select));
      }
      this.go = make("button", { class: "button go", type: "submit" }, this.verb());
      form.append(this.go);
      this.status = make("p", { role: "status", class: "live-status" });
      this.shows = make("div");
      this.table = make("table");
      this.command = make("pre", { tabindex: "0" });
      this.link = make("a", { href: "#" }, "Link to these parameters");
      this.place.append(form, this.status, this.shows, make("div", { class: "scroll", tabindex: "0" }, this.table), this.command, make("p", {}, this.link));
      form.addEventListener("submit", (event) => {
        event.preventDefault();
        if (this.place.dataset.state === "running") this.stop(); else this.start();
      });
      for (const name of this.canvases()) this.shows.append(this[name] = make("canvas", { role: "img" }));
      document.addEventListener("theme", () => this.draw());
      new ResizeObserver(() => this.draw()).observe(this.shows);
    }

    // Reads the form; what cannot be used is said in words and nothing runs.
    read() {
      for (const [name, words, , least, most] of this.fields()) {
        const input = this.inputs[name], value = parsed(input.value);
        const whole = name !== "sites" || Number.isInteger(value);
        const good = value >= least && value <= most && whole;
        input.toggleAttribute("aria-invalid", !good);
        if (!good) {
          this.say(`${words} = ${input.value.trim() || "nothing"} cannot be used; allowed ${whole ? "is" : "are integers"} from ${least} to ${most}`, true);
          input.focus();
          return false;
        }
        this.ask[name] = value;
      }
      for (const [name] of this.choices()) this.ask[name] = this.inputs[name].value;
      return true;
    }

    say(text, bad = false) {
      this.status.textContent = text;
      this.status.classList.toggle("discrepant", bad);
    }

    become(state) {
      this.place.dataset.state = state;
      this.go.textContent = state === "running" ? "Stop" : this.verb();
    }

    stop() {
      this.worker?.terminate();
      this.become("stopped");
      this.say("stopped");
    }

    async start() {
      if (!this.read()) return;
      this.worker?.terminate();
      this.rows = []; this.finer = []; this.level = 0; this.lists = {}; this.facts = null;
      this.command.textContent = this.commands();
      this.link.href = `${this.name}.html?${new URLSearchParams(Object.entries(this.ask).map(([k, v]) => [k, shown(v)]))}`;
      this.table.replaceChildren();
      this.begin?.();
      this.become("running");
      this.say("computing …");
      const bytes = await load(this.name);
      if (this.address) URL.revokeObjectURL(this.address);
      this.address = URL.createObjectURL(new Blob([`(${worker})();`], { type: "text/javascript" }));
      this.worker = new Worker(this.address);
      this.worker.onmessage = ({ data }) => this.hear(data);
      this.worker.postMessage({ module: bytes });
      this.worker.postMessage({ request: this.request() });
    }

    // Rows of a finer run replace those of the coarser one when they are complete, so that a map is of one run. A run
    // that is coarser than the one before is made for the errors alone.
    hear(data) {
      for (const [halvings, t, values] of data.rows || []) {
        if (halvings < this.level) continue;
        if (halvings > this.level) { this.level = halvings; this.finer = []; }
        (this.level ? this.finer : this.rows).push({ t, values });
      }
      if (this.finer.length && (data.facts || this.finer.at(-1).t >= this.rows.at(-1).t)) { this.rows = this.finer; this.finer = []; }
      if (data.lists) this.lists = data.lists;
      if (data.failure !== undefined) {
        this.become("failed");
        const chaos = /two resolutions differ/.test(data.failure) && !/erratic/.test(data.failure) ? "No number: the motion is too irregular for its end to be known after so long a time. " : "";
        this.say(chaos + data.failure, true);
      }
      if (data.facts) {
        this.seconds = data.seconds;
        this.facts = Object.fromEntries(data.facts.map(([name, value, error]) => [name, { value, error }]));
        this.report();
        this.become("done");
      } else if (data.rows && this.place.dataset.state === "running") {
        this.progress((this.finer.at(-1) ?? this.rows.at(-1)).t);
      }
      if (!this.pending) {
        this.pending = true;
        requestAnimationFrame(() => { this.pending = false; this.draw(); });
      }
    }

    // One row of the table; names, values and errors stay readable for a test.
    fact(name, words, unit = "", text = null) {
      const { value, error } = this.facts[name];
      const said = text ?? `${withError(value, error)}${unit && Number.isFinite(value) ? " " + unit : ""}`;
      this.table.append(make("tr", { "data-quantity": name, "data-value": String(value), "data-error": String(error) },
        make("th", { scope: "row" }, words), make("td", {}, said)));
    }
  }

  // Drawing: a canvas with axes, in the colours of the page.
  class Plot {
    constructor(canvas, height, xs, ys) {
      const width = Math.max(200, canvas.clientWidth), scale = window.devicePixelRatio || 1;
      canvas.style.height = height + "px";
      canvas.width = Math.round(width * scale);
      canvas.height = Math.round(height * scale);
      this.pen = canvas.getContext("2d");
      this.pen.setTransform(scale, 0, 0, scale, 0, 0);
      const style = getComputedStyle(canvas);
      this.pen.font = `12px ${style.fontFamily}`;
      this.pen.fillStyle = this.pen.strokeStyle = style.color;
      Object.assign(this, { xs, ys, left: 66, top: 8, width: width - 66 - 12, height: height - 8 - 36, all: width });
    }

    x(v) { return this.left + (v - this.xs[0]) / (this.xs[1] - this.xs[0]) * this.width; }
    y(v) { return this.top + this.height - (v - this.ys[0]) / (this.ys[1] - this.ys[0]) * this.height; }

    axes(x, y) {
      const { pen } = this;
      pen.strokeRect(this.left + 0.5, this.top + 0.5, this.width - 1, this.height - 1);
      const ticks = ([least, most]) => {
        const rough = (most - least) / 5, size = 10 ** Math.floor(Math.log10(rough));
        const each = [1, 2, 5, 10].map((k) => k * size).find((k) => k >= rough * (1 - 1e-9)) || size;
        const out = [];
        for (let k = Math.ceil(least / each - 1e-9); k * each <= most + 1e-9 * each; ++k) out.push(k * each);
        return out;
      };
      const name = (v) => rounded(Number(v.toPrecision(4)), 4).replace(/(\.\d*?)0+(?=·|$)/, "$1").replace(/\.(?=·|$)/, "");
      pen.textAlign = "center"; pen.textBaseline = "top";
      for (const v of ticks(this.xs)) {
        pen.fillRect(this.x(v), this.top + this.height, 1, 4);
        pen.fillText(name(v), Math.min(this.x(v), this.all - 16), this.top + this.height + 6);
      }
      pen.fillText(x, this.left + this.width / 2, this.top + this.height + 22);
      pen.textAlign = "right"; pen.textBaseline = "middle";
      for (const v of ticks(this.ys)) {
        pen.fillRect(this.left - 4, this.y(v), 4, 1);
        pen.fillText(name(v), this.left - 6, this.y(v));
      }
      pen.save();
      pen.translate(8, this.top + this.height / 2); pen.rotate(-Math.PI / 2); pen.textAlign = "center";
      pen.fillText(y, 0, 0);
      pen.restore();
    }

    line(points, colour) {
      const { pen } = this, before = pen.strokeStyle;
      if (colour) pen.strokeStyle = colour;
      pen.beginPath();
      for (const [x, y] of points) pen.lineTo(this.x(x), this.y(y));
      pen.lineWidth = 1.5; pen.lineJoin = "round";
      pen.stroke();
      pen.lineWidth = 1; pen.strokeStyle = before;
    }

    dots(points, colour, radius = 3) {
      const { pen } = this, before = pen.fillStyle;
      if (colour) pen.fillStyle = colour;
      for (const [x, y] of points) { pen.beginPath(); pen.arc(this.x(x), this.y(y), radius, 0, 7); pen.fill(); }
      pen.fillStyle = before;
    }
  }

  // The colours of the maps, from nothing to much.
  const STOPS = [[252, 253, 191], [254, 176, 120], [241, 96, 93], [183, 55, 121], [114, 31, 129], [44, 17, 95], [0, 0, 4]];
  const PALETTE = Array.from({ length: 256 }, (_, i) => {
    const at = i / 255 * (STOPS.length - 1), k = Math.min(Math.floor(at), STOPS.length - 2);
    return STOPS[k].map((a, c) => Math.round(a + (STOPS[k + 1][c] - a) * (at - k)));
  });

  const colour = (share) => PALETTE[Math.round(255 * Math.min(1, share) ** 0.4)];

  // What the colours of a map mean, in a line below it.
  const drawScale = (canvas, largest, what) => {
    let line = canvas.nextElementSibling;
    if (!line?.classList.contains("scale")) canvas.after(line = make("p", { class: "scale" }));
    const stops = [0, 0.005, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 1].map((share) => `rgb(${colour(share)}) ${100 * share}%`);
    line.replaceChildren(`${what}: 0 `, make("i", { style: `background: linear-gradient(to right, ${stops})` }), ` ${rounded(largest, 3)} and more`);
  };

  // A map of rows {t, values}: time to the right, sites upward; what is there fills the time so far.
  const drawMap = (canvas, rows, [begin, end], y, x, words, what) => {
    const sites = rows[0].values.length;
    let largest = 0;
    for (const { t, values } of rows) if (t > 0.03 * end || rows.length < 5) for (const v of values) largest = Math.max(largest, Math.abs(v));
    const image = new ImageData(rows.length, sites);
    rows.forEach(({ values }, i) => {
      for (let n = 0; n < sites; ++n) {
        const share = Math.abs(values[n] || 0) / (largest || 1);
        image.data.set([...colour(share), 255], 4 * ((sites - 1 - n) * rows.length + i));
      }
    });
    const strip = document.createElement("canvas");
    strip.width = image.width; strip.height = image.height;
    strip.getContext("2d").putImageData(image, 0, 0);
    const map = new Plot(canvas, Math.min(380, Math.max(230, canvas.clientWidth * 0.5)), [begin, end], [0.5, sites + 0.5]);
    map.pen.imageSmoothingEnabled = false;
    map.pen.drawImage(strip, map.left, map.top, Math.max(1, map.width * (rows.at(-1).t - begin) / (end - begin)), map.height);
    map.axes(x, y);
    drawScale(canvas, largest, what);
    canvas.setAttribute("aria-label", `${words} over time and sites, up to ${largest.toPrecision(3)}`);
  };

  const kinds = {};
  // The page of a kind takes its parameters from the address; figures carry theirs in a link.
  const begin = () => {
    for (const [page, kind] of Object.entries(kinds)) {
      const own = document.getElementById(`live-${page}`);
      if (own) new kind(page, own, location.search);
    }
    for (const link of document.querySelectorAll("a.live")) {
      link.setAttribute("role", "button");
      link.addEventListener("click", (event) => {
        event.preventDefault();
        const figure = link.closest("figure");
        figure.querySelector(".panel")?.remove();
        const place = make("div", { class: "panel" });
        figure.append(place);
        const page = link.pathname.split("/").pop().replace(".html", "");
        new kinds[page](page, place, link.search);
      });
    }
  };
  document.addEventListener("DOMContentLoaded", begin);
  // furo says in this attribute which theme is shown.
  new MutationObserver(() => document.dispatchEvent(new Event("theme"))).observe(document.body, { attributeFilter: ["data-theme"] });
  return { Panel, Plot, drawMap, make, rounded, kinds };
})();
