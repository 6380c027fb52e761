// What a page does beyond being read: theme, records beside their numbers, sorting and filtering of
// tables, search. Everything works from a folder; nothing is fetched.
(() => {
  "use strict";
  const root = document.documentElement;
  const $ = (id) => document.getElementById(id);

  // The reader's choice of theme; without storage it lasts for the page.
  const remembered = () => { try { return localStorage.getItem("theme"); } catch { return null; } };
  const isDark = () => (root.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";
  const chosen = remembered();
  if (chosen) root.dataset.theme = chosen;
  const theme = $("theme");
  theme.hidden = false;
  theme.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    try { localStorage.setItem("theme", root.dataset.theme); } catch { /* lasts for the page */ }
    document.dispatchEvent(new Event("theme"));
  });

  // On a wide screen the contents are always open.
  const contents = document.querySelector("nav.side > details");
  const wide = matchMedia("(min-width: 60.01rem)");
  const settle = () => { contents.open = wide.matches; };
  wide.addEventListener("change", settle);
  settle();
  const here = contents.querySelector("[aria-current]");
  if (here && wide.matches) contents.scrollTop = Math.max(0, here.offsetTop - 120);

  // A record opens beside the number that was clicked. Without this it opens in the middle.
  let opener = null;
  document.addEventListener("click", (event) => {
    const button = event.target.closest("button[popovertarget]");
    if (button && !button.classList.contains("close")) opener = button;
  }, true);
  const place = (panel) => {
    if (!opener) return;
    const at = opener.getClientRects()[0], gap = 8;
    if (!at) return;
    panel.style.maxHeight = "";
    const roof = Math.max(0, document.querySelector("header.top").getBoundingClientRect().bottom);
    const width = panel.offsetWidth, height = panel.offsetHeight;
    const left = Math.min(Math.max(gap, at.left), innerWidth - width - gap);
    const above = at.top - roof - 2 * gap, below = innerHeight - at.bottom - 2 * gap;
    const under = height <= below || below >= above;
    const room = Math.max(160, Math.min(height, under ? below : above));
    const top = Math.max(roof + gap, Math.min(under ? at.bottom + gap : at.top - gap - room, innerHeight - room - gap));
    Object.assign(panel.style, { margin: "0", left: `${left}px`, top: `${top}px`, right: "auto", bottom: "auto" });
    panel.style.maxHeight = `${Math.min(room, innerHeight - top - gap)}px`;
  };
  for (const panel of document.querySelectorAll("[popover]"))
    panel.addEventListener("toggle", (event) => { if (event.newState === "open") place(panel); });

  // A link to a line of folded code opens it, and paper has all.
  const unfold = () => {
    const at = $(decodeURIComponent(location.hash.slice(1))), around = at?.closest("details");
    if (around && !around.open) { around.open = true; at.scrollIntoView(); }
  };
  addEventListener("hashchange", unfold);
  addEventListener("load", unfold);
  addEventListener("beforeprint", () => { for (const one of document.querySelectorAll("details.block")) one.open = true; });

  // Tables: a button in each heading sorts; numbers by size, the rest by text.
  const key = (cell) => {
    const text = cell.dataset.key ?? cell.textContent.trim();
    const number = Number(text);
    return text !== "" && Number.isFinite(number) ? [0, number, ""] : [text === "" ? 2 : 1, 0, text.toLowerCase()];
  };
  for (const table of document.querySelectorAll("table.sortable")) {
    const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
    heads.forEach((head, column) => head.querySelector("button")?.addEventListener("click", () => {
      const up = head.getAttribute("aria-sort") !== "ascending";
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      const rows = [...body.rows].map((row, i) => [key(row.cells[column]), i, row]);
      rows.sort(([a, i], [b, j]) => ((a[0] - b[0]) || (up ? 1 : -1) * ((a[1] - b[1]) || a[2].localeCompare(b[2]))) || i - j);
      body.append(...rows.map(([, , row]) => row));
    }));
  }
  const filter = $("filter"), only = $("only");
  if (filter) {
    const apply = () => {
      const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
      for (const row of document.querySelectorAll("table.sortable tbody tr")) {
        const text = row.textContent.toLowerCase();
        row.hidden = !words.every((w) => text.includes(w)) || !!(only?.value && row.dataset.verdict !== only.value);
      }
    };
    filter.addEventListener("input", apply);
    only?.addEventListener("change", apply);
  }

  // "/" leads to the search from everywhere.
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName)) return;
    event.preventDefault();
    (($("query")) || document.querySelector("header.top input")).focus();
  });

  // The search page: every word must occur; titles weigh most. SEARCH comes from search-index.js.
  const query = $("query");
  if (query && window.SEARCH) {
    // Accents, kinds of dashes and of apostrophes make no difference.
    const fold = (text) => text.normalize("NFD").replace(/[\u0300-\u036f]/g, "").replace(/’/g, "'").replace(/[\u2010-\u2015\u2212]/g, "-").toLowerCase();
    // "fig 19" means figure 19 and neither figure x19 nor a number with 19 in it: a whole word of a title counts most.
    const whole = (text, w) => (" " + text.replace(/[^a-z0-9_.-]+/g, " ") + " ").includes(" " + w + " ");
    const asked = (text) => fold(text).replace(/\bfig(?:ure)?s?\.?\s*0*(x?\d)/g, "figure $1").split(/[\s,;]+/).map((w) => w.replace(/[.:?!]+$/, "")).filter(Boolean);
    const entries = window.SEARCH.map(([url, page, title, text]) => ({ url, page, title, text, t: fold(title + " " + page), x: fold(text) }));
    const list = $("results"), count = $("count");
    const piece = (text, words) => {
      const folded = fold(text);
      const first = Math.min(...words.map((w) => { const at = folded.indexOf(w); return at < 0 ? Infinity : at; }));
      const near = Number.isFinite(first) ? Math.max(0, first - 70) : 0, from = near ? text.indexOf(" ", near) + 1 : 0;
      const out = document.createElement("span");
      const part = (from ? "… " : "") + text.slice(from, from + 230) + (text.length > from + 230 ? " …" : "");
      const shown = fold(part);
      for (let at = 0; at < part.length;) {
        const hits = words.map((w) => [shown.indexOf(w, at), w.length]).filter(([i]) => i >= 0).sort((a, b) => a[0] - b[0] || b[1] - a[1]);
        if (!hits.length || shown.length !== part.length) { out.append(part.slice(at)); break; }
        const [i, length] = hits[0], mark = document.createElement("mark");
        mark.textContent = part.slice(i, i + length);
        out.append(part.slice(at, i), mark);
        at = i + length;
      }
      return out;
    };
    const search = () => {
      const words = asked(query.value);
      const hits = words.length ? entries.map((e) => {
        let score = 0;
        for (const w of words) {
          const inTitle = e.t.includes(w), times = e.x.split(w).length - 1;
          if (!inTitle && !times) return [0, e];
          score += (whole(e.t, w) ? 30 : 0) + (inTitle ? 10 : 0) + (whole(e.x, w) ? 3 : 0) + Math.min(times, 5);
        }
        return [score + (e.t.startsWith(words.join(" ")) ? 20 : 0), e];
      }).filter(([score]) => score > 0).sort((a, b) => b[0] - a[0]) : [];
      count.textContent = words.length ? `${hits.length} place${hits.length === 1 ? "" : "s"}${hits.length > 60 ? ", the best 60 shown" : ""}` : "";
      list.replaceChildren(...hits.slice(0, 60).map(([, e]) => {
        const item = document.createElement("li"), link = document.createElement("a"), where = document.createElement("small"), text = document.createElement("div");
        link.href = e.url;
        link.textContent = e.title;
        where.textContent = e.page === e.title ? "" : " " + e.page;
        text.append(piece(e.text, words));
        item.append(link, where, text);
        return item;
      }));
    };
    query.value = new URLSearchParams(location.search).get("q") || "";
    query.addEventListener("input", search);
    search();
    query.focus({ preventScroll: true });
  }
})();
