"""The report that is made of the journals of all parts is that of the whole run, byte for byte."""

import os
import subprocess
import unittest

import program

REPORTS = [(), ("--json",), ("--summary",)]


class Parts(program.SetTest):
    """Does the work on a set in parts."""

    def do_part(self, part, n, *arguments, status=program.DONE):
        """The name of the journal of one part."""
        journal = f"part{part}of{n}.ndjson"
        self.run_program("--quiet", "--shard", f"{part}/{n}", f"--ndjson={journal}", *arguments, status=status)
        return journal

    def do_parts(self, n, *arguments):
        """All journals, whatever the exit status of their runs is."""
        journals = []
        for part in range(1, n + 1):
            journals.append(f"part{part}of{n}.ndjson")
            process = self.start("--shard", f"{part}/{n}", f"--ndjson={journals[-1]}", *arguments,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.assertIn(process.wait(timeout=60), (program.DONE, program.NOT_GOOD, program.TROUBLE))
        return journals


class Shards(Parts):
    def check(self, *arguments, counts=(2, 3), status=program.DONE):
        """Parts, merged in any order, make each report of the whole."""
        whole = {report: self.run_program(*report, *arguments, status=status) for report in REPORTS}
        for n in counts:
            journals = self.do_parts(n, *arguments)
            for report in REPORTS:
                merged = self.run_program("merge", *report, *reversed(journals), status=status)
                self.assert_same(merged.out, whole[report].out, f"{n} parts of {arguments} {report}")
                self.assert_same(merged.err, whole[report].err, f"errors of {n} parts of {arguments} {report}")
            for journal in journals:
                (self.folder / journal).unlink()

    def test_everything(self):
        self.pack(8, 100)
        self.check("packed", counts=(1, 2, 3, 11))

    def test_everything_of_small_sets(self):
        for name in ("clash", "nest", "fold"):
            self.copy(name)
            self.check(name)

    def test_several_folders_and_a_file(self):
        for name in ("nest", "gap"):
            self.copy(name)
        self.check("-p", "nest", "gap", "gap/../nest/guest.mesh")

    def test_intersections(self):
        self.pack(8, 60)
        self.check("-i", "packed")
        self.check("-i", "-p", "-a", "packed")

    def test_separation(self):
        self.pack(8, 60)
        self.check("-s", "packed")
        self.check("-s", "-a", "--search-radius", "1", "--search-cone", "70", "--include-self", "2", "packed")

    def test_attributes(self):
        self.copy("clash")
        self.check("-a", "-p", "clash")
        self.check("-a", "clash")

    def test_goodness(self):
        self.copy("gap")
        self.check("-g", "100,0,0", "-p", "gap")
        self.check("-g=8,0,0", "-p", "-i", "-s", "gap", status=program.NOT_GOOD)

    def test_goodness_of_meshes_that_cut_each_other(self):
        self.copy("clash")
        self.check("-g", "100,0,0", "-i", "clash", status=program.NOT_GOOD)

    def test_named_elements(self):
        self.copy("gap")
        self.check("-b", "1.5", "-c=8", "-d", "181", "-f", "3", "--exact-coincidence", "gap")

    def test_bad_mesh_forbids_separation(self):
        self.copy("gap")
        self.write("gap/sheet.mesh", program.SHEET)
        self.check("gap")
        self.check("-s", "gap")
        self.check("-s", "-i", "-a", "gap")

    def test_bad_mesh_by_force(self):
        self.copy("gap")
        self.write("gap/sheet.mesh", program.SHEET)
        self.check("-s", "--force", "gap")

    def test_unreadable_file(self):
        self.copy("nest")
        self.write("nest/broken.mesh", program.NO_MESH)
        self.check("nest", status=program.TROUBLE)
        self.check("-i", "-s", "--force", "-g", "100,0,0", "nest", status=program.TROUBLE)

    def test_files_that_are_no_set(self):
        self.copy("gap")
        self.check("-p", "gap/post.mesh", "gap/block.mesh", "nowhere.mesh", "gap/wedge.mesh", status=program.TROUBLE)

    def test_file_names_of_any_kind(self):
        (self.folder / "odd").mkdir()
        cube = (program.MESHES / "cube.mesh").read_bytes()
        for name in (b"a b.mesh", b'quote".mesh', b"latin1 \xe9.mesh", "utf8 \u00e9.mesh".encode(), b"--tab\t.mesh"):
            with open(os.fsencode(self.folder / "odd") + b"/" + name, "wb") as file:
                file.write(cube)
        self.check("odd")

    def test_journal_of_the_whole(self):
        self.copy("nest")
        whole = self.run_program("nest").out
        said = self.run_program("--ndjson=whole.ndjson", "nest").out
        self.assert_same(said, whole, "report beside a journal")
        self.assert_same(self.run_program("merge", "whole.ndjson").out, whole, "merged")

    def test_meshes_without_faces(self):
        (self.folder / "thin").mkdir()
        for name in ("point_cloud.ply", "one_face.mesh", "tetrahedron.mesh"):
            (self.folder / "thin" / name).write_bytes((program.MESHES / name).read_bytes())
        self.check("thin", counts=(2, 3, 4))
        self.check("--force", "-s", "thin")

    def test_lonely_mesh(self):
        (self.folder / "lonely").mkdir()
        (self.folder / "lonely/cube.mesh").write_bytes((program.MESHES / "cube.mesh").read_bytes())
        self.check("lonely")

    def test_part_that_is_given_twice(self):
        self.copy("nest")
        whole = self.run_program("nest").out
        first, second = self.do_parts(2, "nest")
        self.assert_same(self.run_program("merge", first, second, first).out, whole, "merged")

    def test_memory_and_threads_do_not_matter(self):
        self.pack(8, 100)
        whole = self.run_program("--json", "packed").out
        journals = self.do_parts(3, "--memory-limit", "1K", "--threads", "2", "packed")
        merged = self.run_program("merge", "--json", "--memory-limit", "1K", "--threads", "2", *journals).out
        self.assert_same(merged, whole, "merged")

    def test_resumed_part(self):
        self.pack(8, 100)
        whole = self.run_program("packed").out
        journals = self.do_parts(2, "packed")
        first = self.read(journals[0])
        (self.folder / journals[0]).write_bytes(first[:len(first) * 2 // 3])
        self.do_part(1, 2, "packed")
        self.assert_same(self.read(journals[0]), first, "the resumed journal")
        self.assert_same(self.run_program("merge", *journals).out, whole, "merged")


class Refusals(Parts):
    """What merge does not make a report of."""

    def refused(self, *journals):
        """Why there is no report."""
        said = self.run_program("merge", "--json=merged.json", *journals, status=program.TROUBLE)
        self.assertFalse((self.folder / "merged.json").exists())
        return said.errors

    def setUp(self):
        super().setUp()
        self.copy("clash")

    def test_missing_part(self):
        journals = self.do_parts(3, "clash")
        for absent in journals:
            present = [journal for journal in journals if journal != absent]
            self.assertIn("a part is missing, or not complete", self.refused(*present))

    def test_part_without_what_is_between(self):
        journals = self.do_parts(2, "clash")
        kept = [line for line in self.read(journals[1]).splitlines(True) if b'"kind": "between"' not in line]
        self.write(journals[1], b"".join(kept).decode())
        self.assertIn("is a part missing?", self.refused(*journals))

    def test_other_options(self):
        first = self.do_part(1, 2, "clash")
        second = self.do_part(2, 2, "-i", "clash")
        errors = self.refused(first, second)
        self.assertIn(f"{second}:1:", errors)
        self.assertRegex(errors, r'was asked {.*"intersections": true}}, and lines before {.*"separation": {}}}')

    def test_other_files(self):
        first = self.do_part(1, 2, "clash")
        (self.folder / "clash/spike.mesh").unlink()
        second = self.do_part(2, 2, "clash")
        self.assertIn("of other files than the lines before", self.refused(first, second))

    def test_file_that_changed_between_the_parts(self):
        first = self.do_part(1, 2, "clash")
        os.utime(self.folder / "clash/spike.mesh", (1, 1))
        second = self.do_part(2, 2, "clash")
        self.assertIn("of files that changed", self.refused(first, second))

    def test_file_that_changed_after_the_parts(self):
        journals = self.do_parts(2, "clash")
        os.utime(self.folder / "clash/spike.mesh", (1, 1))
        self.assertIn("clash/spike.mesh: is not there, or has changed since its line was written",
                      self.refused(*journals))

    def test_file_that_went_away(self):
        journals = self.do_parts(2, "clash")
        (self.folder / "clash/spike.mesh").unlink()
        self.assertIn("clash/spike.mesh: is not there", self.refused(*journals))

    def test_torn_journal(self):
        journals = self.do_parts(2, "clash")
        whole = self.read(journals[1])
        for kept in (len(whole) - 1, len(whole) // 2, whole.index(b"\n"), 0):
            (self.folder / journals[1]).write_bytes(whole[:kept])
            self.assertRegex(self.refused(*journals), "missing")

    def test_damaged_journal(self):
        journals = self.do_parts(2, "clash")
        whole = self.read(journals[1])
        (self.folder / journals[1]).write_bytes(whole.replace(b'"faces": 12', b'"faces": twelve', 1))
        self.assertIn(f"{journals[1]}:1: not JSON", self.refused(*journals))

    def test_journal_that_is_not_there(self):
        self.assertIn("nowhere.ndjson: cannot be opened", self.refused("nowhere.ndjson"))

    def test_what_is_no_journal(self):
        self.write("notes.txt", "Remember the milk.\n")
        self.assertIn("notes.txt:1: not the beginning of a line of a journal", self.refused("notes.txt"))


if __name__ == "__main__":
    unittest.main()
