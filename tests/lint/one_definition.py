#!/usr/bin/env python3
"""Fails where two files define a type of one name in one namespace. The linker then takes one of the two for both in all
that templates make of them, and says nothing.

usage: one_definition.py ROOT
"""
import collections
import pathlib
import re
import sys

NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
NAMESPACE = re.compile(r'\bnamespace\s*([\w:]*)\s*$')
# A member of a class that is defined outside of it, as in `struct Tree::Impl {`, has no name of its own here.
TYPE = re.compile(r'\b(?:struct|class|enum class|enum|union)\s+(\w+)\s*(?:final\s*)?(?::[^:].*)?$', re.S)


def types_of(text):
    """Yields the whole names of the types that a file defines in namespaces that have a name."""
    text = NOT_CODE.sub('""', text)
    scopes, start = [], 0
    for mark in re.finditer(r'[{};]', text):
        head, start = text[start:mark.start()].strip(), mark.end()
        if mark.group() == '}' and scopes:
            scopes.pop()
        if mark.group() != '{':
            continue
        namespace, kind = NAMESPACE.search(head), TYPE.search(head)
        if kind and all(scopes):
            yield '::'.join([*scopes, kind.group(1)])
        # What is in an unnamed namespace, a type or a function is of no other file.
        scopes.append(namespace.group(1) if namespace else '')


def main():
    root = pathlib.Path(sys.argv[1])
    files_of = collections.defaultdict(list)
    for folder in ('lib', 'apps'):
        for path in sorted((root / folder).rglob('*')):
            if path.suffix in ('.h', '.cpp'):
                for name in types_of(path.read_text()):
                    files_of[name].append(str(path.relative_to(root)))
    if len(files_of) < 100:
        sys.exit(f'only {len(files_of)} types found')
    faults = [f'{name} is defined in {" and in ".join(files)}' for name, files in sorted(files_of.items()) if len(files) > 1]
    if faults:
        sys.exit('\n'.join(faults))


main()
