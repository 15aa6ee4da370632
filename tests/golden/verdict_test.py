#!/usr/bin/env python3
"""Asks whether each mesh is good in every way that there is, and compares the answers.

usage: verdict_test.py MESHALYZER FOLDER

The ways: `check` as text, JSON, NDJSON, SARIF, JUnit and GitHub, and its exit status; goodness with thresholds that
every mesh meets, and the reasons for it. Prints each file whose answers differ.
"""

import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree

ENDINGS = {".mesh", ".obj", ".off", ".stl", ".ply"}
ANSWERS = {0: "good", 1: "not good", 3: "unreadable"}


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120,
                          check=False)


def answer_of(is_readable, is_good):
    return "good" if is_good else "not good" if is_readable else "unreadable"


def of_json(mesh):
    return answer_of(mesh["error"] is None, mesh["good"])


def of_sarif(text):
    results = json.loads(text)["runs"][0]["results"]
    rules = {result["ruleId"] for result in results}
    return answer_of("unreadable" not in rules, not rules)


def of_junit(text):
    case = xml.etree.ElementTree.fromstring(text.encode()).find(".//testcase")
    return answer_of(case.find("error") is None, len(case) == 0)


def of_text(text):
    *findings, _ = text.splitlines()
    return answer_of(not any("error[unreadable]" in line for line in findings), not findings)


def of_github(text):
    *findings, _ = text.splitlines()
    return answer_of(not any("title=unreadable" in line for line in findings), not findings)


def of_report(program, path):
    """What the report itself says: -g judges, and edge angles and lengths are never below nothing."""
    result = run(program, "-g", "inf,-1,-1", "--json", path)
    if result.returncode == 3:
        return "unreadable"
    mesh = json.loads(result.stdout)["meshes"][0]
    # An infinite aspect ratio is a matter of the thresholds, which ask for a finite one.
    reasons = [reason for reason in mesh["reasons"] if "infinite aspect ratio" not in reason]
    return answer_of(True, not reasons)


def answers(program, path):
    check = {name: run(program, "check", "--format", name, path)
             for name in ("text", "json", "ndjson", "sarif", "junit", "github")}
    return {"exit status": ANSWERS[check["text"].returncode],
            "text": of_text(check["text"].stdout),
            "json": of_json(json.loads(check["json"].stdout)["meshes"][0]),
            "ndjson": of_json(json.loads(check["ndjson"].stdout.splitlines()[0])),
            "sarif": of_sarif(check["sarif"].stdout),
            "junit": of_junit(check["junit"].stdout),
            "github": of_github(check["github"].stdout),
            "report": of_report(program, path)}


def main(program, folder):
    paths = [path for path in sorted(pathlib.Path(folder).rglob("*")) if path.suffix in ENDINGS]
    differing = 0
    counts = dict.fromkeys(ANSWERS.values(), 0)
    for path in paths:
        given = answers(program, str(path))
        counts[given["report"]] += 1
        if len(set(given.values())) != 1:
            differing += 1
            print(f"{path}: {given}")
    print(f"{len(paths)} files, {differing} with answers that differ: {counts}")
    return differing != 0 or not all(counts.values())


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
