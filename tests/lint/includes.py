#!/usr/bin/env python3
"""Parses each source and each header of lib and apps without what others include, and fails where one does not include what it uses:
a unity build, which compiles a module as one, does not see that.

usage: includes.py ROOT UNITY_BUILD

UNITY_BUILD is a build folder with a compile_commands.json. Needs clang++: sources and headers are made submodules, as Clang calls
them ("Modules", clang.llvm.org/docs/Modules.html). So each header is parsed once, and yet a source sees those that it includes, and
no others.
"""
import collections
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

BASIC = 'basic'


def library_of(header):
    """Returns the name of the module of a header that is not ours: each library is one, so that an include of a second of its
    headers is not missed. What most sources use is one with the standard library, whose missing includes standard_headers.py finds.
    """
    if '.' not in header or header.startswith(('Eigen/', 'OpenMesh/')) or header.endswith('intrin.h'):
        return BASIC
    return re.sub(r'\W', '_', header.split('/')[0])


def options_of_units(build):
    """Yields for each unity source its members and the options that tell what is included and defined."""
    for entry in json.loads((build / 'compile_commands.json').read_text()):
        unit = pathlib.Path(entry['file'])
        if unit.name.startswith('unity_') and not unit.is_relative_to(build / 'tests'):
            words = shlex.split(entry['command'])
            options = [word for word in words if re.match(r'-(D|I|std=)', word)]
            options += [f'-isystem{folder}' for word, folder in zip(words, words[1:]) if word == '-isystem']
            yield re.findall(r'#include "(/.*\.cpp)"', unit.read_text()), options


def sources_alone(root, build):
    """Returns how many sources of lib and apps the build compiles by themselves, as the check would."""
    files = {pathlib.Path(entry['file']) for entry in json.loads((build / 'compile_commands.json').read_text())}
    return sum(1 for file in files if any(file.is_relative_to(root / folder) for folder in ('lib', 'apps')))


def outside_headers(files):
    """Returns the headers that the files include and that are not ours, each library's in the order of a file that includes them."""
    names = dict.fromkeys(standard_headers.NAMES)
    for file in files:
        names.update(dict.fromkeys(re.findall(r'^#include <(.+)>$', file.read_text(), re.MULTILINE)))
    return list(names)


class Modules:
    """Compiles modules, each of which sees those before it."""

    def __init__(self, folder, options):
        self.folder, self.options, self.before = folder, [*options, '-w', '-ferror-limit=0'], []

    def search_folders(self):
        """Returns the folders in which the compiler looks for headers."""
        told = subprocess.run(['clang++', *self.options, '-E', '-v', '-x', 'c++', os.devnull], capture_output=True, text=True, check=True)
        listed = told.stderr.split('#include <...> search starts here:')[1].split('End of search list.')[0]
        return [pathlib.Path(line.strip()) for line in listed.strip().splitlines()]

    def compile_together(self, name, headers):
        """Compiles headers of others, which include each other, and returns what the compiler says of faults."""
        return self.compile(name, '[system]', [*(f'header "{header}"' for header in headers), 'export *'])

    def compile_each(self, name, files, include_folders):
        """Compiles headers or sources of which none sees what another includes, and returns what the compiler says of faults."""
        return self.compile(name, '', [f'module part_{i} {{ header "{file}" export * }}' for i, file in enumerate(files)], include_folders)

    def compile(self, name, attribute, members, include_folders=()):
        module_map, compiled = self.folder / f'{name}.map', self.folder / f'{name}.pcm'
        module_map.write_text('\n'.join([f'module {name} {attribute} {{', *members, '}\n']))
        done = subprocess.run(
            ['clang++', *include_folders, *self.options, '-fmodules', '-fno-implicit-modules', '-fno-implicit-module-maps',
             '-Xclang', '-fmodules-local-submodule-visibility', *self.before, f'-fmodule-name={name}', '-Xclang', '-emit-module',
             '-x', 'c++', '-c', str(module_map), '-o', str(compiled)], stderr=subprocess.PIPE, text=True)
        return done.stderr if done.returncode else ''

    def show_to_others(self, names):
        self.before += [option for name in names for option in (f'-fmodule-map-file={self.folder / name}.map',
                                                                f'-fmodule-file={self.folder / name}.pcm')]


def named_copy(source, number, folder):
    """Writes a copy of a source whose unnamed namespaces have a name, and returns its path.

    The names in an unnamed namespace are visible in the source of the module that is the first to open it in a namespace, but not
    in the others (Clang 14).
    """
    copy = folder / f'{number}.cpp'
    text = re.sub(r'^namespace \{$', f'inline namespace source_{number} {{', pathlib.Path(source).read_text(), flags=re.MULTILINE)
    copy.write_text(f'#line 1 "{source}"\n{text}')
    return copy


def main():
    root, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    units = list(options_of_units(build))
    sources = [source for members, _ in units for source in members]
    ours = {suffix: [file for folder in ('lib', 'apps') for file in sorted((root / folder).rglob(suffix))] for suffix in ('*.h', '*.cpp')}
    if len(sources) + sources_alone(root, build) < len(ours['*.cpp']):
        sys.exit(f'{build} compiles {len(sources)} of {len(ours["*.cpp"])} sources')

    options = list(dict.fromkeys(option for _, options in units for option in options if not option.startswith('-I')))
    include_folders = list(dict.fromkeys(option for _, options in units for option in options if option.startswith('-I')))
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = pathlib.Path(folder)
        modules = Modules(folder, options)
        places = modules.search_folders()
        libraries = collections.defaultdict(list)
        for name in outside_headers(ours['*.h'] + ours['*.cpp']):
            libraries[library_of(name)].append(next(place / name for place in places if (place / name).is_file()))
        basic, others = libraries.pop(BASIC), sorted(libraries)

        faults = [modules.compile_together(BASIC, basic)]
        modules.show_to_others([BASIC])
        faults += pool.map(lambda name: modules.compile_together(name, libraries[name]), others)
        modules.show_to_others(others)
        faults.append(modules.compile_each('headers', ours['*.h'], include_folders))
        modules.show_to_others(['headers'])
        if not any(faults):
            def fault_of_unit(number):
                members, options = units[number]
                copies = [named_copy(source, sources.index(source), folder) for source in members]
                return modules.compile_each(f'unit_{number}', copies, [option for option in options if option.startswith('-I')])

            faults += pool.map(fault_of_unit, range(len(units)))
    if any(faults):
        sys.exit('\n'.join(fault for fault in faults if fault))
    print(f'{len(sources)} sources and {len(ours["*.h"])} headers include what they use')


main()
