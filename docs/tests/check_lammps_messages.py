"""Whether a test of the styles for LAMMPS expects each of their messages, by the sources alone.

A message is expected if four of its words in a row are in a test. lammps/tests/untested_messages.txt has those that no test expects
yet; a new message needs a test, and a message with a test must not be in the list.
Usage: check_lammps_messages.py SOURCE [--list], which prints what the list must be.
"""

import re
import sys
from pathlib import Path

STOPS = re.compile(r"\b(?:stop_all|stop_one|refuse\w*)\(")
STRING = re.compile(r'"((?:\\.|[^"\\])*)"')
WRONG_FORM = re.compile(r"\.$|!|\n|\bshould (be|have)\b|(?<!there )\bis no (?!longer)[a-z]")


def arguments(text, start):
    """The text up to the parenthesis that closes a call, from behind the one that opens it."""
    depth = 1
    for token in re.finditer(r'"(?:\\.|[^"\\])*"|[()]', text[start:]):
        depth += {"(": 1, ")": -1}.get(token[0], 0)
        if not depth:
            return text[start : start + token.start()]
    return ""


def messages(source):
    """(file, line, message) of each message, without the values that it prints."""
    for path in sorted((source / "lammps").glob("*.[ch]pp")):
        text = path.read_text(encoding="utf-8")
        for call in STOPS.finditer(text):
            message = "".join(STRING.findall(arguments(text, call.end()))).strip()
            if message:
                yield path.name, text.count("\n", 0, call.start()) + 1, message


def is_expected(message, tests):
    words = message.split()
    return any(" ".join(words[k : k + 4]) in tests for k in range(max(1, len(words) - 3)))


def main():
    source = Path(sys.argv[1])
    listed = source / "lammps/tests/untested_messages.txt"
    tests = "".join(path.read_text(encoding="utf-8") for path in sorted((source / "lammps/tests").glob("*.py")))
    tests = re.sub(r'"\s*\n\s*[rf]?"', "", tests).replace("\\", "")
    found = list(messages(source))
    missing = {f"{file}: {message}": f"{file}:{line}" for file, line, message in found if not is_expected(message, tests)}
    if sys.argv[2:] == ["--list"]:
        print("\n".join(sorted(missing)))
        return 0
    known = {line for line in listed.read_text(encoding="utf-8").splitlines() if not line.startswith("#")}
    wrong = [f"{missing[one]}: no test expects the message “{one.partition(': ')[2]}”" for one in sorted(set(missing) - known)]
    wrong += [f"{listed}: remove “{one}”, which has a test or is gone" for one in sorted(known - set(missing))]
    bad = [(file, line, message) for file, line, message in found if WRONG_FORM.search(message)]
    wrong += [f"lammps/{file}:{line}: “{message}” does not have the form of a message" for file, line, message in bad]
    wrong += [] if len(found) > 100 else [f"only {len(found)} messages were found: the check does not know the calls"]
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
