#!/usr/bin/env python3
"""Fails where the body of a condition or loop stands on a line of its own without braces: a body stands on the line where
its head ends, or in braces.

usage: braces.py ROOT
"""
import pathlib
import re
import sys

HEAD = re.compile(r'\s*(?:} )?(?:else )?(?:if(?: constexpr)?|for|while) \(')


def end_of_head(lines, i):
    """Returns the line on which the parentheses opened on line i are closed, and what follows them there."""
    depth = 0
    for number in range(i, len(lines)):
        line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'|//.*', '""', lines[number])
        start = line.index('(') if number == i else 0
        for place in range(start, len(line)):
            depth += (line[place] == '(') - (line[place] == ')')
            if depth == 0:
                return number, line[place + 1:].strip()
    return len(lines) - 1, ''


def bare_bodies(text):
    lines = text.split('\n')
    for i, line in enumerate(lines):
        if HEAD.match(line):
            last, rest = end_of_head(lines, i)
            if not rest:
                yield last + 1
        elif re.fullmatch(r'\s*(?:} )?(?:else|do)', line):
            yield i + 1


def main():
    root = pathlib.Path(sys.argv[1])
    sources = [p for folder in ('lib', 'apps') for ending in ('*.h', '*.cpp') for p in sorted((root / folder).rglob(ending))]
    if not sources:
        sys.exit('no sources found')
    faults = [f'{p.relative_to(root)}:{line}: the body below has no braces' for p in sources
              for line in bare_bodies(p.read_text())]
    if faults:
        sys.exit('\n'.join(faults))


main()
