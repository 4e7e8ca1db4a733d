"""Writes all measured tables anew. Usage: measure.py EVALUATIONS REFERENCE_DATA, with pypw85 on the path.

Have the machine to yourself for throughput.csv; the other tables do not depend on it.
"""

import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main():
    evaluations, reference_data = sys.argv[1:]
    tables = {
        "evaluations": [evaluations],
        "accuracy": [sys.executable, HERE / "accuracy.py", reference_data],
        "digits": [sys.executable, HERE / "digits.py", reference_data],
        "throughput": [sys.executable, HERE / "throughput.py"],
    }
    for name, command in tables.items():
        table = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
        (HERE / f"{name}.csv").write_bytes(table)
        print(f"{name}.csv", flush=True)


main()
