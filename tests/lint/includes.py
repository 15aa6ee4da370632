#!/usr/bin/env python3
"""Compiles each source of lib and apps by itself, without making code, and fails where one does not include what it uses:
a unity build, which compiles a module as one, does not see that.

usage: includes.py ROOT UNITY_BUILD

UNITY_BUILD is a build folder with a compile_commands.json. Needs clang++, whose precompiled headers can be used by compilations
of which each defines other macros.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # so that the import leaves nothing among the sources
import standard_headers

# Headers that most sources include. So an include of one of these that is missing is not noticed: standard_headers.py looks for those
# of the standard library.
PRECOMPILED = [*standard_headers.NAMES, 'Eigen/Core', 'Eigen/Geometry', 'OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh']


def options_of_units(build):
    """Yields for each unity source its members and the options that tell what is included and defined."""
    for entry in json.loads((build / 'compile_commands.json').read_text()):
        unit = pathlib.Path(entry['file'])
        if unit.name.startswith('unity_') and not unit.is_relative_to(build / 'tests'):
            words = shlex.split(entry['command'])
            options = [word for word in words if re.match(r'-(D|I|std=)', word)]
            options += [part for i, word in enumerate(words) if word == '-isystem' for part in words[i:i + 2]]
            yield re.findall(r'#include "(/.*\.cpp)"', unit.read_text()), options


def sources_alone(root, build):
    """Returns how many sources of lib and apps the build compiles by themselves, as the check would."""
    files = {pathlib.Path(entry['file']) for entry in json.loads((build / 'compile_commands.json').read_text())}
    return sum(1 for file in files if any(file.is_relative_to(root / folder) for folder in ('lib', 'apps')))


def main():
    root, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    jobs = [(source, options) for sources, options in options_of_units(build) for source in sources]
    expected = sum(1 for folder in ('lib', 'apps') for _ in (root / folder).rglob('*.cpp'))
    found = len(jobs) + sources_alone(root, build)
    if found < expected:
        sys.exit(f'{build} compiles {found} of {expected} sources')

    with tempfile.TemporaryDirectory() as folder:
        header, precompiled = pathlib.Path(folder, 'outside.h'), pathlib.Path(folder, 'outside.pch')
        header.write_text(''.join(f'#include <{name}>\n' for name in PRECOMPILED))

        def compiler(options):
            return ['clang++', *options, '-w', '-DBOOST_ALL_NO_LIB', '-DCGAL_USE_GMPXX=1']

        plain = [o for o in jobs[0][1] if not o.startswith(('-D', '-I'))]
        subprocess.run([*compiler(plain), '-fpch-instantiate-templates', '-x', 'c++-header', str(header), '-o', str(precompiled)], check=True)

        def fault(job):
            source, options = job
            done = subprocess.run([*compiler(options), '-include-pch', str(precompiled), '-fsyntax-only', source],
                                  stderr=subprocess.PIPE, text=True)
            return done.stderr if done.returncode else ''

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            faults = [text for text in pool.map(fault, jobs) if text]
    if faults:
        sys.exit('\n'.join(faults))
    print(f'{len(jobs)} sources include what they use')


main()
