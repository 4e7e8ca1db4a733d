"""Opens built pages in headless Chromium, on a desktop and on a phone, light and dark.

What a page must not do: report anything on the console, fail to load something, scroll sideways as a whole, leave a formula
as source, or ask another host for anything. Screenshots of the first screen of each page are kept for a person to look at.
"""

import contextlib
import functools
import http.server
import tempfile
import threading

from selenium import webdriver
from selenium.common.exceptions import TimeoutException
from selenium.webdriver.support.ui import WebDriverWait

SIZES = {"desktop": (1280, 900), "phone": (390, 844)}
OPTIONS = (
    "--headless=new --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    "--disable-component-update --disable-sync --hide-scrollbars --force-device-scale-factor=1"
).split()
# The outermost of what is wider than the window, where the page is.
WIDE = """
const width = document.documentElement.clientWidth;
if (document.documentElement.scrollWidth <= width && document.body.scrollWidth <= width) return [];
const isWide = e => e.getBoundingClientRect().right > width + 1;
const wide = [...document.querySelectorAll("body *")].filter(e => isWide(e) && !isWide(e.parentElement));
return wide.map(e => e.tagName + "." + e.className + " " + e.textContent.trim().slice(0, 40));
"""
RAW = """return [...document.querySelectorAll(".math")].filter(e => !e.querySelector(".katex")).map(e => e.textContent)"""
FOREIGN = """return performance.getEntriesByType("resource").map(e => e.name).filter(n => !n.startsWith(location.origin))"""


class Server(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *arguments):
        pass


@contextlib.contextmanager
def served(folder):
    """The address of a server of the folder."""
    handler = functools.partial(Server, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@contextlib.contextmanager
def browser():
    options = webdriver.ChromeOptions()
    with tempfile.TemporaryDirectory(prefix="pw85-chromium-") as profile:
        for option in [*OPTIONS, f"--user-data-dir={profile}"]:
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        driver = webdriver.Chrome(options=options)
        try:
            yield driver
        finally:
            driver.quit()


def resize(driver, size):
    width, height = SIZES[size]
    metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": size == "phone"}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)


def colour_of_text(driver, scheme):
    """The colour of the text for readers who prefer a scheme of colours."""
    features = [{"name": "prefers-color-scheme", "value": scheme}]
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
    return driver.execute_script("return getComputedStyle(document.querySelector('h1')).color")


def complaints_of_page(driver):
    yield from (entry["message"] for entry in driver.get_log("browser"))
    yield from (f"wider than the window: {element}" for element in driver.execute_script(WIDE))
    yield from (f"not typeset: {formula}" for formula in driver.execute_script(RAW))
    yield from (f"asks for {address}" for address in driver.execute_script(FOREIGN))
    if driver.execute_script("return document.documentElement.classList.contains('no-js')"):
        yield "the script of the theme does not run"


def check_page(driver, address, screenshots):
    """What is wrong with a page; pictures of its first screen begin with a name."""
    driver.get(address)
    yield from complaints_of_page(driver)
    colours = set()
    for scheme in ("light", "dark"):
        colours.add(colour_of_text(driver, scheme))
        driver.save_screenshot(f"{screenshots}-{scheme}.png")
    if len(colours) == 1:
        yield "the dark page is not dark"


def check_search(driver, address, words):
    driver.get(f"{address}/search.html?q={words.replace(' ', '+')}")
    try:
        WebDriverWait(driver, 10).until(lambda d: d.find_elements("css selector", "#search-results li a"))
    except TimeoutException:
        yield f"a search for {words} finds nothing"


def check(folder, pages, searches, screenshots):
    """What is wrong with the pages, names of files below a folder, and which searches find nothing."""
    screenshots.mkdir(exist_ok=True)
    with served(folder) as address, browser() as driver:
        for size in SIZES:
            resize(driver, size)
            for page in pages:
                name = page.replace("/", "-").replace(".html", "")
                found = check_page(driver, f"{address}/{page}", screenshots / f"{name}-{size}")
                yield from (f"{page}, {size}: {complaint}" for complaint in found)
        for words in searches:
            yield from check_search(driver, address, words)
