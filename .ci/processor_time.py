#!/usr/bin/python3 -IS
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command and appends the processor seconds that it took, with its children, to the file PW85_PROCESSOR_TIMES: a JSON object
per line. It stands before the compiler (CCACHE_PREFIX) and before the programs of tests (`meson test --wrap`)."""

import json
import os
import resource
import subprocess
import sys

KEPT = ("PW85_TARGET", "PW85_REPRODUCIBLE", "PW85_FAKE_DRIVER", "PW85_FAILS", "OMP_NUM_THREADS", "QEMU_CPU")
done = subprocess.run(sys.argv[1:], close_fds=False)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
times = os.environ.get("PW85_PROCESSOR_TIMES")
if times:
    record = {"seconds": round(used.ru_utime + used.ru_stime, 2), "command": sys.argv[1:],
              "environment": {name: os.environ[name] for name in KEPT if name in os.environ}}
    with open(times, "a", encoding="utf-8") as file:
        file.write(json.dumps(record) + "\n")
# A signal ends this program as it ended the command.
if done.returncode < 0:
    os.kill(os.getpid(), -done.returncode)
sys.exit(done.returncode)
