#!/usr/bin/env python3
"""Asks whether each mesh is good in every way that there is, and compares the answers.

usage: verdict_test.py MESHALYZER FOLDER

The ways: `check` as text, JSON, NDJSON, SARIF, JUnit and GitHub, and its exit status; the first line of the text report,
the verdict of the JSON report, the line of the summary, the page; goodness with thresholds that every mesh meets, and the
reasons for it. Prints each file whose answers differ, or whose reasons do.
"""

import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile
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


def of_first_line(text):
    line = text.split("\n", 1)[0]
    return "good" if line == "verdict: good" else "not good" if line.startswith("verdict: NOT good: ") else "unreadable"


def of_summary(text):
    columns = text.splitlines()[0].split()
    cells = text.splitlines()[1].split()
    return "unreadable" if "cannot be read" in text else {"yes": "good", "no": "not good"}[cells[columns.index("good")]]


def of_page(text):
    kind = re.search(r'<p class="verdict (good|bad)"', text)
    return "unreadable" if kind is None else {"good": "good", "bad": "not good"}[kind.group(1)]


def reasons_of_page(text):
    reasons = re.search(r'<ul class="reasons">(.*?)</ul>', text, re.DOTALL)
    return [html.unescape(reason) for reason in re.findall(r"<li>(.*?)</li>", reasons.group(1))] if reasons else []


def reports(program, path):
    """What the report says in each of its forms, and the reasons that each gives."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        text = run(program, "--html", str(page), path)
        told = page.read_text(errors="replace") if page.exists() else ""
    report = json.loads(run(program, "--json", path).stdout)
    verdict = report["meshes"][0]["verdict"] if report["meshes"] else {"good": False, "reasons": []}
    given = {"text report": of_first_line(text.stdout), "page": of_page(told),
             "summary": of_summary(run(program, "--summary", path).stdout),
             "json report": answer_of(not report.get("unreadable"), verdict["good"])}
    line = text.stdout.split("\n", 1)[0]
    reasons = {"text report": line.removeprefix("verdict: NOT good: ").split("; ") if "NOT good" in line else [],
               "json report": verdict["reasons"], "page": reasons_of_page(told)}
    return given, reasons


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
            "goodness": of_report(program, path)}


def main(program, folder):
    paths = [path for path in sorted(pathlib.Path(folder).rglob("*")) if path.suffix in ENDINGS]
    differing = 0
    counts = dict.fromkeys(ANSWERS.values(), 0)
    for path in paths:
        given, reasons = reports(program, str(path))
        given |= answers(program, str(path))
        counts[given["goodness"]] += 1
        if len(set(given.values())) != 1 or len(set(map(tuple, reasons.values()))) != 1:
            differing += 1
            print(f"{path}: {given} {reasons}")
    print(f"{len(paths)} files, {differing} with answers that differ: {counts}")
    return differing != 0 or not all(counts.values())


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
