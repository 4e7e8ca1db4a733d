# SPDX-License-Identifier: BSD-3-Clause
"""Opens page.html in headless Chromium. Usage: browser.py FOLDER, with tests/, node_modules/pw85 and pairs.txt in it."""

import functools
import http.server
import sys
import threading

from selenium import webdriver
from selenium.webdriver.support.ui import WebDriverWait

EXPECTED = "1000 pairs, 0 differ; Pw85Error: r12, entry 0: must be finite"
OPTIONS = "--headless=new --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-component-update".split()
FOREIGN = """return performance.getEntriesByType("resource").map(e => e.name).filter(n => !n.startsWith(location.origin))"""


class Handler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def main():
    options = webdriver.ChromeOptions()
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    for option in OPTIONS:
        options.add_argument(option)
    handler = functools.partial(Handler, directory=sys.argv[1])
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        driver = webdriver.Chrome(options=options)
        try:
            driver.get(f"http://127.0.0.1:{server.server_port}/tests/page.html")
            WebDriverWait(driver, 60).until(lambda page: page.title != "pw85")
            title, log, foreign = driver.title, driver.get_log("browser"), driver.execute_script(FOREIGN)
        finally:
            driver.quit()
            server.shutdown()
    print(title)
    if title != EXPECTED or log or foreign:
        sys.exit(f"expected {EXPECTED!r}; console: {log}; other hosts: {foreign}")


main()
