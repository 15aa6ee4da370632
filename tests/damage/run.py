#!/usr/bin/env python3
"""Damages mesh files at random and runs both programs on them: nothing may crash, hang or take all memory.

usage: run.py [--runs N] [--seed S] [--intact] [--keep FOLDER] PROGRAMS [FOLDER...]
  PROGRAMS       folder that holds meshalyzer and meshfixer
  FOLDER         where the meshes are; the default is meshes and ../shared/corpus
  --runs N       number of damaged files, each given to both programs; default 100
  --seed S       of what is random; the same seed makes the same files
  --intact       gives each mesh to both programs once, as it is
  --keep FOLDER  keeps the files that failed there

A file loses or gains bytes: bits are flipped, runs of bytes cut, repeated, or exchanged with others, lines too. Files of up to
400 kB are taken. Each program has 10 seconds of CPU time and 1 GB of memory, and must end with a status that is its own: 0, 1 or 3.
Prints a line for each failure and a last line of counts; exits 1 where there is a failure.
"""
import argparse
import concurrent.futures
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENDINGS = {'.mesh', '.obj', '.off', '.stl', '.ply'}
MAX_BYTES = 400_000
MAX_SECONDS = 10
MAX_MEMORY = 1 << 30
STATUSES = {0, 1, 3}


def flip_bits(data, rng):
    for _ in range(rng.choice([1, 3, 10, 50])):
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)


def a_range(data, rng):
    """Picks a short run of bytes."""
    begin = rng.randrange(len(data))
    return begin, min(len(data), begin + rng.choice([1, 4, 16, 200, 4000]))


def cut_bytes(data, rng):
    begin, end = a_range(data, rng)
    del data[begin:end]


def repeat_bytes(data, rng):
    begin, end = a_range(data, rng)
    data[end:end] = data[begin:end]


def exchange_bytes(data, rng):
    (a, b), (c, d) = sorted([a_range(data, rng), a_range(data, rng)])
    if b <= c:
        data[a:d] = data[c:d] + data[b:c] + data[a:b]


def cut_tail(data, rng):
    del data[rng.randrange(len(data)):]


def change_lines(data, rng):
    """Cuts, repeats or exchanges lines, which leaves more of a text file readable."""
    lines = bytes(data).split(b'\n')
    for _ in range(rng.choice([1, 5, 30])):
        i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
        what = rng.randrange(3)
        if what == 0 and len(lines) > 1:
            del lines[i]
        elif what == 1:
            lines.insert(j, lines[i])
        else:
            lines[i], lines[j] = lines[j], lines[i]
    data[:] = b'\n'.join(lines)


def change_digits(data, rng):
    """Exchanges digits, so that a text file stays readable and says something else."""
    places = [i for i, byte in enumerate(data) if byte in b'0123456789']
    for i in rng.sample(places, min(len(places), rng.choice([1, 5, 50]))):
        data[i] = rng.choice(b'0123456789')


DAMAGES = [flip_bits, cut_bytes, repeat_bytes, exchange_bytes, cut_tail, change_lines, change_digits]


def damaged(data, rng):
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 4])):
        if data:
            rng.choice(DAMAGES)(data, rng)
    return bytes(data)


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (MAX_SECONDS, MAX_SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_AS, (2 * MAX_MEMORY, 2 * MAX_MEMORY))


def run(command):
    """Runs a program; returns what was wrong, or nothing."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=limit)
    errors = process.stderr.read().decode(errors='replace')
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if usage.ru_maxrss * 1024 > MAX_MEMORY:
        return f'took {usage.ru_maxrss >> 10} MB'
    if usage.ru_utime + usage.ru_stime > MAX_SECONDS:
        return 'took too long'
    if process.returncode not in STATUSES or 'bad_alloc' in errors:
        return f'ended with {process.returncode}: {errors.strip()[:200]}'
    return None


def failures_of(job):
    """Makes a file, damaged unless there is no seed, and runs both programs on it; returns their failures."""
    programs, source, seed, keep = job
    data = source.read_bytes() if seed is None else damaged(source.read_bytes(), random.Random(seed))
    with tempfile.TemporaryDirectory() as scratch:
        name = source.stem if seed is None else f'damaged_{seed}'
        file = pathlib.Path(scratch, name + source.suffix)
        file.write_bytes(data)
        commands = [[programs / 'meshalyzer', '--threads', '1', '-p', file],
                    [programs / 'meshfixer', '--threads', '1', file, '-o', file.with_name('fixed' + source.suffix)]]
        failures = []
        for command in commands:
            if wrong := run([str(part) for part in command]):
                failures.append(f'{source} ({file.name}): {command[0].name} {wrong}')
        if failures and keep:
            shutil.copy(file, keep)
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--runs', type=int, default=100)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--intact', action='store_true')
    parser.add_argument('--keep', type=pathlib.Path)
    parser.add_argument('programs', type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument('folders', nargs='*', type=pathlib.Path)
    options = parser.parse_args()
    folders = options.folders or [ROOT / 'meshes', ROOT.parent / 'shared' / 'corpus']
    sources = sorted(path for folder in folders for path in folder.rglob('*')
                     if path.suffix in ENDINGS and 0 < path.stat().st_size <= MAX_BYTES)
    if not sources:
        sys.exit('no meshes found')
    if options.keep:
        options.keep.mkdir(parents=True, exist_ok=True)
    if options.intact:
        jobs = [(options.programs, source, None, options.keep) for source in sources]
    else:
        rng = random.Random(options.seed)
        jobs = [(options.programs, rng.choice(sources), options.seed * 1_000_003 + i, options.keep) for i in range(options.runs)]
    n_failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for failures in pool.map(failures_of, jobs):
            for failure in failures:
                print(failure, flush=True)
            n_failed += len(failures)
    print(f'{len(jobs)} files, {n_failed} failures')
    sys.exit(1 if n_failed else 0)


main()
