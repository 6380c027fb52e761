"""Opens every page of the book in a headless Chromium, through the browser's own pipe.

    python3 book/browse.py build/book                    checks all pages at the width of a phone
    python3 book/browse.py build/book --shot index.html --width 1280 --dark --out shot.png

A page fails if it logs an error, asks for something that is not there or not in the folder, leaves a
formula unrendered, or must be scrolled sideways."""

import argparse
import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]


def find_browser():
    return os.environ.get("CHROMIUM") or next((p for p in map(shutil.which, NAMES) if p), None)


class Browser:
    """One tab of one Chromium, spoken to in JSON over a pair of pipes."""

    def __init__(self, program):
        self.profile = tempfile.mkdtemp()
        read, self.to = os.pipe()
        self.come, write = os.pipe()

        def pipes():
            a, b = os.dup(read), os.dup(write)  # out of the way of 3 and 4
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [program, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
             "--disable-background-networking", "--disable-component-update", "--disable-extensions",
             "--disable-sync", f"--user-data-dir={self.profile}",
             "--remote-debugging-pipe", "about:blank"],
            preexec_fn=pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(read)
        os.close(write)
        self.number, self.events, self.buffer, self.session = 0, [], b"", None
        target = next(t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")

    def receive(self):
        while b"\0" not in self.buffer:
            piece = os.read(self.come, 1 << 20)
            if not piece:
                raise RuntimeError("the browser has gone")
            self.buffer += piece
        message, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(message)

    def ask(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def open(self, url):
        self.events.clear()
        self.ask("Page.navigate", url=url)
        while not any(e.get("method") == "Page.loadEventFired" for e in self.events):
            self.events.append(self.receive())

    def evaluate(self, code):
        answer = self.ask("Runtime.evaluate", expression=code, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "an exception"))
        return answer["result"].get("value")

    def press(self, key):
        """A key as a reader presses it."""
        code = {"Enter": 13, "Escape": 27, "Tab": 9, "/": 191}[key]
        text = {"text": "\r" if key == "Enter" else key} if key in ("Enter", "/") else {}
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, **(text if kind == "keyDown" else {}))

    def size(self, width, height, scale=1):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=False)

    def dark(self, on):
        self.ask("Emulation.setEmulatedMedia",
                 features=[{"name": "prefers-color-scheme", "value": "dark" if on else "light"}])

    def shot(self, path, whole=False):
        data = self.ask("Page.captureScreenshot", format="png", captureBeyondViewport=whole)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))

    def close(self):
        try:
            self.session = None
            self.ask("Browser.close")
            self.process.wait(10)
        except (RuntimeError, OSError, subprocess.TimeoutExpired):
            self.process.kill()
        shutil.rmtree(self.profile, ignore_errors=True)


