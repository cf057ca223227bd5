#!/usr/bin/env python3
"""Brings the documents to one width: paragraphs and list items are filled to 100 columns.

    python scripts/docs_width.py [--check] [FILE.md …]      # without files: every tracked *.md

Tables, code, front matter, headings, HTML, images and link definitions stay as they are; a link or a code span is
never broken, even where it is longer than a line. With `--check` nothing is written: the files that are not filled
are named with their first line that differs, and the exit code is 1. Needs nothing beyond Python.
"""

import argparse
import re
import subprocess
import sys
import unicodedata
from pathlib import Path

WIDTH = 100

FENCE = re.compile(r"\s*(`{3,}|~{3,}|\$\$)")
ITEM = re.compile(r"(\s*)([-*+]|\d+[.)])( +)(?=\S)")
# Lines that are blocks of their own: headings, rows of tables, rules, images alone, link definitions.
ALONE = re.compile(r"\s*(#{1,6}\s|\||(?:[-*_]\s*){3,}$|!\[[^\]]*\]\([^)]*\)\s*$|\[[^\]]+\]:\s)")
HTML = re.compile(r"\s*<(?!https?:)[A-Za-z/!]")
# A word that would begin another block if it came first in a line.
MARKER = re.compile(r"(?:[-+*>|=]|#{1,6}|\d{1,9}[.)])$|>|\||[-=]{2,}|```|~~~")
# A unit stays with its number.
UNIT = re.compile(r"(?:%|[kMG]?(?:N|Pa|FLOP|iB)|[mµ]?(?:m|s)|degrees)[²³]?[.,;:)]*$")
# What a line may not be broken in: images and links, code spans. Text in brackets nests once.
BRACKETS = r"\[(?:[^\[\]]|\[[^\]]*\])*\]"
WHOLE = re.compile(rf"(`+)(?!`).*?(?<!`)\1(?!`)|!?{BRACKETS}(?:\([^()\s]*(?:\s+\"[^\"]*\")?\)|\[[^\]]*\])")


def columns(text):
    """Columns that a text takes: a combining mark (r̃) takes none."""
    return sum(not unicodedata.combining(char) for char in text)


def words(text):
    """What a line may be broken between: the words of a paragraph, with links and code spans as parts of one word."""
    found, word, at = [], "", 0
    while at < len(text):
        if whole := WHOLE.match(text, at):
            word += whole.group()
            at = whole.end()
        elif text[at] == " ":
            found.append(word)
            word, at = "", at + 1
        else:
            word += text[at]
            at += 1
    # A marker in the middle of a sentence ("a - b") goes with the word before it, lest it begin a line; so does
    # a unit with its number.
    kept = []
    for word in filter(None, [*found, word]):
        if kept and (MARKER.match(word) or (kept[-1][-1].isdigit() and UNIT.match(word))):
            kept[-1] += f" {word}"
        else:
            kept.append(word)
    return kept


def fill(lines, first, rest):
    """The lines of a paragraph, filled; `first` and `rest` stand in front of its first and its other lines."""
    filled, line, indent, empty = [], "", first, True
    for word in words(" ".join(line.strip() for line in lines)):
        if empty:
            line, empty = word, False
        elif columns(indent + line) + 1 + columns(word) <= WIDTH:
            line += " " + word
        else:
            filled.append(indent + line)
            line, indent = word, rest
    filled.append(indent + line)
    return filled


def paragraphs(lines):
    """A paragraph cut behind its hard breaks: two spaces or a backslash at the end of a line."""
    part = []
    for line in lines:
        part.append(line)
        if line.endswith("  ") or line.endswith("\\"):
            yield part, line[len(line.rstrip(" \\")):]
            part = []
    if part:
        yield part, ""


