"""Opens every page of the book in a headless Chromium, by Selenium and Debian's chromium-driver.

    python3 -m lineage.book.browse build/book

All pages are seen at the width of a phone. A page fails if it logs an error, asks for something that is not there or not in the folder, leaves a formula
unrendered, or must be scrolled sideways. Before it looks at the book, the browser is shown pages that are wrong."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.keys import Keys
except ImportError:
    sys.exit("browser    : python3-selenium is not installed (apt-packages.txt, [browse])")

FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--hide-scrollbars", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-extensions", "--disable-sync"]
KEYS = {"Tab": Keys.TAB, "Enter": Keys.ENTER, "Escape": Keys.ESCAPE}


class Browser:
    """One window of one Chromium, with a profile of its own."""

    def __init__(self):
        self.profile = tempfile.mkdtemp()
        options = webdriver.ChromeOptions()
        options.binary_location = os.environ.get("CHROMIUM") or shutil.which("chromium") or ""
        for flag in FLAGS + [f"--user-data-dir={self.profile}"]:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
        self.driver.set_script_timeout(180)
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": 380, "height": 800, "deviceScaleFactor": 1, "mobile": False})

    def open(self, url):
        self.complaints()  # those of the page before
        self.driver.get(url)

    def evaluate(self, code):
        """The value of an expression; of a promise, what it comes to."""
        return self.driver.execute_script("return " + code)

    def press(self, key):
        """A key as a reader presses it."""
        ActionChains(self.driver).send_keys(KEYS.get(key, key)).perform()

    def complaints(self):
        """What the browser has to say of the page, and what the page asks for beyond its folder."""
        out = [f"{entry['source']}: {entry['message']}" for entry in self.driver.get_log("browser")
               if entry["level"] in ("SEVERE", "WARNING")]
        for entry in self.driver.get_log("performance"):
            event = json.loads(entry["message"])["message"]
            if event["method"] == "Network.requestWillBeSent":
                url = event["params"]["request"]["url"]
                if not url.startswith(("file:", "data:", "about:", "blob:", "chrome:")):
                    out.append("asks for " + url)
            elif event["method"] == "Network.loadingFailed" and not event["params"].get("canceled"):
                out.append("not loaded: " + event["params"].get("errorText", "?"))
        return out

    def close(self):
        self.driver.quit()
        shutil.rmtree(self.profile, ignore_errors=True)


LOOK = """(() => {
  const out = [], root = document.documentElement;
  if (root.scrollWidth > innerWidth) {
    const wide = [...document.body.querySelectorAll("*")].filter((e) => e.getBoundingClientRect().right > innerWidth + 1
      && !e.closest("pre, .scroll, .katex-display, [popover]"));
    out.push(`scrolls sideways: ${root.scrollWidth} > ${innerWidth} ${wide.slice(0, 3).map((e) => e.tagName + "." + e.className)}`);
  }
  if (document.querySelector(".math, .katex-error")) out.push("a formula is not rendered");
  for (const image of document.images)
    if (image.complete && !image.naturalWidth) out.push("no image " + image.getAttribute("src"));
  for (const button of document.querySelectorAll("button[popovertarget]"))
    if (!button.popoverTargetElement) out.push("opens nothing: " + button.textContent);
  if (!document.querySelector("h1")) out.push("no title");
  if ([...document.querySelectorAll("[hidden]")].some((e) => e.getClientRects().length)) out.push("shows what is hidden");
  return out;
})()"""

# A number opens by the keyboard and closes again; a table sorts; the search finds.
USE = {
    "index.html": """(() => {
        const button = document.querySelector("button.num"), panel = button.popoverTargetElement;
        button.focus(); button.click();
        if (!panel.matches(":popover-open")) return "a number does not open";
        const box = panel.getBoundingClientRect();
        if (box.left < 0 || box.right > innerWidth + 1) return "a record opens beside the page";
        if (box.top < document.querySelector("header.top").getBoundingClientRect().bottom) return "a record covers the header";
        panel.hidePopover();
        const before = getComputedStyle(document.body).backgroundColor;
        document.getElementById("theme").click();
        const after = getComputedStyle(document.body).backgroundColor;
        document.getElementById("theme").click();
        return before === after ? "the theme does not change" : "";
      })()""",
    "published.html": """(() => {
        const table = document.querySelector("table.sortable"), ids = () => [...table.tBodies[0].rows].map((r) => r.id).join();
        const before = ids();
        table.querySelector("th button").click();
        if (ids() === before) return "the table does not sort";
        const filter = document.getElementById("filter");
        filter.value = "barrier"; filter.dispatchEvent(new Event("input"));
        const left = [...table.tBodies[0].rows].filter((r) => !r.hidden).length;
        return left > 0 && left < table.tBodies[0].rows.length ? "" : "the table does not filter";
      })()""",
    "search.html": """(() => {
        const query = document.getElementById("query");
        if (scrollY || document.activeElement !== query) return "the search does not open at its field";
        query.value = "surface mode"; query.dispatchEvent(new Event("input"));
        const links = [...document.querySelectorAll("#results a")].map((a) => a.getAttribute("href"));
        if (!links.some((l) => l.startsWith("sec34_impact.html#"))) return "the search does not find the surface mode: " + links;
        const first = (words) => {
          query.value = words; query.dispatchEvent(new Event("input"));
          return document.querySelector("#results a")?.getAttribute("href") ?? "nothing";
        };
        for (const [words, page] of [["fig 19", "fig-19.html"], ["Fig. x19", "fig-x19.html"], ["peierls-nabarro", "sec32_barrier.html"],
            ["Peierls\u2013Nabarro", "sec32_barrier.html"], ["sec34_impact.cpp", "sec34_"], ["--velocity", "sec3"], ["velocity_sweep", "fig-19.html"]])
          if (!first(words).startsWith(page)) return `'${words}' leads to ${first(words)}`;
        return "";
      })()""",
}


# The live page: waits until the panel in `place` has ended, and says what it shows.
ENDED = """(async (place) => {
  for (let k = 0; k < 2400 && !/done|failed/.test(place.dataset.state); ++k) await new Promise((r) => setTimeout(r, 50));
  const facts = {};
  for (const row of place.querySelectorAll("tr[data-quantity]"))
    facts[row.dataset.quantity] = [row.dataset.value, row.dataset.error];
  return { state: place.dataset.state, said: place.querySelector("[role=status]").textContent, facts,
           command: place.querySelector("pre").textContent };
})"""


def native(command, folder):
    """What the native program prints for the (first) command that a live page shows; nothing if it is not built."""
    words = command.split("\n")[0].split()
    program = os.path.join(folder, "..", "bin", os.path.basename(words[0]))
    if not os.path.exists(program):
        return {}
    run = subprocess.run([program] + words[1:], capture_output=True, text=True, check=True, timeout=120)
    rows = [line.split(",") for line in run.stdout.splitlines() if not line.startswith(("#", "quantity"))]
    return {row[0]: (float(row[1]), float(row[2])) for row in rows}


# Live pages: what is asked, what some of the answers are, and what must be said of input that has none.
LIVE = [("strike", "", {}), ("strike", "?velocity=0.94&s=-0.7&time=300&sites=80&show=force", {}),
        ("strike", "?velocity=0.5&s=1&precompression=0.5&time=60&sites=100", {}),
        ("strike", "?well=none&velocity=0.5&time=60&sites=100", {}),
        ("breather", "", {"unstable_pairs": 1}), ("breather", "?centre=bond&s=0.3", {"unstable_pairs": 1}),
        ("breather", "?centre=site&omega=1.3&s=1", {"unstable_pairs": 0}),
        ("breather", "?centre=stretched&kick=2e-4&time=3000", {"unstable_pairs": 0, "fate": 1}), ("defect", "", {}),
        ("drive", "", {"outcome": 0}), ("drive", "?amplitude=20&time=20", {"outcome": 1}),
        ("drive", "?amplitude=5&by=base&time=20", {"outcome": 1})]
FAILS = [("strike", "?velocity=3&time=100", "a bead runs away at t = "), ("strike", "?velocity=1.9&s=1&time=1000&sites=8", "differ by more"),
         ("breather", "?centre=bond&omega=1.7&s=-1", "turns back")]
REFUSED = [("abc", "cannot be used"), ("-3", "allowed"), ("", "nothing")]


# What is wrong, and a word of what must be said of it.
WRONG = [('<div style="width:900px">x</div>', "sideways"), ('<img src="none.png">', "no image|not loaded"),
         ("<script>throw Error('oh')</script>", "oh"), ("<script>console.error('ah')</script>", "ah"),
         ('<script src="http://127.0.0.1:9/x.js"></script>', "asks for"), ('<p class="math">x</p>', "formula"),
         ('<button popovertarget="x">x</button>', "opens nothing"), ("", "")]


def check_itself(browser):
    """Pages that are wrong are noticed, and one that is not wrong is let pass."""
    out = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.html"
        for wrong, words in WRONG:
            path.write_text(f'<!DOCTYPE html><meta name="viewport" content="width=device-width"><h1>T</h1>{wrong}', encoding="utf-8")
            browser.open(path.as_uri())
            found = browser.evaluate(LOOK) + browser.complaints()
            if not (re.search(words, " ".join(found)) if words else not found):
                out.append(f"the browser does not notice what is wrong with {wrong}: {found}")
    return out


def ran(browser, folder, page, query):
    """What a live page shows when it has ended."""
    browser.open("file://" + os.path.join(folder, f"{page}.html{query}"))
    found = browser.evaluate(ENDED + f"(document.getElementById('live-{page}'))")
    found["facts"] = {name: tuple(map(float, pair)) for name, pair in found["facts"].items()}
    return found


def same(page, name, ours, theirs):
    """A strike has the bits of the native program, the rest its values within the errors and rounding."""
    if page == "strike":
        return repr(ours) == repr(theirs)
    apart = ours[1] + theirs[1] + 1e-12 * abs(theirs[0])
    return abs(ours[0] - theirs[0]) <= apart or page == "breather" and name not in ("amplitude", "energy", "area")


def check_live(browser, folder):
    """The live pages: what the native program says, and words for bad input."""
    out, compared = [], False
    for page, query, ought in LIVE:
        found = ran(browser, folder, page, query)
        facts = found["facts"]
        if found["state"] != "done" or not facts or any(facts[name][0] != value for name, value in ought.items()):
            out.append(f"{page}.html{query}: {found['said']}, {facts}")
            continue
        theirs = native(found["command"], folder)
        compared = compared or bool(theirs)
        out += [f"{page}.html{query}: {name} is {facts[name]}, the native program says {theirs[name]}"
                for name in facts if name in theirs and not same(page, name, facts[name], theirs[name])]
    for page, query, words in FAILS:
        found = ran(browser, folder, page, query)
        if found["state"] != "failed" or words not in found["said"]:
            out.append(f"{page}.html{query}: expected words with '{words}', not: {found['said']}")
    ran(browser, folder, "strike", "")
    for value, words in REFUSED:
        said = browser.evaluate(f"""(() => {{ const form = document.querySelector("#live-strike form");
            form.velocity.value = "{value}"; form.requestSubmit();
            return document.querySelector("#live-strike [role=status]").textContent; }})()""")
        if words not in said:
            out.append(f"velocity = '{value}' is answered by: {said}")
    browser.open("file://" + os.path.join(folder, "sec34_impact.html"))
    found = browser.evaluate("""(() => { document.querySelector("#fig-21 a.live").click();
        return """ + ENDED + """(document.querySelector("#fig-21 .panel")); })()""")
    if found["state"] != "done" or browser.evaluate(LOOK):
        out.append(f"figure 21 cannot be computed in its chapter: {found['said']} {browser.evaluate(LOOK)}")
    return out, compared


def check_keys(browser, folder):
    """A number opens and closes, and the search is reached, by the keyboard alone."""
    out, active = [], "document.activeElement.textContent"
    opened = "!!document.querySelector('[popover]:popover-open')"
    browser.open("file://" + os.path.join(folder, "index.html"))
    browser.evaluate("document.querySelector('h1').tabIndex = -1; document.querySelector('h1').focus()")
    for _ in range(16):  # the header, the chain and six figures come first
        browser.press("Tab")
        if browser.evaluate("document.activeElement.className") == "num":
            break
    else:
        out.append("no number is reached with the tabulator key")
    number = browser.evaluate(active)
    browser.press("Enter")
    if not browser.evaluate(opened):
        out.append(f"{number} does not open with return")
    browser.press("Tab")
    if not browser.evaluate("!!document.activeElement.closest('[popover]')"):
        out.append("the keyboard does not come into the record")
    browser.press("Escape")
    if browser.evaluate(opened) or browser.evaluate(active) != number:
        out.append("escape does not close the record and return to its number")
    browser.press("/")
    if browser.evaluate("document.activeElement.name") != "q":
        out.append("a slash does not lead to the search")
    return out


def check_page(browser, folder, name):
    """What is wrong with a page, as one looks at it and uses it."""
    browser.open("file://" + os.path.join(folder, name))
    used = browser.evaluate(LOOK) + [browser.evaluate(USE[name]) if name in USE else ""]
    return [f"{name}: {complaint}" for complaint in dict.fromkeys(used + browser.complaints()) if complaint]


def check_all(browser, folder):
    """How many pages there are, and all that is wrong with each, the browser, its live pages and its keys."""
    names = sorted(n for n in os.listdir(folder) if n.endswith(".html"))
    found = [check_itself(browser), check_keys(browser, folder)]
    if "strike.html" in names:
        live, compared = check_live(browser, folder)
        found.append(live)
        print("live pages : " + ("not compared with the native program, which is not built" if not compared else
                                 "not in order" if live else "the bits of the native program"))
    return len(names), found + [check_page(browser, folder, name) for name in names]


def main(folder):
    if not shutil.which("chromedriver"):
        sys.exit("browser    : chromium-driver is not installed (apt-packages.txt, [browse])")
    browser = Browser()
    try:
        count, found = check_all(browser, os.path.abspath(folder))
    finally:
        browser.close()
    for complaint in sum(found, []):
        print(f"  {complaint}")
    failed = sum(map(bool, found))
    print(f"browser    : {count - failed} of {count} pages in order")
    return failed > 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1]))
    except WebDriverException as error:
        sys.exit(f"browser    : {error.msg or error}")