def complaints(events):
    """What the browser has to say of a page."""
    out = []
    for event in events:
        method, params = event.get("method"), event.get("params", {})
        if method == "Runtime.exceptionThrown":
            out.append("exception: " + params["exceptionDetails"].get("exception", {}).get("description", "?"))
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            out.append("console: " + " ".join(str(a.get("value", a.get("description"))) for a in params["args"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            out.append("log: " + params["entry"]["text"] + " " + params["entry"].get("url", ""))
        elif method == "Network.loadingFailed" and not params.get("canceled"):
            out.append("not loaded: " + params.get("errorText", "?"))
        elif method == "Network.requestWillBeSent":
            url = params["request"]["url"]
            if not url.startswith(("file:", "data:", "about:", "blob:")):
                out.append("asks for " + url)
    return out


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
        if (box.left < 0 || box.right > innerWidth + 1 || box.top < 0) return "a record opens beside the page";
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
        return links.some((l) => l.startsWith("sec34_impact.html#")) ? "" : "the search does not find the surface mode: " + links;
      })()""",
}


# The live page: waits until the panel in `place` has ended, and says what it shows.
ENDED = """(async (place) => {
  for (let k = 0; k < 600 && !/done|failed/.test(place.dataset.state); ++k) await new Promise((r) => setTimeout(r, 50));
  const facts = {};
  for (const row of place.querySelectorAll("tr[data-quantity]"))
    facts[row.dataset.quantity] = [row.dataset.value, row.dataset.error];
  return { state: place.dataset.state, said: place.querySelector("[role=status]").textContent, facts,
           command: place.querySelector("pre").textContent };
})"""


def native(command, bin_folder):
    """What the native program prints for the (first) command that a live page shows."""
    words = command.split("\n")[0].split()
    run = subprocess.run([os.path.join(bin_folder, os.path.basename(words[0]))] + words[1:], capture_output=True,
                         text=True, check=True, timeout=120)
    rows = [line.split(",") for line in run.stdout.splitlines() if not line.startswith(("#", "quantity"))]
    return {row[0]: (float(row[1]), float(row[2])) for row in rows}


def check_live(browser, folder):
    """Strikes of the live page: to the bit what the native program says, and words for bad input."""
    out, page = [], "file://" + os.path.join(folder, "strike.html")
    bin_folder = os.path.join(folder, "..", "bin")
    here = os.path.exists(os.path.join(bin_folder, "sec34_impact"))
    for query in ["", "?velocity=0.94&s=-0.7&time=300&sites=80&show=force", "?velocity=0.5&s=1&precompression=0.5&time=60&sites=100"]:
        browser.open(page + query)
        found = browser.evaluate(ENDED + "(document.getElementById('live-strike'))")
        if found["state"] != "done" or not found["facts"]:
            out.append(f"{query}: {found['said']}")
            continue
        theirs = native(found["command"], bin_folder) if here else {}
        for name, pair in found["facts"].items():
            value, error = map(float, pair)
            wanted = theirs.get(name, (value, error))
            if repr((value, error)) != repr(wanted):
                out.append(f"{found['command']}: {name} is {value} ± {error}, the native program says {wanted}")
    for query, words in [("?velocity=3&time=100", "blows up"), ("?velocity=1.9&s=1&time=1000&sites=8", "differ by more")]:
        browser.open(page + query)
        found = browser.evaluate(ENDED + "(document.getElementById('live-strike'))")
        if found["state"] != "failed" or words not in found["said"]:
            out.append(f"{query}: expected words with '{words}', not: {found['said']}")
    for value, words in [("abc", "cannot be used"), ("-3", "allowed"), ("", "nothing")]:
        said = browser.evaluate(f"""(() => {{ const form = document.querySelector("#live-strike form");
            form.velocity.value = "{value}"; form.requestSubmit();
            return document.querySelector("#live-strike [role=status]").textContent; }})()""")
        if words not in said:
            out.append(f"velocity = '{value}' is answered by: {said}")
    out += check_breather(browser, folder, bin_folder)
    browser.open("file://" + os.path.join(folder, "sec34_impact.html"))
    found = browser.evaluate("""(() => { document.querySelector("#fig-21 a.live").click();
        return """ + ENDED + """(document.querySelector("#fig-21 .panel")); })()""")
    if found["state"] != "done" or browser.evaluate(LOOK):
        out.append(f"figure 21 cannot be computed in its chapter: {found['said']} {browser.evaluate(LOOK)}")
    return out, here


def check_keys(browser, folder):
    """A number opens and closes, and the search is reached, by the keyboard alone."""
    out, active = [], "document.activeElement.textContent"
    opened = "!!document.querySelector('[popover]:popover-open')"
    browser.open("file://" + os.path.join(folder, "index.html"))
    browser.evaluate("document.querySelector('h1').tabIndex = -1; document.querySelector('h1').focus()")
    for _ in range(6):
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


def check_breather(browser, folder, bin_folder):
    """The breather's page: the native numbers within the errors, both verdicts, a kick, and words."""
    out, page = [], "file://" + os.path.join(folder, "breather.html")
    here = os.path.exists(os.path.join(bin_folder, "sec32_newton_breathers"))
    for query, unstable, fate in [("", 1, None), ("?centre=bond&s=0.3", 1, None), ("?centre=site&omega=1.3&s=1", 0, None),
                                  ("?centre=stretched&kick=2e-4&time=3000", 0, 1)]:
        browser.open(page + query)
        found = browser.evaluate(ENDED + "(document.getElementById('live-breather'))")
        facts = {name: tuple(map(float, pair)) for name, pair in found["facts"].items()}
        if found["state"] != "done" or facts["unstable_pairs"][0] != unstable:
            out.append(f"breather.html{query}: {found['said']}, {facts.get('unstable_pairs')}")
            continue
        if fate is not None and facts["fate"][0] != fate:
            out.append(f"breather.html{query}: the kick ends in {facts['fate']}")
        theirs = native(found["command"], bin_folder) if here else {}
        for name in ("amplitude", "energy", "area"):
            value, error = theirs.get(name, facts[name])
            if not abs(value - facts[name][0]) <= error + facts[name][1]:
                out.append(f"breather.html{query}: {name} is {facts[name]}, the native program says {value} ± {error}")
    browser.open("file://" + os.path.join(folder, "defect.html"))
    found = browser.evaluate(ENDED + "(document.getElementById('live-defect'))")
    facts = {name: tuple(map(float, pair)) for name, pair in found["facts"].items()}
    here = os.path.exists(os.path.join(bin_folder, "sec36_cantilever_defect"))
    theirs = native(found["command"], bin_folder) if here else facts
    for name, (value, error) in facts.items():
        if not abs(value - theirs[name][0]) <= error + theirs[name][1]:
            out.append(f"defect.html: {name} is {value} ± {error}, the native program says {theirs[name]}")
    if found["state"] != "done" or not facts["net_reflected"][0] > 0.95:
        out.append(f"defect.html: {found['said']}, {facts}")
    browser.open(page + "?centre=bond&omega=1.7&s=-1")
    found = browser.evaluate(ENDED + "(document.getElementById('live-breather'))")
    if found["state"] != "failed" or "turns back" not in found["said"]:
        out.append(f"a breather beyond its fold is answered by: {found['said']}")
    return out


def check_all(folder, program):
    browser, failed = Browser(program), 0
    try:
        browser.size(380, 800)
        if os.path.exists(os.path.join(folder, "strike.html")):
            found, compared = check_live(browser, folder)
            for complaint in found:
                print(f"  strike.html: {complaint}")
            failed += bool(found)
            print("live pages : " + ("the bits of the native program" if compared and not found else
                                     "not compared with the native program, which is not built" if not compared else "not in order"))
        for complaint in check_keys(browser, folder):
            print(f"  index.html: {complaint}")
            failed += 1
        names = sorted(n for n in os.listdir(folder) if n.endswith(".html"))
        for name in names:
            browser.open("file://" + os.path.join(folder, name))
            found = browser.evaluate(LOOK)
            if name in USE and (word := browser.evaluate(USE[name])):
                found.append(word)
            found += complaints(browser.events)
            failed += bool(found)
            for complaint in dict.fromkeys(found):
                print(f"  {name}: {complaint}")
    finally:
        browser.close()
    return len(names), failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder")
    parser.add_argument("--shot", help="page to draw, with #anchor")
    parser.add_argument("--width", type=int, default=1280)
    parser.add_argument("--height", type=int, default=900)
    parser.add_argument("--dark", action="store_true")
    parser.add_argument("--run", help="JavaScript to run before the drawing")
    parser.add_argument("--out", default="shot.png")
    given = parser.parse_args()
    folder, program = os.path.abspath(given.folder), find_browser()
    if not program:
        print("browser    : skipped, no Chromium on this machine")
        return 0
    if given.shot:
        browser = Browser(program)
        try:
            browser.size(given.width, given.height)
            browser.dark(given.dark)
            browser.open("file://" + os.path.join(folder, given.shot))
            if given.run:
                print(browser.evaluate(given.run))
            time.sleep(0.2)
            browser.shot(given.out)
        finally:
            browser.close()
        return 0
    count, failed = check_all(folder, program)
    print(f"browser    : {count - failed} of {count} pages in order")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
