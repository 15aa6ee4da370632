#!/usr/bin/env python3
"""Holds what `check` writes for machines to what their formats ask for.

usage: machine_formats_test.py MESHALYZER FOLDER CHECK_SCHEMA

SARIF 2.1.0 (OASIS) and JUnit (the schema of the xUnit plugin of Jenkins) as far as they are used here: which members an
object must have and may have, and of which types and values they are. The schemas themselves are not ours to copy. JSON is
held to its schema where Python has a validator.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    import jsonschema
except ImportError:
    jsonschema = None

LEVELS = {"none", "note", "warning", "error"}

# The members that each object must have (!) and may have: a type, a set of values, a shape, or a list of one of these.
MESSAGE = {"text!": str}
LOCATION = {"physicalLocation": {"artifactLocation": {"uri": str}, "region": {"startLine": int}}}
RULE = {"id!": str, "shortDescription": MESSAGE, "fullDescription": MESSAGE}
RESULT = {"ruleId": str, "level": LEVELS, "message!": MESSAGE, "locations": [LOCATION]}
NOTIFICATION = {"level": LEVELS, "message!": MESSAGE, "locations": [LOCATION]}
RUN = {"tool!": {"driver!": {"name!": str, "version": str, "rules": [RULE]}}, "results": [RESULT],
       "artifacts": [{"location": {"uri": str}}],
       "invocations": [{"executionSuccessful!": bool, "toolExecutionNotifications": [NOTIFICATION]}]}
LOG = {"$schema": str, "version!": {"2.1.0"}, "runs!": [RUN]}

# Attributes that elements must have (!) and may have, and their children.
NUMBERS = {"tests": int, "failures": int, "errors": int, "time": float}
JUNIT = {"testsuites": ({"name": str, **NUMBERS}, {"testsuite"}),
         "testsuite": ({"name!": str, "tests!": int, **NUMBERS}, {"testcase"}),
         "testcase": ({"name!": str, "classname": str, "time": float}, {"failure", "error", "system-out"}),
         "failure": ({"type": str, "message": str}, set()),
         "error": ({"type": str, "message": str}, set()),
         "system-out": ({}, set())}


def faults_of_value(value, shape, place):
    if isinstance(shape, dict):
        yield from faults_of_object(value, shape, place)
    elif isinstance(shape, list):
        if not isinstance(value, list):
            yield f"{place} is no list"
            return
        for number, item in enumerate(value):
            yield from faults_of_value(item, shape[0], f"{place}[{number}]")
    elif isinstance(shape, set):
        if value not in shape:
            yield f"{place} is {value!r}"
    elif type(value) is not shape:
        yield f"{place} is {value!r}, no {shape.__name__}"


def faults_of_object(value, shape, place):
    if not isinstance(value, dict):
        yield f"{place} is no object"
        return
    members = {name.rstrip("!"): member for name, member in shape.items()}
    for name in shape:
        if name.endswith("!") and name[:-1] not in value:
            yield f"{place} has no {name[:-1]}"
    for name, member in value.items():
        if name not in members:
            yield f"{place} has {name}"
        else:
            yield from faults_of_value(member, members[name], f"{place}.{name}")


def faults_of_sarif(text):
    log = json.loads(text)
    yield from faults_of_object(log, LOG, "log")
    for run in log["runs"]:
        rules = [rule["id"] for rule in run["tool"]["driver"]["rules"]]
        if len(set(rules)) != len(rules):
            yield "a rule is defined twice"
        artifacts = [artifact["location"]["uri"] for artifact in run["artifacts"]]
        if len(set(artifacts)) != len(artifacts):
            yield "an artifact is listed twice"
        for result in run["results"]:
            message = result["message"]["text"]
            if set("{}") & set(message.replace("{{", "").replace("}}", "")):
                yield f"a place for an argument that is not there: {message}"
            if result["ruleId"] not in rules:
                yield f"no rule {result['ruleId']}"
            region = result["locations"][0]["physicalLocation"].get("region")
            if region and region["startLine"] < 1:
                yield f"line {region['startLine']}"


def is_number(text, kind):
    try:
        return kind(text) >= 0
    except ValueError:
        return False


def faults_of_element(element, names):
    if element.tag not in names:
        yield f"<{element.tag}> stands where it may not"
        return
    attributes, children = JUNIT[element.tag]
    known = {name.rstrip("!"): kind for name, kind in attributes.items()}
    for name in attributes:
        if name.endswith("!") and name[:-1] not in element.attrib:
            yield f"<{element.tag}> has no {name[:-1]}"
    for name, text in element.attrib.items():
        if name not in known:
            yield f"<{element.tag}> has {name}"
        elif known[name] is not str and not is_number(text, known[name]):
            yield f"<{element.tag}> has {name} {text!r}"
    for child in element:
        yield from faults_of_element(child, children)


def faults_of_junit(text):
    root = xml.etree.ElementTree.fromstring(text.encode())
    yield from faults_of_element(root, {"testsuites"})
    for suite in root:
        cases = list(suite)
        counts = {"tests": len(cases), "failures": len(suite.findall("testcase/failure")),
                  "errors": len(suite.findall("testcase/error"))}
        for name, count in counts.items():
            if int(suite.get(name)) != count:
                yield f"{name} is {suite.get(name)}, but there are {count}"


def faults_of_json(text, schema):
    if jsonschema:
        jsonschema.Draft202012Validator.check_schema(schema)
        for fault in jsonschema.Draft202012Validator(schema).iter_errors(json.loads(text)):
            yield f"{fault.json_path}: {fault.message}"


def write_odd_files(folder):
    """Files whose names and contents are hard to write: not to be read, wrongly named, with signs of XML and of URIs, with the
    end of a line, with what stands for an argument in messages of SARIF."""
    (folder / "no mesh <&>.obj").write_text("hello\n")
    (folder / "no mesh either.mesh").write_text("{0}}{\n")
    (folder / "wrong ending.stl").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    (folder / "100% \"ü\".off").write_text("OFF\n1 0 0\n0 0 0\n")
    (folder / "two\nlines\tof.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    (folder / "damaged.ply.gz").write_bytes(b"\x1f\x8b\x08\x00")


def main(program, meshes, schema_path):
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        odd = pathlib.Path(folder)
        write_odd_files(odd)
        paths = [meshes, folder, str(odd / "missing.mesh"), str(odd / "missing.mesh")]

        def report(name):
            result = subprocess.run([program, "check", "--format", name, *paths], capture_output=True, text=True,
                                    timeout=300, check=False)
            if result.returncode != 3:
                faults.append(f"{name}: exit status {result.returncode}")
            return result.stdout

        sarif = report("sarif")
        faults += [f"sarif: {fault}" for fault in faults_of_sarif(sarif)]
        junit = report("junit")
        faults += [f"junit: {fault}" for fault in faults_of_junit(junit)]
        schema = json.loads(pathlib.Path(schema_path).read_text())
        text = report("json")
        faults += [f"json: {fault}" for fault in faults_of_json(text, schema)]
        # A SARIF schema that somebody has at hand sees more than we do.
        if jsonschema and os.environ.get("SARIF_SCHEMA"):
            full = json.loads(pathlib.Path(os.environ["SARIF_SCHEMA"]).read_text())
            faults += [f"sarif: {fault.message}" for fault in jsonschema.Draft7Validator(full).iter_errors(json.loads(sarif))]
        meshes_told = json.loads(text)["meshes"]
        cases = xml.etree.ElementTree.fromstring(junit.encode()).iter("testcase")
        if [case.get("name") for case in cases] != [mesh["path"] for mesh in meshes_told]:
            faults.append("junit: the cases do not have the names of the files")
    unreadable = sum(mesh["error"] is not None for mesh in meshes_told)
    named = sum("named_format" in mesh for mesh in meshes_told)
    print("\n".join(faults) or f"{len(meshes_told)} files, {unreadable} unreadable, {named} wrongly named: all as asked for")
    return bool(faults) or unreadable < 3 or named != 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
