"""A run that was ended anyhow goes on where it was, and comes to the same report."""

import os
import random
import shutil
import signal
import subprocess
import time
import unittest

import program

JOURNAL = "journal.ndjson"


class Resume(program.SetTest):
    def journal(self, *arguments, status=program.DONE):
        """The report of a run that keeps a journal."""
        return self.run_program(f"--ndjson={JOURNAL}", *arguments, status=status)

    def cut(self, journal, length):
        (self.folder / JOURNAL).write_bytes(journal[:length])


class Torn(Resume):
    """Wherever a kill cuts the journal off."""

    def check(self, *arguments, n_cuts=12, status=program.DONE):
        whole = self.journal(*arguments, status=status)
        journal = self.read(JOURNAL)
        ends = [i + 1 for i, byte in enumerate(journal) if byte == ord("\n")]
        chance = random.Random(1)
        cuts = {0, 1, ends[0] - 1, ends[-1] - 1, *chance.sample(ends, 3),
                *(chance.randrange(len(journal)) for _ in range(n_cuts))}
        for length in sorted(cuts):
            self.cut(journal, length)
            resumed = self.run_program("--resume", JOURNAL, *arguments, status=status)
            self.assert_same(resumed.out, whole.out, f"{arguments}, cut at {length}")
            self.assert_same(resumed.err, whole.err, f"errors of {arguments}, cut at {length}")
            self.assert_same(self.read(JOURNAL), journal, f"journal of {arguments}, cut at {length}")

    def test_text(self):
        self.pack(8, 40)
        self.check("packed")

    def test_json(self):
        self.pack(8, 40)
        self.check("--json", "-p", "packed")

    def test_summary_with_an_unreadable_file(self):
        self.copy("fold")
        self.write("fold/broken.mesh", program.NO_MESH)
        self.check("--summary", "fold", status=program.TROUBLE)

    def test_goodness_and_separation(self):
        self.copy("gap")
        self.check("-g", "100,0,0", "-s", "--search-cone", "70", "gap", n_cuts=4)

    def test_bad_mesh(self):
        self.copy("gap")
        self.write("gap/sheet.mesh", program.SHEET)
        self.check("gap", n_cuts=4)
        (self.folder / JOURNAL).unlink()
        self.check("--force", "gap", n_cuts=4)

    def test_files_that_are_no_set(self):
        self.copy("gap")
        self.check("-a", "gap/post.mesh", "nowhere.mesh", "gap/block.mesh", n_cuts=4, status=program.TROUBLE)

    def test_damage_before_the_end_is_told_and_nothing_is_written(self):
        self.copy("gap")
        self.journal("gap")
        damaged = self.read(JOURNAL).replace(b'"faces": 12', b'"faces": twelve', 1)
        self.cut(damaged, len(damaged))
        said = self.run_program("--resume", JOURNAL, "gap", status=program.TROUBLE)
        self.assertIn(f"{JOURNAL}:1: not JSON", said.errors)
        self.assertEqual(self.read(JOURNAL), damaged)


