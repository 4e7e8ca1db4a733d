"""Opens built pages in headless Chromium, on a desktop, light and dark, and on a phone.

What a page must not do: report anything on the console, fail to load something, scroll sideways as a whole, leave a formula
as source, or ask another host for anything. With PW85_SCREENSHOTS in the environment, screenshots of the first screen of each page are
kept for a person to look at.
"""

import contextlib
import functools
import http.server
import os
import re
import shutil
import tempfile
import threading
import urllib.parse

from selenium import webdriver
from selenium.common.exceptions import TimeoutException
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

SIZES = {"desktop": (1280, 900), "phone": (390, 844)}
# Colours do not depend on the size.
SCHEMES = {"desktop": ("light", "dark"), "phone": ("light",)}
OPTIONS = (
    "--headless=new --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    "--disable-component-update --disable-sync --hide-scrollbars --force-device-scale-factor=1"
).split()
WITH_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
WITHOUT_WEBGL = ["--disable-3d-apis"]
# The outermost of what is wider than the window, where the page is.
WIDE = """
const width = document.documentElement.clientWidth;
if (document.documentElement.scrollWidth <= width && document.body.scrollWidth <= width) return [];
const isWide = e => e.getBoundingClientRect().right > width + 1;
const wide = [...document.querySelectorAll("body *")].filter(e => isWide(e) && !isWide(e.parentElement));
return wide.map(e => e.tagName + "." + e.className + " " + e.textContent.trim().slice(0, 40));
"""
RAW = """return [...document.querySelectorAll(".math")].filter(e => !e.querySelector(".katex")).map(e => e.textContent)"""
# What the software that draws for Chromium says when a picture is taken.
SCREENSHOT_OF_WEBGL = "GPU stall due to ReadPixels"
# How many pixels of the scene are rather blue, and rather orange.
SEEN = """
const canvas = document.querySelector("#pair-view canvas"), copy = document.createElement("canvas");
const width = copy.width = canvas.width, height = copy.height = canvas.height, context = copy.getContext("2d");
context.drawImage(canvas, 0, 0);
const data = context.getImageData(0, 0, width, height).data;
let blue = 0, orange = 0;
for (let i = 0; i < data.length; i += 4) {
    if (data[i + 2] > data[i] + 50) ++blue;
    if (data[i] > data[i + 2] + 50) ++orange;
}
return [blue, orange];
"""
# Formulas that are wider than what shows them.
CUT_OFF = """
const formulas = [...document.querySelectorAll(".katex-display")].filter(e => e.scrollWidth > e.clientWidth + 1);
return formulas.map(e => e.querySelector("annotation").textContent.trim().slice(0, 60));
"""
FOREIGN = """return performance.getEntriesByType("resource").map(e => e.name).filter(n => !n.startsWith(location.origin))"""


# Searches by the address of their page, as a reader's: words with a space, one with a place in a page, and one that has no chapter.
BY_ADDRESS = ("closest approach", "quaternion", "Julia")
# What searches find first. They show it at once, the rest and the summaries, for which they ask for pages, later.
FIRST_RESULTS = """
window.fetch = () => new Promise(() => {});
const shown = document.getElementById("search-results");
return arguments[0].map(query => {
    Scorer.asked = () => query.toLowerCase();
    shown.replaceChildren();
    Search.performSearch(query);
    const link = shown.querySelector("li a");
    return link && link.getAttribute("href");
});
"""


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
def browser(more_options):
    options = webdriver.ChromeOptions()
    with tempfile.TemporaryDirectory(prefix="pw85-chromium-") as profile:
        for option in [*OPTIONS, *more_options, f"--user-data-dir={profile}"]:
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        # Without a path, newer Selenium looks for a driver on the network.
        service = webdriver.chrome.service.Service(shutil.which("chromedriver"))
        driver = webdriver.Chrome(options=options, service=service)
        try:
            yield driver
        finally:
            driver.quit()


def resize(driver, size):
    width, height = SIZES[size]
    metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": size == "phone"}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": size == "phone"})


def colour_of_text(driver, scheme):
    """The colour of the text for readers who prefer a scheme of colours."""
    features = [{"name": "prefers-color-scheme", "value": scheme}]
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
    return driver.execute_script("return getComputedStyle(document.querySelector('h1')).color")


