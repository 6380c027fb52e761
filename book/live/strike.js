// Strike the chain: a map that grows while it is computed, the velocities at the end, where the energy is.
(() => {
  "use strict";
  const { Panel, Plot, make } = Live;

  // The colours of the maps, from nothing to much.
  const STOPS = [[252, 253, 191], [254, 176, 120], [241, 96, 93], [183, 55, 121], [114, 31, 129], [44, 17, 95], [0, 0, 4]];
  const PALETTE = Array.from({ length: 256 }, (_, i) => {
    const at = i / 255 * (STOPS.length - 1), k = Math.min(Math.floor(at), STOPS.length - 2);
    return STOPS[k].map((a, c) => Math.round(a + (STOPS[k + 1][c] - a) * (at - k)));
  });

  Live.kinds.strike = class extends Panel {
    page() { return "strike"; }
    verb() { return "Strike"; }
    fields() {
      return [["velocity", "impact velocity", 1.87, 1e-6, 100, "v₀"], ["s", "anharmonicity", -1 / 6, -10, 10, "s"],
        ["precompression", "precompression", 0, 0, 100, "d"], ["time", "time", 587, 1, 5000, "t"], ["sites", "number of beads", 160, 2, 1500, "N"]];
    }
    choices() {
      return [["onsite", "well", [["quartic", "quartic, Eq. (10)"], ["pendulum", "pendulum"]]],
        ["show", "the map shows", [["density", "energy density"], ["force", "contact force"]]]];
    }

    request() {
      const a = this.ask;
      return [a.velocity, a.onsite === "pendulum" ? 1 : 0, a.s, a.precompression, a.time, a.sites, 1e-4, a.show === "force" ? 1 : 0, 420];
    }

    commands() {
      const a = this.ask;
      return `build/bin/sec34_impact run --velocity ${a.velocity} --time ${a.time} --sites ${a.sites}`
        + (a.onsite === "pendulum" ? " --onsite pendulum" : ` --s ${a.s}`) + (a.precompression ? ` --precompression ${a.precompression}` : "");
    }

    furnish() {
      this.map = make("canvas", { role: "img" });
      this.profile = make("canvas", { role: "img" });
      this.budget = make("div");
      this.shows.append(this.map, this.profile, this.budget);
    }

    begin() {
      this.inputs.s.disabled = this.ask.onsite === "pendulum";
      this.budget.replaceChildren();
    }

    progress(t) {
      this.say(`computing with step 0.2${this.level ? `/${2 ** this.level}` : ""}: t = ${t.toFixed(0)} of ${this.ask.time}`);
    }

    report() {
      this.say(`computed in ${this.seconds.toFixed(2)} s; two runs, the finer with step 0.2/${2 ** this.level}, agree to 10⁻⁴, and their difference is the error`);
      const stays = this.facts.boundary_energy_fraction.value, share = this.facts.packet_energy_fraction.value;
      // A packet that stands at the end is not another one than what stays there.
      if (this.facts.centre.value > 11 && Number.isFinite(share)) {
        const rest = Math.max(0, 1 - stays - share), percent = (x) => `${(100 * x).toFixed(1)} %`;
        const part = (name, x) => make("span", { class: name, style: `flex-grow: ${Math.max(x, 0.0005)}` });
        this.budget.append(make("div", { class: "bar", "aria-hidden": "true" }, part("stays", stays), part("rest", rest), part("packet", share)),
          make("p", {}, `Where the energy is at the end: ${percent(stays)} on the first five beads, ${percent(share)} in the packet, ${percent(rest)} elsewhere.`));
      }
      this.fact("speed", "speed of the packet beyond site 20", "sites per unit of time");
      this.fact("centre", "place of the packet at the end", "(site)");
      this.fact("peak_energy_density", "largest energy density of the packet");
      this.fact("packet_energy_fraction", "share of the energy in the packet");
      this.fact("boundary_energy_fraction", "share that stays on the first five beads");
      this.fact("energy_drift", "relative drift of the energy");
    }

    // Time to the right and sites upward; the row of a time fills the place up to the next one.
    draw() {
      if (!this.rows?.length) return;
      const { sites, time } = this.ask, force = this.ask.show === "force", rows = this.rows;
      let largest = 0;
      for (const { t, values } of rows) if (t > 0.03 * time || rows.length < 5) for (const x of values) largest = Math.max(largest, Math.abs(x));
      const image = new ImageData(rows.length, sites);
      rows.forEach(({ values }, i) => {
        for (let n = 0; n < sites; ++n) {
          const share = Math.min(1, Math.abs(values[n] || 0) / (largest || 1));
          const colour = PALETTE[Math.round(255 * share ** 0.4)], at = 4 * ((sites - 1 - n) * rows.length + i);
          image.data.set([...colour, 255], at);
        }
      });
      const strip = document.createElement("canvas");
      strip.width = image.width; strip.height = image.height;
      strip.getContext("2d").putImageData(image, 0, 0);
      const map = new Plot(this.map, Math.min(380, Math.max(230, this.map.clientWidth * 0.5)), [0, time], [0.5, sites + 0.5]);
      map.pen.imageSmoothingEnabled = false;
      map.pen.drawImage(strip, map.left, map.top, Math.max(1, map.width * rows.at(-1).t / time), map.height);
      map.axes("time t", force ? "contact n" : "site n");
      this.map.setAttribute("aria-label", `Map of the ${force ? "contact force" : "energy density"} over time and sites, up to ${largest.toPrecision(3)}`);
      const v = this.lists.v || [], most = 1.05 * v.reduce((m, x) => Math.max(m, Math.abs(x)), 0) || 1;
      const profile = new Plot(this.profile, 170, [0.5, sites + 0.5], [-most, most]);
      if (!v.length) return;
      profile.line([...v].map((x, n) => [n + 1, x]));
      profile.axes(`site n, at t = ${time}`, "velocity");
      this.profile.setAttribute("aria-label", "Velocities of all beads at the end");
    }
  };
})();
