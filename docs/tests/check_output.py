"""Whether a Python program prints what a file holds. Usage: check_output.py EXPECTED PROGRAM"""

import subprocess
import sys
from pathlib import Path

expected = Path(sys.argv[1]).read_text(encoding="utf-8")
actual = subprocess.run([sys.executable, sys.argv[2]], check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
if actual != expected:
    sys.exit(f"{sys.argv[2]} printed\n{actual}instead of\n{expected}")
