// A breather: how Newton's method ends, its profile, its multipliers on the circle, and what a kick does.
(() => {
  "use strict";
  const { Panel, Plot, make, rounded } = Live;
  const BLUE = "#0072b2", ORANGE = "#d55e00";

  Live.kinds.breather = class extends Panel {
    verb() { return "Find"; }
    fields() {
      return [["omega", "frequency", 1.1, 1.001, 3, "ω_b"], ["s", "anharmonicity", 0, -10, 10, "s"],
        ["kick", "kick along the chain", 0, -0.01, 0.01, "c"], ["time", "time after the kick", 6000, 200, 40000, "t"]];
    }
    choices() { return [["centre", "centre", [["site", "a site"], ["bond", "a bond, compressed"], ["stretched", "a bond, stretched"]]]]; }

    request() {
      const a = this.ask;
      return [a.centre === "site" ? 0 : 1, a.centre === "stretched" ? 1 : 0, a.omega, a.s, a.kick, a.time];
    }

    commands() {
      const a = this.ask, centre = `--centre ${a.centre === "site" ? "site" : "bond"}`, phase = a.centre === "stretched" ? " --phase stretched" : "";
      const out = [`build/bin/sec32_newton_breathers breather ${centre} --omega ${a.omega} --s ${a.s}${phase}`,
        `build/bin/sec33_floquet multipliers ${centre} --omega ${a.omega} --s ${a.s}`];
      if (a.kick && a.s === 0) out.push(`build/bin/sec33_mobility kick ${centre} --omega ${a.omega} --c ${a.kick} --time ${a.time}${phase}`);
      return out.join("\n");
    }

    canvases() { return ["profile", "circle", "path"]; }

    begin() {
      if (!this.history) this.profile.after(this.history = make("p"));
      this.history.textContent = "";
      for (const canvas of [this.profile, this.circle]) canvas.hidden = true;
      this.path.hidden = this.ask.kick === 0;
    }

    progress(t) { this.say(`following the kick with step ${this.level ? 0.05 : 0.1}: t = ${t.toFixed(0)} of ${this.ask.time}`); }

    report() {
      const f = this.facts, kicked = "fate" in f;
      this.say(`computed in ${this.seconds.toFixed(2)} s; every number was computed with two tolerances${kicked ? " or steps" : ""}, and their difference is in its error`);
      this.fact("amplitude", "amplitude");
      this.fact("energy", "energy");
      this.fact("area", "area of the orbit (2π times the action)");
      this.fact("residual", "residual over a whole period, relative");
      this.fact("sites", "sites of the chain", "", String(f.sites.value));
      this.fact("pinning_kappa", "κ of the translational pair; unstable where positive");
      const count = f.unstable_pairs.value;
      this.fact("largest_modulus", "largest modulus of a multiplier");
      this.fact("unstable_pairs", "stability", "", count ? `unstable: ${count} pair${count > 1 ? "s" : ""} of multipliers off the circle, beyond the error`
        : "every multiplier on the circle, within its error");
      if (!kicked) return;
      this.fact("speed", "mean speed after the kick", "sites per unit of time");
      this.fact("travelled", "sites travelled");
      this.fact("margin", "ratio of the kick's energy to the energy drift", "", rounded(f.margin.value, 2));
      const trusted = f.margin.value > 100;
      this.fact("fate", "fate after the kick", "", !trusted ? "no verdict: the integration drifts too much for so weak a kick"
        : f.share.value < 0.9 ? "it breaks up" : ["undecided in this time", "it is depinned and moves on", "it is pinned"][f.fate.value]);
    }

    draw() {
      const { y, residuals, multipliers } = this.lists || {};
      if (y) {
        this.profile.hidden = false;
        const sites = y.length, first = -Math.floor((sites - 1) / 2), most = 1.1 * y.reduce((m, x) => Math.max(m, Math.abs(x)), 0);
        const wide = Math.min(10, sites / 2);
        const plot = new Plot(this.profile, 190, [-wide, wide], [-most, most]);
        const points = [...y].map((v, i) => [first + i, v]).filter(([n]) => Math.abs(n) <= wide);
        plot.line(points, BLUE);
        plot.dots(points, BLUE);
        plot.axes("site n", "position at t = 0");
        this.profile.setAttribute("aria-label", "Positions of the breather at t = 0");
        this.history.textContent = `Newton's residuals, relative to the amplitude: ${[...residuals].map((r) => rounded(r, 2)).join(", ")}.`;
      }
      if (multipliers) {
        this.circle.hidden = false;
        const points = [];
        for (let k = 0; k < multipliers.length; k += 2) points.push([multipliers[k], multipliers[k + 1]]);
        const reach = Math.max(1.15, ...points.map(([a]) => Math.abs(a))), tall = Math.min(330, this.circle.clientWidth * 0.8);
        const across = reach * (this.circle.clientWidth - 70) / (tall - 44);
        const plot = new Plot(this.circle, tall, [-across, across], [-reach, reach]);
        plot.line(Array.from({ length: 181 }, (_, k) => [Math.cos(k * Math.PI / 90), Math.sin(k * Math.PI / 90)]));
        plot.dots(points, ORANGE, 3.5);
        plot.axes("real part of the multipliers", "imaginary part");
        this.circle.setAttribute("aria-label", "Floquet multipliers and the unit circle");
      }
      if (this.rows?.length > 1 && this.ask.kick) {
        const points = this.rows.map(({ t, values }) => [t, values[0]]);
        const all = points.map(([, x]) => x), low = Math.min(0, ...all), high = Math.max(0, ...all), pad = 0.08 * (high - low) || 1e-6;
        const plot = new Plot(this.path, 190, [0, this.ask.time], [low - pad, high + pad]);
        plot.line(points, BLUE);
        plot.axes("time t", "centre moved (sites)");
        this.path.setAttribute("aria-label", "Path of the energy centre after the kick");
      }
    }
  };
})();
