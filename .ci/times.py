# SPDX-License-Identifier: BSD-3-Clause
"""Processor seconds of each compiled unit and of each test of README's test command, compared with those on record (times.json).

Machines differ, so the times of a run are divided by the median of their ratios to the record. `.ci/run --record PART...` puts
its times on record, without anything in the cache. README's commands run alone then, and all else several parts at a time, as always."""

import datetime
import json
import platform
import re
import statistics
from pathlib import Path

RECORD = Path(__file__).resolve().parent / "times.json"
GROWTH, SECONDS = 4 / 3, 5.0  # what grew by more than both is named
LEAST = 2.0  # shorter times say nothing about the speed of a machine


def read(times, tests):
    """The seconds of units and of tests in a file of processor_time.py, by name. `tests` is what Meson says of the tests."""
    units, programs = {}, {}
    for line in Path(times).read_text(encoding="utf-8").splitlines():
        done = json.loads(line)
        command = done["command"]
        if "-c" in command and "-o" in command:
            name = without_version(command[command.index("-o") + 1])
            units[name] = units.get(name, 0.0) + done["seconds"]
        else:
            for test in tests:
                if is_of(done, test):
                    programs[test["name"]] = round(programs.get(test["name"], 0.0) + done["seconds"], 2)
                    break
    return {"units": units, "tests": programs}


def without_version(name):
    """The name of a unit of a library. That of Meson's has the version of the library, with which no record would outlive a release."""
    return re.sub(r"\.so(\.\d+)+", ".so", name)


def is_of(done, test):
    """Whether a command is that of a test. Tests of one command differ in their environments."""
    if done["command"][-len(test["cmd"]):] != test["cmd"]:
        return False
    return all(test["env"].get(name) == value for name, value in done["environment"].items() if name in test["env"]) and all(
        name in done["environment"] for name in ("PW85_TARGET", "PW85_FAKE_DRIVER", "QEMU_CPU") if name in test["env"]
    )


def grown(now, before):
    """Sentences about what takes longer than on record, or is long and not on record."""
    common = [(kind, name) for kind in now for name in before[kind] if name in now[kind]]
    ratios = [now[kind][name] / before[kind][name] for kind, name in common if before[kind][name] >= LEAST]
    speed = statistics.median(ratios) if ratios else 1.0
    for kind in now:
        for name, seconds in sorted(now[kind].items(), key=lambda item: -item[1]):
            scaled, recorded = seconds / speed, before[kind].get(name, 0.0)
            if scaled > GROWTH * recorded and scaled > recorded + SECONDS:
                yield f"{name}: {scaled:.0f} s of a processor, {recorded:.0f} on record"


def load():
    record = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else {"units": {}, "tests": {}, "parts": {}}
    return {**record, "units": {without_version(name): seconds for name, seconds in record["units"].items()}}


def processor_name():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.processor()


def store(now, parts):
    """Writes what a run measured into the record. `parts` has the minutes and the processor minutes of each part."""
    record = load()
    record["machine"] = f"{processor_name()}, {datetime.date.today()}"
    record["parts"] = {**record.get("parts", {}), **parts}
    record.update(now)
    RECORD.write_text(json.dumps(record, indent=1, sort_keys=True) + "\n", encoding="utf-8")