def cut_off(driver):
    """Formulas that stay cut off once fonts are there, and the page has made formulas fit."""
    with contextlib.suppress(TimeoutException):
        WebDriverWait(driver, 5).until(lambda d: not d.execute_script(CUT_OFF))
    return driver.execute_script(CUT_OFF)


def complaints_of_page(driver):
    messages = [entry["message"] for entry in driver.get_log("browser")]
    yield from (message for message in messages if SCREENSHOT_OF_WEBGL not in message)
    yield from (f"wider than the window: {element}" for element in driver.execute_script(WIDE))
    yield from (f"not typeset: {formula}" for formula in driver.execute_script(RAW))
    yield from (f"cut off: {formula}" for formula in cut_off(driver))
    yield from (f"asks for {address}" for address in driver.execute_script(FOREIGN))
    if driver.execute_script("return document.documentElement.classList.contains('no-js')"):
        yield "the script of the theme does not run"


def check_page(driver, address, schemes, screenshots):
    """What is wrong with a page; pictures of its first screen begin with a name."""
    driver.get(address)
    yield from complaints_of_page(driver)
    colours = set()
    for scheme in schemes:
        colours.add(colour_of_text(driver, scheme))
        if "PW85_SCREENSHOTS" in os.environ:
            driver.save_screenshot(f"{screenshots}-{scheme}.png")
    if len(colours) < len(schemes):
        yield "the dark page is not dark"


def without_place(first, expected):
    return first if "#" in expected else first.partition("#")[0]


def check_searches(driver, address, searches):
    """Whether searches find first what they must: the end of an address for each query, with a place in the page or without."""
    for query, expected in searches.items():
        driver.get(f"{address}/search.html?q={urllib.parse.quote(query)}")
        results = WebDriverWait(driver, 10).until(lambda d: d.find_elements("css selector", "#search-results li a"))
        first = re.sub(r"[?][^#]*", "", results[0].get_attribute("href").removeprefix(f"{address}/"))
        if not without_place(first, expected).endswith(expected):
            yield f"a search for {query} finds first {first} instead of {expected}"


def check_names(driver, address, names):
    """The same for many names, in one page, which reads the index of the search once."""
    driver.get(f"{address}/search.html?q=pw85")
    WebDriverWait(driver, 10).until(lambda d: d.find_elements("css selector", "#search-results li a"))
    for (name, expected), first in zip(names.items(), driver.execute_script(FIRST_RESULTS, list(names)), strict=True):
        if not without_place(first or "nothing", expected).endswith(expected):
            yield f"a search for {name} finds first {first} instead of {expected}"


def check_one_row(driver, address):
    """Whether a function of several languages has one row, with links to each of them."""
    driver.get(f"{address}/search.html?q=contact_gradient")
    WebDriverWait(driver, 10).until(lambda d: "finished" in d.find_element("id", "search-results").text.lower())
    rows = driver.find_elements("css selector", "#search-results li")
    names = [row.find_element("tag name", "a").text.lower() for row in rows]
    same = [row for row, name in zip(rows, names) if re.sub("^(pw85_|pypw85[.]|pw85::)", "", name) == "contact_gradient"]
    places = [link.get_attribute("href") for row in same for link in row.find_elements("tag name", "a")]
    pages = sorted(urllib.parse.urlparse(place).path for place in places)
    if len(same) != 1 or pages != [f"/api/{language}.html" for language in ("c_pair", "cpp", "fortran_pair", "python")]:
        yield f"contact_gradient has {len(same)} rows, with links to {pages}"
    for place in places:
        driver.get(place)
        anchor = urllib.parse.unquote(place.partition("#")[2])
        if not driver.execute_script("return !!document.getElementById(arguments[0])", anchor):
            yield f"a search leads to {place}, which is not there"


def shown(driver):
    """The numbers of the page with two ellipsoids, once it shows any."""
    WebDriverWait(driver, 10).until(lambda d: d.find_element("id", "pair-mu2").text)
    return [driver.find_element("id", f"pair-{name}").text for name in ("mu2", "lambda", "distance")]


def check_states(driver, address, states):
    """Whether the page with two ellipsoids shows the numbers of states, pairs of a fragment of its address and these."""
    driver.get("about:blank")
    for fragment, expected in states:
        driver.get(f"{address}/interactive.html#{fragment}")
        if shown(driver) != expected:
            yield f"interactive.html#{fragment} shows {shown(driver)} instead of {expected}"


