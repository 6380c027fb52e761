"""Opens every page of the book in a headless Chromium, as wide as a phone: `python3 book/browse.py build/book`.

A page fails if it logs an error, asks for what is not in its folder, or must be scrolled sideways. A number shows
its error on focus, the search finds a chapter, and each live page that is there is run. Links and pictures that lead nowhere end the making of the book (literate.py)."""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    sys.exit("browser    : python3-selenium is not installed (apt-packages.txt, [browse])")

FLAGS = ("headless=new no-sandbox disable-gpu hide-scrollbars no-first-run disable-extensions disable-sync "
         "disable-component-update disable-background-networking").split()
HERE = ("file:", "data:", "blob:", "about:", "chrome:")
LOOK = r"""
const out = [], wide = document.documentElement.scrollWidth;
if (wide > innerWidth) {
  const out_of_it = [...document.querySelectorAll("article *")].filter((e) => e.getBoundingClientRect().right > innerWidth + 1
    && !e.closest("pre, .formula, .table-wrapper"));
  out.push(`scrolls sideways: ${wide} > ${innerWidth} ${out_of_it.slice(0, 3).map((e) => e.outerHTML.slice(0, 80))}`);
}
return out;"""


class Browser:
    """One window of one Chromium, with a profile of its own."""

    def __init__(self, folder):
        self.folder, self.profile = Path(folder).resolve(), tempfile.mkdtemp()
        options = webdriver.ChromeOptions()
        options.binary_location = os.environ.get("CHROMIUM") or shutil.which("chromium") or ""
        for flag in [*FLAGS, f"user-data-dir={self.profile}"]:
            options.add_argument("--" + flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
        self.run = self.driver.execute_script
        size = {"width": 375, "height": 800, "deviceScaleFactor": 1, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)

    def open(self, page):
        self.driver.get(f"{self.folder.as_uri()}/{page}")

    def complaints(self):
        """What the browser has to say since it was last asked, and what was asked for beyond the folder."""
        out = [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]
        for entry in self.driver.get_log("performance"):
            event = json.loads(entry["message"])["message"]
            address = event["params"].get("request", {}).get("url", "file:")
            if event["method"] == "Network.requestWillBeSent" and not address.startswith(HERE):
                out.append("asks for " + address)
        return out

    def wait(self, code, seconds=10):
        """Whether an expression becomes true."""
        try:
            return bool(WebDriverWait(self.driver, seconds, 0.05).until(lambda driver: self.run("return " + code)))
        except WebDriverException:
            return False


def check_use(browser):
    """A number by its focus, the search."""
    browser.open("index.html")
    browser.run("document.querySelector('a.num').focus({focusVisible: true})")
    if "±" not in browser.run("return getComputedStyle(document.activeElement, '::after').content"):
        yield "index.html: a number does not show its error on focus"
    browser.open("search.html?q=boomeron")
    if not browser.wait("document.querySelector('#search-results a[href*=sec34_boomeron]')"):
        yield "search.html: does not find the boomeron"


def check_live(browser, pages):
    """Each live page that is there computes to its end."""
    for name in (name for name in ("strike", "breather", "defect", "drive") if f"{name}.html" in pages):
        browser.open(f"{name}.html")
        panel = f"document.getElementById('live-{name}')"
        browser.wait(f"/done|failed/.test({panel}.dataset.state)", 180)
        if browser.run(f"return {panel}.dataset.state") != "done":
            yield f"{name}.html: " + browser.run(f"return {panel}.querySelector('[role=status]').textContent")
        elif name == "strike":
            yield from (f"{name}.html: {what}" for what in unlike_the_program(browser, panel))


def unlike_the_program(browser, panel):
    """Numbers of a page, or their errors, that are not those of the command that it shows."""
    command = browser.run(f"return {panel}.querySelector('code, pre').textContent").split()
    if not Path(command[0]).exists():
        return
    run = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    there = {row["quantity"]: row for row in csv.DictReader(line for line in run if not line.startswith("#"))}
    here = browser.run(f"return [...{panel}.querySelectorAll('[data-quantity]')].map(row => ({{...row.dataset}}))")
    for row in here:
        for word in ("value", "error"):
            if float(row[word]) != float(there[row["quantity"]][word]):
                yield f"{row['quantity']} has the {word} {row[word]}, and in the program {there[row['quantity']][word]}"
    if len(here) < 5:
        yield f"{len(here)} numbers"


def main(folder):
    browser = Browser(folder)
    pages, out = sorted(path.name for path in Path(folder).glob("*.html")), []
    try:
        for page in pages:
            browser.open(page)
            out += [f"{page}: {complaint}" for complaint in dict.fromkeys(browser.run(LOOK) + browser.complaints())]
        out += [*check_use(browser), *check_live(browser, pages)]
    finally:
        browser.driver.quit()
        shutil.rmtree(browser.profile, ignore_errors=True)
    print(*(f"  {complaint}" for complaint in out), sep="\n")
    print(f"browser    : {len(pages)} pages, {len(out)} complaints")
    return bool(out)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
