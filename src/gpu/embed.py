#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the program for the device into a C++ source, as an array. Usage: embed.py PROGRAM SOURCE

The build calls it. It leaves out comments and empty lines.
"""

import sys
from pathlib import Path

lines = (line.split("//")[0].strip() for line in Path(sys.argv[1]).read_text(encoding="utf-8").splitlines())
code = "".join(line + "\n" for line in lines if line).encode() + b"\0"
rows = [code[i : i + 32] for i in range(0, len(code), 32)]
text = ",\n".join(", ".join(map(str, row)) for row in rows)
Path(sys.argv[2]).write_text(
    f'#include "device_code.hpp"\n\nchar const pw85::detail::gpu::device_code[] = {{\n{text}}};\n',
    encoding="utf-8",
)