class Killed(Resume):
    """kill -9, at a moment that the growing journal tells."""

    def setUp(self):
        super().setUp()
        self.pack(16, 300)
        self.whole = self.run_program("--json", "--ndjson=whole.ndjson", "packed").out
        self.full = self.read("whole.ndjson")
        self.chance = random.Random()

    def kill_at(self, n_bytes, *arguments):
        """Whether it was killed before it was done."""
        process = self.start("--json", "packed", *arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        journal = self.folder / JOURNAL
        while process.poll() is None and not (journal.exists() and journal.stat().st_size >= n_bytes):
            time.sleep(0.0005)
        process.kill()
        return process.wait(timeout=60) == -signal.SIGKILL

    def check_resumed(self, what):
        resumed = self.run_program("--json", "--resume", JOURNAL, "packed").out
        self.assert_same(resumed, self.whole, what)
        self.assert_same(self.read(JOURNAL), self.full, f"journal, {what}")

    def test_once(self):
        n_killed = 0
        for _ in range(6):
            n_bytes = self.chance.randrange(len(self.full))
            n_killed += self.kill_at(n_bytes, f"--ndjson={JOURNAL}")
            self.check_resumed(f"killed at {n_bytes} bytes")
            (self.folder / JOURNAL).unlink()
        self.assertGreater(n_killed, 0)

    def test_again_and_again(self):
        (self.folder / JOURNAL).touch()
        moments = sorted(self.chance.randrange(len(self.full)) for _ in range(5))
        for n_bytes in moments:
            self.kill_at(n_bytes, "--resume", JOURNAL)
        self.check_resumed(f"killed at {moments} bytes")

    def test_pictures_are_drawn_all_the_same(self):
        self.kill_at(len(self.full) // 2, f"--ndjson={JOURNAL}", "--separation-ply=pictures")
        self.run_program("--json=report.json", "--resume", JOURNAL, "--separation-ply=pictures", "packed")
        self.assert_same(self.read("report.json"), self.whole, "report")
        self.assertEqual(len(list((self.folder / "pictures").glob("*.ply"))), 16)


class Changed(Resume):
    """Only what is still true of the files is taken from a journal."""

    def setUp(self):
        super().setUp()
        self.copy("nest")
        self.before = self.journal("nest")
        self.old_lines = self.lines(JOURNAL)

    def check(self, *arguments, status=program.DONE):
        """Resumes; what is then said, and the journal, must be as of a run of its own."""
        want = self.run_program("--ndjson=fresh.ndjson", *arguments, status=status)
        got = self.run_program("--resume", JOURNAL, *arguments, status=status)
        self.assert_same(got.out, want.out, "report")
        self.assert_same(b"\n".join(sorted(self.read(JOURNAL).splitlines())),
                         b"\n".join(sorted(self.read("fresh.ndjson").splitlines())), "lines of the journal")

    def kept(self):
        """The files whose lines were not made anew: those of the resumed journal come first."""
        return [line["path"] for line in self.lines(JOURNAL) if line["kind"] == "mesh"]

    def test_file_that_was_added(self):
        self.write("nest/a_sheet.mesh", program.SHEET)
        self.check("nest")
        self.assertEqual(self.kept()[-1], "nest/a_sheet.mesh", "only this one is new")

    def test_file_that_was_removed(self):
        (self.folder / "nest/hollow.mesh").unlink()
        self.check("nest")

    def test_file_of_another_content(self):
        ledge = self.read("nest/ledge.mesh").decode()
        self.write("nest/guest.mesh", ledge)
        os.utime(self.folder / "nest/guest.mesh", (1, 1))
        self.check("nest")
        self.assertEqual(self.kept()[-1], "nest/guest.mesh", "only this one was done again")

    def test_file_of_another_time(self):
        os.utime(self.folder / "nest/inner.mesh", ns=(1, 1))
        self.check("nest")
        self.assertEqual(self.kept()[-1], "nest/inner.mesh", "only this one was done again")

    def test_file_that_cannot_be_read_any_more(self):
        self.write("nest/ledge.mesh", program.NO_MESH)
        self.check("nest", status=program.TROUBLE)

    def test_file_that_can_be_read_again(self):
        whole = self.read("nest/ledge.mesh").decode()
        self.write("nest/ledge.mesh", program.NO_MESH)
        (self.folder / JOURNAL).unlink()
        self.journal("nest", status=program.TROUBLE)
        self.write("nest/ledge.mesh", whole)
        self.check("nest")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_file_that_may_be_read_again(self):
        (self.folder / "nest/ledge.mesh").chmod(0)
        (self.folder / JOURNAL).unlink()
        self.journal("nest", status=program.TROUBLE)
        (self.folder / "nest/ledge.mesh").chmod(0o644)
        self.check("nest")

    def test_other_options_reuse_nothing(self):
        for options in (("-i",), ("-s",), ("-p",), ("-e", "200"), ("--curvature",), ("-s", "--search-radius", "1"), ("-g", "100,0,0"), ("-a",)):
            self.check(*options, "nest")
            self.assertTrue(all(line["asked"] != self.old_lines[0]["asked"] for line in self.lines(JOURNAL)))

    def test_other_ways_to_tell_reuse_everything(self):
        journal = self.read(JOURNAL)
        for options in (("--summary",), ("--json",), ("--threads", "1"), ("--memory-limit", "1K")):
            self.run_program(*options, "--resume", JOURNAL, "nest")
            self.assert_same(self.read(JOURNAL), journal, f"journal after {options}")

    def test_known_lines_are_believed(self):
        """Were anything of an unchanged set found anew, the mark would not be in the report."""
        marked = self.read(JOURNAL).replace(b'"ledge.mesh", 1, "outer.mesh", 1, "coplanar-overlap"',
                                            b'"ledge.mesh", 1, "outer.mesh", 1, "fold-over"')
        self.assertNotEqual(marked, self.read(JOURNAL))
        self.cut(marked, len(marked))
        self.assertIn(b"fold-over", self.run_program("--resume", JOURNAL, "nest").out)

    def test_journal_named_for_output_is_gone_on_with(self):
        journal = self.read(JOURNAL)
        self.cut(journal, len(journal) // 2)
        self.assert_same(self.journal("nest").out, self.before.out, "report")
        self.assert_same(self.read(JOURNAL), journal, "journal")

    def test_resumed_into_another_journal(self):
        journal = self.read(JOURNAL)
        half = journal[:len(journal) // 2]
        self.cut(half, len(half))
        self.run_program("--resume", JOURNAL, "--ndjson=other.ndjson", "nest")
        self.assert_same(self.read("other.ndjson"), journal, "the other journal")
        self.assertEqual(self.read(JOURNAL), half)
        said = self.run_program("--resume", JOURNAL, "--ndjson", "nest")
        self.assert_same(said.out, journal, "standard output")

    def test_resumed_into_a_journal_with_lines_of_its_own(self):
        whole = sorted(self.lines(JOURNAL), key=str)
        lines = self.read(JOURNAL).splitlines(keepends=True)
        self.write(JOURNAL, b"".join(lines[1::2]).decode())
        self.write("other.ndjson", b"".join(lines[0::2]).decode())
        said = self.run_program("--resume", JOURNAL, "--ndjson=other.ndjson", "nest")
        self.assert_same(said.out, self.before.out, "report")
        self.assertEqual(sorted(self.lines("other.ndjson"), key=str), whole)

    def test_journal_of_a_part_is_gone_on_with_by_the_whole(self):
        (self.folder / JOURNAL).unlink()
        self.journal("--shard", "2/3", "nest")
        self.check("nest")

    def test_empty_journal(self):
        self.write(JOURNAL, "")
        self.assert_same(self.run_program("--resume", JOURNAL, "nest").out, self.before.out, "report")


class Overwritten(Resume):
    """No journal is written over a file that the run reads."""

    def setUp(self):
        super().setUp()
        shutil.copy(program.MESHES / "cube.mesh", self.folder)
        self.journal("cube.mesh")

    def check(self, name, *arguments):
        before = self.read(name)
        said = self.run_program(*arguments, status=program.USAGE)
        self.assertIn(f"{name} would be written, but it is an input, which never changes", said.errors)
        self.assertEqual(self.read(name), before)

    def test_mesh_that_is_to_be_the_journal(self):
        self.check("cube.mesh", "--resume", JOURNAL, "--ndjson=cube.mesh", "cube.mesh")
        self.check("cube.mesh", "--ndjson=cube.mesh", "cube.mesh")

    def test_empty_mesh_that_is_to_be_the_journal(self):
        self.write("empty.mesh", "")
        self.check("empty.mesh", "--ndjson=empty.mesh", "empty.mesh")

    def test_journal_that_is_to_be_the_report(self):
        self.check(JOURNAL, "--resume", JOURNAL, "--ndjson=other.ndjson", f"--json={JOURNAL}", "cube.mesh")

    def test_journal_that_is_merged(self):
        self.check(JOURNAL, "merge", f"--json={JOURNAL}", JOURNAL)

    def test_mesh_of_a_journal_that_is_merged(self):
        self.check("cube.mesh", "merge", "--json=cube.mesh", JOURNAL)


class NoJournal(Resume):
    """A file that is no journal is left alone."""

    def check(self, content):
        self.copy("set")
        (self.folder / "precious").write_bytes(content)
        self.write("set/empty", "")
        for arguments in (("--resume", "precious"), ("--ndjson=precious",), ("--resume", "set/empty", "--ndjson=precious")):
            said = self.run_program(*arguments, "set", status=program.TROUBLE)
            self.assertIn("precious:", said.errors)
            self.assertEqual(said.out, b"")
            self.assertEqual(self.read("precious"), content)
        self.program_leaves_no_litter()

    def program_leaves_no_litter(self):
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["precious", "set"])

    def test_text(self):
        self.check(b"Dear diary,\nnothing happened.\n")

    def test_text_without_a_line_feed(self):
        self.check(b"Dear diary, nothing happened.")

    def test_bytes(self):
        self.check(bytes(range(256)))

    def test_other_json(self):
        self.check(b'{"name": "Ada", "number": 1}\n')

    def test_report(self):
        self.copy("gap")
        report = self.run_program("--json", "gap").out
        shutil.rmtree(self.folder / "gap")
        self.check(report)

    def test_journal_of_an_earlier_version(self):
        self.check(b'{"number": 0, "of": 1, "kind": "unreadable", "bytes": 1, "modified": 1, "asked": "0.1.0 set ", '
                   b'"set": "1f", "path": "set/a.mesh", "error": "torn"}\n')

    def test_journal_of_another_version(self):
        self.copy("gap")
        self.journal("gap")
        journal = self.read(JOURNAL).replace(b'"version": "', b'"version": "9.')
        shutil.rmtree(self.folder / "gap")
        (self.folder / JOURNAL).unlink()
        self.check(journal)

    def test_standard_input_has_no_journal(self):
        said = self.run_program(f"--ndjson={JOURNAL}", "-", status=program.USAGE)
        self.assertIn("standard input", said.errors)
        self.assertFalse((self.folder / JOURNAL).exists())

    def test_device_that_is_full(self):
        self.copy("set")
        said = self.run_program("--ndjson=/dev/full", "set", status=program.TROUBLE)
        self.assertEqual(said.errors, "/dev/full: cannot be written: No space left on device\n")

    def test_device(self):
        self.copy("set")
        said = self.run_program("--ndjson=/dev/null", "set").out
        self.assert_same(said, self.run_program("set").out, "report")


if __name__ == "__main__":
    unittest.main()
