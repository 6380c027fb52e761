// Reads [[TeX, displayed], ...] and writes the HTML of each formula. What KaTeX refuses is an error
// that names the formula.
const katex = (() => {
  for (const place of ["katex", "/usr/share/nodejs/katex", "/usr/share/javascript/katex/katex.js"]) {
    try { return require(place); } catch (error) { /* the next place */ }
  }
  console.error("katex is not installed (Debian: katex, libjs-katex)");
  process.exit(1);
})();

const refused = [];
const out = JSON.parse(require("fs").readFileSync(0, "utf8")).map(([tex, displayMode]) => {
  try {
    return katex.renderToString(tex, { displayMode, throwOnError: true, strict: "error", output: "htmlAndMathml" });
  } catch (error) {
    refused.push(`${error.message.slice(0, 200)} in: ${tex.slice(0, 200)}`);
    return "";
  }
});
if (refused.length) {
  console.error(refused.join("\n"));
  process.exit(1);
}
process.stdout.write(JSON.stringify(out));
