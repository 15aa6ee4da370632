#!/usr/bin/env python3
"""Compares what two builds of the programs do, byte for byte: for changes that must not change behaviour.

usage: compare_builds.py OLD NEW [--without NAME]... [--damaged N] [FOLDER...]
  OLD, NEW         folders that hold meshalyzer and meshfixer, e.g. build/release/apps
  --without NAME   a statistic that only NEW reports, such as corner_angle: it is taken out before comparing
  --damaged N      also repairs N meshes, made from those of the folders by damaging records at random, a folder of many
                   in each run
  --only-damaged   compares nothing but these repairs
  --max-bytes B    damages only meshes of at most B bytes; the default is 60,000
  --seed S         of what is damaged; the same seed makes the same meshes
  FOLDER           what the programs are run on; the default is meshes and ../shared/corpus

Every file is analysed and repaired in several ways, every folder as a set; compared are exit status, standard output
and error, and all files written: reports, journals, pages, fields, repaired meshes. Prints each difference and a last
line of counts; exits 1 where there is a difference.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENDINGS = {'.mesh', '.obj', '.off', '.stl', '.ply'}
OF_FILE = [
    ('meshalyzer', ['-p', '-b', '0.5', '-c', '1', '-d', '100', '-e', '200', '-f', '2', '--json=@OUT@/report.json', '@IN@']),
    ('meshalyzer', ['-a', '@IN@']),
    ('meshalyzer', ['-a', '--json', '@IN@']),
    ('meshalyzer', ['-g', '20,5,0.001', '-p', '@IN@']),
    ('meshalyzer', ['-q', '--curvature', '--html', '@OUT@/page.html', '--ndjson=@OUT@/journal', '@IN@']),
    ('meshalyzer', ['--summary', '@IN@']),
    ('meshalyzer', ['--export', '@OUT@/field.vtp', '--field', 'defect', '@IN@']),
    ('meshfixer', ['--find', '--json', '@IN@']),
    ('meshfixer', ['@IN@', '-o', '@OUT@/fixed@ENDING@', '--json=@OUT@/report.json', '--html', '@OUT@/page.html']),
    ('meshfixer', ['--fix', 'all', '--max-deviation', '1%', '@IN@', '-o', '@OUT@/fixed.obj']),
]
OF_FOLDER = [
    ('meshalyzer', ['--json=@OUT@/report.json', '--ndjson=@OUT@/journal', '@IN@']),
    ('meshalyzer', ['-i', '-p', '@IN@']),
    ('meshalyzer', ['-s', '--force', '-p', '--html', '@OUT@/index.html', '@IN@']),
    ('meshalyzer', ['--summary', '@IN@']),
    ('meshalyzer', ['-v', '@IN@']),
    ('meshalyzer', ['-a', '--json', '@IN@']),
]
OF_DAMAGED = [('meshfixer', ['@IN@', '-o', '@OUT@/fixed', '--json=@OUT@/report.json'])]
DAMAGED_AT_ONCE = 100


class Stripper:
    """Takes statistics out of texts of every format."""

    def __init__(self, names):
        self.keys = set(names)
        self.labels = [name.replace('_', ' ') for name in names]

    def strip(self, text):
        if not self.keys:
            return text
        if text.lstrip().startswith('{'):
            return self.strip_json(text)
        for label in self.labels:
            text = re.sub(r'<figure class="histogram">\s*<figcaption>(?:(?!</figure>).)*?>%s<.*?</figure>\s*' % label, '',
                          text, flags=re.S)
            text = re.sub(r'^%s .*\n(?:  .*\n)*' % label, '', text, flags=re.M)
            text = re.sub(r'^%s: undefined.*\n' % label, '', text, flags=re.M)
        return text

    def strip_json(self, text):
        """Values stay as they are written; the layout is no part of what is compared any more."""
        decoder = json.JSONDecoder(parse_float=lambda x: ('real', x), parse_int=lambda x: ('integer', x),
                                   object_pairs_hook=lambda pairs: [p for p in pairs if p[0] not in self.keys])
        values = []
        rest = text.strip()
        while rest:
            value, end = decoder.raw_decode(rest)
            values.append(value)
            rest = rest[end:].strip()
        return repr(values)


def outcome(folder, program, arguments, stripper):
    """What a run leaves: by name, the bytes or the text of it."""
    with tempfile.TemporaryDirectory() as out:
        run = subprocess.run([str(folder / program), *(a.replace('@OUT@', out) for a in arguments)],
                             capture_output=True, cwd=ROOT, timeout=600)
        left = {'exit': run.returncode, 'stdout': run.stdout, 'stderr': run.stderr}
        for path in sorted(pathlib.Path(out).rglob('*')):
            if path.is_file():
                left[str(path.relative_to(out))] = path.read_bytes()
        for name, content in left.items():
            if isinstance(content, bytes):
                content = content.replace(out.encode(), b'@OUT@')
                left[name] = stripper.strip(content.decode('utf-8', 'surrogateescape'))
        return left


def compare(task):
    old, new, program, arguments, stripper = task
    before = outcome(old, program, arguments, stripper)
    after = outcome(new, program, arguments, stripper)
    differing = sorted(name for name in before.keys() | after.keys() if before.get(name) != after.get(name))
    return program, arguments, len(before), differing


def damage(text, generator):
    """A mesh in text with some of its lines exchanged, repeated, cut, or with one number changed."""
    lines = text.splitlines(keepends=True)
    for _ in range(generator.randint(1, 4)):
        i, j = generator.randrange(len(lines)), generator.randrange(len(lines))
        way = generator.randrange(4)
        if way == 0:
            lines[i], lines[j] = lines[j], lines[i]
        elif way == 1:
            lines.insert(i, lines[j])
        elif way == 2:
            words = lines[i].split(' ')
            words[-1] = lines[j].split(' ')[-1]
            lines[i] = ' '.join(words)
        elif len(lines) > 8:
            del lines[i]
    return ''.join(lines)


def damaged_meshes(n, files, folder, seed=1, max_bytes=60_000):
    texts = [(path, path.read_text()) for path in files
             if path.suffix in ('.mesh', '.obj', '.off') and 0 < path.stat().st_size < max_bytes]
    generator = random.Random(seed)
    made = []
    for i in range(n):
        path, text = generator.choice(texts)
        target = folder / f'{i}{path.suffix}'
        target.write_text(damage(text, generator))
        made.append(target)
    return made


def damaged_folders(arguments, files, scratch):
    """Makes the damaged meshes, a folder of some at a time; the seed of each folder follows from its number."""
    for first in range(0, arguments.damaged, DAMAGED_AT_ONCE):
        folder = scratch / f'damaged_{first}'
        folder.mkdir()
        damaged_meshes(min(DAMAGED_AT_ONCE, arguments.damaged - first), files, folder, f'{arguments.seed} {first}',
                       arguments.max_bytes)
        yield folder


def calls(commands, path):
    for program, arguments in commands:
        yield program, [a.replace('@IN@', str(path)).replace('@ENDING@', path.suffix.lower()) for a in arguments]


def tasks(arguments, scratch):
    folders = [pathlib.Path(os.path.relpath(f, ROOT)) for f in arguments.folders] or [
        pathlib.Path('meshes'), pathlib.Path('../shared/corpus')]
    files = sorted(p for f in folders for p in (ROOT / f).rglob('*') if p.suffix.lower() in ENDINGS and p.is_file())
    if not arguments.only_damaged:
        for path in files:
            yield from calls(OF_FILE, pathlib.Path(os.path.relpath(path, ROOT)))
        for folder in sorted({path.parent for path in files}):
            yield from calls(OF_FOLDER, pathlib.Path(os.path.relpath(folder, ROOT)))
    for folder in damaged_folders(arguments, files, scratch):
        yield from calls(OF_DAMAGED, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('old', type=pathlib.Path)
    parser.add_argument('new', type=pathlib.Path)
    parser.add_argument('folders', nargs='*', metavar='FOLDER')
    parser.add_argument('--without', action='append', default=[], metavar='NAME')
    parser.add_argument('--damaged', type=int, default=0, metavar='N')
    parser.add_argument('--only-damaged', action='store_true')
    parser.add_argument('--max-bytes', type=int, default=60_000, metavar='B')
    parser.add_argument('--seed', type=int, default=1, metavar='S')
    arguments = parser.parse_intermixed_args()
    stripper = Stripper(arguments.without)
    scratch = pathlib.Path(tempfile.mkdtemp())
    n_runs = n_compared = n_differing = 0
    try:
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            work = ((arguments.old.resolve(), arguments.new.resolve(), *task, stripper)
                    for task in tasks(arguments, scratch))
            for program, call, n_outputs, differing in pool.map(compare, work):
                n_runs += 1
                n_compared += n_outputs
                if differing:
                    n_differing += 1
                    print(program, ' '.join(call), 'differs:', ', '.join(differing))
    finally:
        shutil.rmtree(scratch)
    print(f'{n_runs} runs with {n_compared} outputs, {n_differing} runs differ')
    return 1 if n_differing else 0


if __name__ == '__main__':
    sys.exit(main())
