#!/usr/bin/env python3
"""Tries the hooks of doc/check.md and .pre-commit-hooks.yaml on a repository made for it.

usage: hooks_test.py MESHALYZER ROOT
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest


class Hooks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # Neither the settings of the user nor those of a repository round this one.
        identity = {f"GIT_{who}_{what}": value for who in ("AUTHOR", "COMMITTER")
                    for what, value in (("NAME", "a"), ("EMAIL", "a@example.org"))}
        self.environment = {"PATH": f"{MESHALYZER.parent}:{os.environ['PATH']}", "HOME": folder.name,
                            "GIT_CONFIG_NOSYSTEM": "1", **identity}
        self.git("init", "-q", "-b", "main")

    def git(self, *arguments):
        return subprocess.run(["git", *arguments], cwd=self.folder, env=self.environment, capture_output=True, text=True,
                              timeout=60, check=False)

    def commits(self, *names):
        """Whether a commit of these meshes is made."""
        for name in names:
            shutil.copy(ROOT / "meshes" / name, self.folder)
        self.git("add", ".")
        return self.git("commit", "-q", "-m", "meshes").returncode == 0

    def test_the_hook_of_git_lets_good_meshes_pass_and_others_not(self):
        script = re.search(r"```sh\n(#!/bin/sh\n.*?)```", (ROOT / "doc" / "check.md").read_text(), re.DOTALL).group(1)
        hook = self.folder / ".git" / "hooks" / "pre-commit"
        hook.parent.mkdir(exist_ok=True)
        hook.write_text(script)
        hook.chmod(0o755)
        self.assertTrue(self.commits("README.md"))
        self.assertTrue(self.commits("cube.mesh", "torus.obj"))
        self.assertFalse(self.commits("cube_with_hole.mesh"))

    def test_the_hook_of_pre_commit_is_for_meshes(self):
        text = (ROOT / ".pre-commit-hooks.yaml").read_text()
        pattern = re.compile(re.search(r"^  files: (.*)$", text, re.MULTILINE).group(1))
        for name in ("a.mesh", "b/c.OBJ", "d.stl.gz"):
            self.assertTrue(pattern.search(name), name)
        for name in ("mesh", "a.obj.txt", "b.gz", "c.stl~"):
            self.assertFalse(pattern.search(name), name)
        entry = re.search(r"^  entry: (.*)$", text, re.MULTILINE).group(1).split()
        result = subprocess.run([*entry, ROOT / "meshes" / "cube.mesh"], env=self.environment, capture_output=True,
                                timeout=60, check=False)
        self.assertEqual(result.returncode, 0)


if __name__ == "__main__":
    MESHALYZER, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
