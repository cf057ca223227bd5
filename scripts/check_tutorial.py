#!/usr/bin/env python3
"""Runs the commands of a tutorial and holds its figures against what they print.

    python scripts/check_tutorial.py [--program target/release/tresca] [docs/tutorial.md]

The commands of every block marked `sh` run in order, in a copy of the folder that is called like the page; those of a
block behind `<!-- not run -->` do not. A block marked `text` behind one is what the command prints, where a line `…`
stands for any lines and `…` in a line for any text. Words have to be equal; numbers may be off by `TOLERANCE`, and
those below `NOISE` in both are rounding. `<!-- quoted: 3281 = FILE.json a.0.b -->` says that the text above quotes a
value of a file, rounded to its last digit. Needs what the tutorial needs (scripts/requirements.txt).
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOLERANCE = 2e-2
NOISE = 1e-5

BLOCK = re.compile(r"(?P<skip><!-- not run -->\n)?```(?P<kind>sh|text|toml)\n(?P<body>.*?)^```$", re.S | re.M)
QUOTED = re.compile(r"<!-- quoted: (?P<text>\S+) = (?P<file>\S+) (?P<key>\S+) -->")
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def same(expected, found):
    """Whether a printed line is the one of the page, up to rounding and spaces."""
    pattern, numbers, at = "", [], 0
    for number in NUMBER.finditer(expected):
        pattern += re.escape(expected[at:number.start()]) + f"({NUMBER.pattern})"
        numbers.append(float(number.group()))
        at = number.end()
    pattern += re.escape(expected[at:])
    pattern = re.sub(r"(?:\\ )+", r"\\s+", pattern).replace("…", ".*")
    match = re.fullmatch(r"\s*" + pattern.removeprefix(r"\s+") + r"\s*", found)
    return match is not None and all(
        abs(float(text) - number) <= TOLERANCE * abs(number) or max(abs(float(text)), abs(number)) <= NOISE
        for text, number in zip(match.groups(), numbers)
    )


def missing(expected, printed):
    """The first line of the page that is not printed where it should be, or None."""
    lines, at, anywhere = printed.splitlines(), 0, False
    for line in expected.splitlines():
        if line.strip() in ("", "…"):
            anywhere = anywhere or line.strip() == "…"
            continue
        candidates = [k for k in range(at, len(lines)) if lines[k].strip()]
        if not anywhere:
            candidates = candidates[:1]
        at = next((k + 1 for k in candidates if same(line, lines[k])), None)
        if at is None:
            return line
        anywhere = False
    return None


def value(path, key):
    """What stands in a JSON file under keys and numbers joined by dots."""
    found = json.loads(path.read_text())
    for part in key.split("."):
        found = found[int(part)] if isinstance(found, list) else found[part]
    return found


def check(page, environment):
    """The faults of a page, each a line of text."""
    text = page.read_text(encoding="utf-8")
    folder = page.with_suffix("")
    with tempfile.TemporaryDirectory() as scratch:
        place = Path(scratch) / folder.name
        shutil.copytree(folder, place, ignore=shutil.ignore_patterns("out"))
        printed, ran = None, 0
        for block in BLOCK.finditer(text):
            body = block["body"]
            if block["skip"]:
                continue
            if block["kind"] == "sh":
                print(body, end="", flush=True)
                run = subprocess.run(["bash", "-euo", "pipefail", "-c", body], cwd=place, env=environment,
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                if run.returncode:
                    yield f"ended with exit code {run.returncode}:\n{body}{run.stdout}"
                    return
                printed, ran = run.stdout, ran + 1
            elif block["kind"] == "text" and printed is not None:
                if line := missing(body, printed):
                    yield f"not printed: {line}\namong\n{printed}"
                printed = None
            elif block["kind"] == "toml" and not any(body.strip() in file.read_text() for file in place.glob("*.toml")):
                yield f"in no case file of {folder.name}/:\n{body}"
        if not ran:
            yield "no command was found"
        for quote in QUOTED.finditer(text):
            number = quote["text"]
            last = 10.0 ** -len(number.partition(".")[2])
            found = value(place / quote["file"], quote["key"])
            if abs(found - float(number)) > last:
                yield f"{quote['key']} is {found}, not {number}"
            above = QUOTED.sub("", text[: quote.start()]).rstrip().rpartition("\n\n")[2]
            if number not in above.replace(" ", ""):
                yield f"{number} does not stand above {quote.group()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--program", type=Path, help="the program `tresca`; without it, that on PATH")
    parser.add_argument("page", nargs="?", type=Path, default=ROOT / "docs" / "tutorial.md")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as programs:
        # `python` and `gmsh` are those of the environment that this script runs in.
        paths = [programs, str(Path(sys.executable).parent), os.environ["PATH"]]
        if arguments.program:
            (Path(programs) / "tresca").symlink_to(arguments.program.resolve(strict=True))
        faults = list(check(arguments.page, {**os.environ, "PATH": os.pathsep.join(paths)}))
    for fault in faults:
        print(f"{arguments.page}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
