# SPDX-License-Identifier: BSD-3-Clause
"""Plugin of pytest: results in the Test Anything Protocol, so that Meson counts each test."""

import pytest


class TapReport:
    def __init__(self):
        self.number = 0

    def pytest_collection_finish(self, session):
        print(f"1..{len(session.items)}", flush=True)

    def pytest_collectreport(self, report):
        if report.failed:
            self._comment(report.longreprtext)
            print(f"Bail out! {report.nodeid} cannot be collected", flush=True)

    def pytest_runtest_logreport(self, report):
        if (report.when != "call" and report.passed) or (report.when == "teardown" and report.skipped):
            return
        self.number += 1
        if report.skipped:
            print(f"ok {self.number} - {report.nodeid} # SKIP {report.longrepr[2]}", flush=True)
            return
        print(f"{'ok' if report.passed else 'not ok'} {self.number} - {report.nodeid}", flush=True)
        if report.failed:
            self._comment(report.longreprtext)

    @staticmethod
    def _comment(text):
        for line in text.splitlines():
            print("#", line, flush=True)


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    config.option.verbose = 0  # comparisons ask for it, and it belongs to the terminal
    config.pluginmanager.register(TapReport(), "tap_report_results")
