"""Writes the npm package as one script, for pages that are opened as files: from there, browsers load neither modules nor WebAssembly.

Usage: script.py PACKAGE MODULE OUTPUT

PACKAGE is the folder js/ and MODULE its module pw85.wasm. The script defines PW85, the promise of load() of the package.
"""

import base64
import sys
from pathlib import Path

TABLE = "./questions.js"


def data_url(kind, contents):
    return f"data:{kind};base64,{base64.b64encode(contents).decode()}"


def main():
    package, module, output = map(Path, sys.argv[1:])
    code = (package / "pw85.js").read_text(encoding="utf-8")
    assert code.count(f'"{TABLE}"') == 1
    code = code.replace(TABLE, data_url("text/javascript", (package / TABLE).read_bytes()))
    bytes_of_module = base64.b64encode(module.read_bytes()).decode()
    output.write_text(
        f'const PW85 = import("{data_url("text/javascript", code.encode())}").then(({{ load }}) =>\n'
        f'    load({{ wasm: Uint8Array.from(atob("{bytes_of_module}"), c => c.charCodeAt(0)) }}));\n',
        encoding="utf-8",
    )


main()