def verbatim(lines, at, inside):
    """Where a block that begins at line `at` and stays as it is ends; `at` itself if it is not such a block."""
    line = lines[at]
    if fence := FENCE.match(line):
        close = fence.group(1)
        end = at + 1
        while end < len(lines) and not re.match(rf"\s*{re.escape(close)}\S*\s*$", lines[end]):
            end += 1
        return end + 1
    if at == 0 and line == "---":
        return lines.index("---", 1) + 1
    if HTML.match(line):
        end = at + 1
        comment = line.lstrip().startswith("<!--")
        while end < len(lines) and ("-->" not in lines[end - 1] if comment else lines[end].strip()):
            end += 1
        return end
    if ALONE.match(line):
        return at + 1
    code = " " * (inside + 4)
    if not line.startswith(code) or ITEM.match(line) or (at > 0 and lines[at - 1].strip()):
        return at
    end = at + 1
    while end < len(lines) and lines[end].startswith(code):
        end += 1
    return end


def reflow(text):
    """The text with its paragraphs and list items filled.

    >>> print(reflow("- " + "word " * 17 + "[a link](that/is/not/broken) and" + " more" * 3))
    - word word word word word word word word word word word word word word word word word
      [a link](that/is/not/broken) and more more more

    What would begin another block does not come first in a line, nor does a unit:

    >>> print(reflow("word " * 19 + "wide - b"))
    word word word word word word word word word word word word word word word word word word word
    wide - b
    >>> print(reflow("word " * 18 + "words 10 mm"))
    word word word word word word word word word word word word word word word word word word words
    10 mm

    Tables, code, and the ends of lines that break stay:

    >>> kept = "| a |\\n|---|\\n| " + "b " * 60 + "|\\n\\n    " + "code " * 30 + "\\n\\none  \\ntwo"
    >>> reflow(kept) == kept
    True
    """
    lines, out, at = text.split("\n"), [], 0
    # The columns at which the texts of the list items around begin.
    items = []
    while at < len(lines):
        line = lines[at]
        if not line.strip():
            out.append("")
            at += 1
            continue
        indent = len(line) - len(line.lstrip())
        after_blank = at == 0 or not lines[at - 1].strip()
        while items and indent < items[-1] and (after_blank or ITEM.match(line)):
            items.pop()
        end = verbatim(lines, at, items[-1] if items else 0)
        if end > at:
            out += lines[at:end]
            at = end
            continue
        quote = re.match(r"\s*> ?", line)
        if quote:
            first = rest = quote.group()
            line = line[quote.end():]
        elif item := ITEM.match(line):
            first = item.group()
            rest = " " * len(first)
            items.append(len(first))
            line = line[item.end():]
        else:
            first = rest = " " * (items[-1] if items else 0)
        block, at = [line], at + 1
        while at < len(lines) and lines[at].strip():
            if verbatim(lines, at, len(rest)) > at or (not quote and ITEM.match(lines[at])):
                break
            block.append(re.sub(r"^\s*> ?", "", lines[at]) if quote else lines[at])
            at += 1
        for part, broken in paragraphs(block):
            part[-1] = part[-1][: len(part[-1]) - len(broken)]
            filled = fill(part, first, rest)
            filled[-1] += broken
            out += filled
            first = rest
    return "\n".join(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing, fail where a file is not filled")
    parser.add_argument("files", nargs="*", type=Path, help="Markdown files; without any, all that are tracked")
    arguments = parser.parse_args()
    files = arguments.files
    if not files:
        root = Path(__file__).parent.parent
        listed = subprocess.run(["git", "ls-files", "*.md"], cwd=root, check=True, capture_output=True, text=True)
        files = [root / name for name in listed.stdout.splitlines()]
    wrong = 0
    for path in files:
        text = path.read_text(encoding="utf-8")
        filled = reflow(text)
        if filled == text:
            continue
        wrong += 1
        if arguments.check:
            pairs = enumerate(zip(text.split("\n"), filled.split("\n")), 1)
            number = next((number for number, (old, new) in pairs if old != new), 1)
            print(f"{path}:{number}: not filled to {WIDTH} columns; run scripts/docs_width.py", file=sys.stderr)
        else:
            path.write_text(filled, encoding="utf-8")
            print(path)
    return 1 if arguments.check and wrong else 0


if __name__ == "__main__":
    sys.exit(main())
