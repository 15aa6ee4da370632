#!/usr/bin/env python3
"""Fails where two files define a type of one name in one namespace. The linker then takes one of the two for both in all
that templates make of them, and says nothing. In an unnamed namespace a type is of its file alone, but a unity build takes
some modules for one file: each UNIT names these, as lib/CMakeLists.txt does.

usage: one_definition.py ROOT UNIT...
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
    """Yields the names of the types that a file defines in namespaces: all of their names, '' for unnamed ones."""
    text = NOT_CODE.sub('""', text)
    scopes, start = [], 0
    for mark in re.finditer(r'[{};]', text):
        head, start = text[start:mark.start()].strip(), mark.end()
        if mark.group() == '}' and scopes:
            scopes.pop()
        if mark.group() != '{':
            continue
        namespace, kind = NAMESPACE.search(head), TYPE.search(head)
        if kind and None not in scopes:
            yield (*scopes, kind.group(1))
        # Names within a type or a function clash with no other file.
        scopes.append(namespace.group(1) if namespace else None)


def main():
    root = pathlib.Path(sys.argv[1])
    unit_of = {module: unit for unit in sys.argv[2:] for module in unit.split()}
    files_of = collections.defaultdict(list)
    for folder in ('lib', 'apps'):
        for path in sorted((root / folder).rglob('*')):
            if path.suffix in ('.h', '.cpp'):
                file = path.relative_to(root)
                for name in types_of(path.read_text()):
                    whole_name = '::'.join(part for part in name if part)
                    part = file.parts[2] if folder == 'lib' else file.parts[1]
                    for unit in [(folder, unit_of.get(part, part))] + ([] if '' in name else [()]):
                        files_of[unit, whole_name].append(str(file))
    if len(files_of) < 100:
        sys.exit(f'only {len(files_of)} types found')
    faults = sorted({f'{name} is defined in {" and in ".join(files)}'
                     for (_, name), files in files_of.items() if len(files) > 1})
    if faults:
        sys.exit('\n'.join(faults))


main()