def check_scene(driver):
    """Whether both ellipsoids are seen: of two spheres that are apart, one has four times the area of the other."""
    driver.execute_script("location.hash = '2,2,2;1,0,0,0;1,1,1;1,0,0,0;5,0,0'")
    blue, orange = driver.execute_script(SEEN)
    if not (orange > 500 and 2 * orange < blue < 8 * orange):
        yield f"interactive.html: {blue} blue and {orange} orange pixels"


def check_keys(driver, view):
    for name, actions in {
        "an arrow": ActionChains(driver).move_to_element(view).click().send_keys(Keys.ARROW_RIGHT),
        "a turn": ActionChains(driver).key_down(Keys.SHIFT).send_keys(Keys.ARROW_UP).key_up(Keys.SHIFT),
        "Page Up": ActionChains(driver).send_keys("1", Keys.PAGE_UP),
    }.items():
        before = shown(driver)
        actions.perform()
        if shown(driver) == before:
            yield f"interactive.html: {name} changes nothing"


def check_said(driver):
    """Whether a screen reader is told of a change, in a region that is live."""
    driver.execute_script("location.hash = '1,1,1;1,0,0,0;1,1,1;1,0,0,0;4,0,0'")
    region = driver.find_element("id", "pair-said")
    sentence = "they are apart: mu squared is 4.000, the distance is 2.000"
    try:
        WebDriverWait(driver, 5).until(lambda d: region.get_attribute("textContent") == sentence)
    except TimeoutException:
        yield f"interactive.html: a screen reader is told {region.get_attribute('textContent')!r}"
    if region.get_attribute("aria-live") != "polite":
        yield "interactive.html: the region for screen readers is not live"


def check_touch(driver, view):
    """Whether a finger moves an ellipsoid that is in the middle, and the page stays where it is."""
    driver.execute_script("location.hash = '1,1,1;1,0,0,0;1,1,1;1,0,0,0;0,0,0.5'")
    driver.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", view)
    box = driver.execute_script("return arguments[0].getBoundingClientRect().toJSON()", view)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    before, scrolled = shown(driver), driver.execute_script("return scrollY")
    for kind, shift in (("touchStart", 0), ("touchMove", 15), ("touchMove", 30), ("touchEnd", None)):
        points = [] if shift is None else [{"x": x + shift, "y": y + shift}]
        driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
    if shown(driver) == before or driver.execute_script("return scrollY") != scrolled:
        yield "interactive.html: a finger moves the page, or nothing"


def check_interactive(driver, address, states, screenshots):
    resize(driver, "desktop")
    yield from check_states(driver, address, states)
    view = driver.find_element("id", "pair-view")
    view.screenshot(str(screenshots / "interactive-view.png"))
    yield from check_keys(driver, view)
    yield from check_said(driver)
    yield from check_scene(driver)
    resize(driver, "phone")
    yield from check_touch(driver, view)
    yield from complaints_of_page(driver)


def check_without_webgl(driver, address, states):
    """Whether the interactive page says that there is no picture, and continues."""
    yield from check_states(driver, address, states)
    if not driver.find_element("id", "pair-flat").is_displayed():
        yield "interactive.html: without WebGL, nothing is said"
    yield from check_keys(driver, driver.find_element("id", "pair-view"))
    yield from complaints_of_page(driver)


def check(folder, pages, searches, names, states, screenshots):
    """What is wrong with the pages, names of files below a folder, which searches and which names do not find first what they must,
    and what is wrong with the interactive page, which must show certain numbers of certain states."""
    screenshots.mkdir(exist_ok=True)
    with served(folder) as address, browser(WITHOUT_WEBGL) as driver:
        yield from check_without_webgl(driver, address, states[:1])
    with served(folder) as address, browser(WITH_WEBGL) as driver:
        for size in SIZES:
            resize(driver, size)
            for page in pages:
                name = page.replace("/", "-").replace(".html", "")
                found = check_page(driver, f"{address}/{page}", SCHEMES[size], screenshots / f"{name}-{size}")
                yield from (f"{page}, {size}: {complaint}" for complaint in found)
        yield from check_interactive(driver, address, states, screenshots)
        yield from check_searches(driver, address, {query: searches[query] for query in BY_ADDRESS})
        yield from check_names(driver, address, {**searches, **names})
        yield from check_one_row(driver, address)
