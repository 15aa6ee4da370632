"""Checks the cost of many intersecting pairs: lists are cut, counts are not, memory does not grow with them, time can be limited."""

import json
import random
import resource
import unittest

import program


def tangle(n, seed=1):
    """Random triangles in the unit cube; more than a quarter of all pairs of them cross."""
    numbers = random.Random(seed)
    points = "".join(f"Vertex {v} {numbers.random()} {numbers.random()} {numbers.random()}\n" for v in range(1, 3 * n + 1))
    return points + "".join(f"Face {f + 1} {3 * f + 1} {3 * f + 2} {3 * f + 3}\n" for f in range(n))


class Bounded(program.SetTest):
    def offenders(self, *arguments):
        mesh = self.report("-p", *arguments)["meshes"][0]
        return mesh["characteristics"], mesh["offenders"]

    def test_list_holds_the_pairs_of_the_lowest_faces(self):
        self.write("a.mesh", tangle(100))
        counts, whole = self.offenders("a.mesh")
        pairs = whole["intersecting_pairs"]
        self.assertGreater(len(pairs), 1000)
        self.assertEqual(len(pairs), counts["intersecting_pairs"])
        self.assertNotIn("intersecting_pairs_unlisted", whole)
        for threads in ("1", "2", "5"):
            for n in (1, 30, 1000):
                cut_counts, cut = self.offenders("--threads", threads, "--max-list", str(n), "a.mesh")
                self.assertEqual(cut_counts, counts)
                self.assertEqual(cut["intersecting_pairs"], pairs[:n])
                self.assertEqual(cut["intersecting_pairs_unlisted"], len(pairs) - n)
        self.assertEqual(self.offenders("--max-list", "0", "a.mesh"), (counts, whole))

    def test_text_says_that_the_list_is_cut(self):
        self.write("a.mesh", tangle(20))
        n = self.report("a.mesh")["meshes"][0]["characteristics"]["intersecting_pairs"]
        text = self.run_program("-p", "--max-list", "2", "a.mesh").out.decode()
        self.assertIn(f"offending intersecting pairs: {n}, of which the first 2 are listed\n", text)
        self.assertEqual(text.count(": crossing\n"), 2)

    def between(self, *arguments):
        return self.report("-i", *arguments)["set"]

    def test_list_between_meshes_is_cut_too(self):
        (self.folder / "set").mkdir()
        for i in range(4):
            self.write(f"set/{i}.mesh", tangle(40, i))
        whole = self.between("set")
        pairs = whole["intersecting_pairs"]
        self.assertEqual(len(pairs), whole["intersecting_pair_count"])
        table = self.run_program("-i", "set").out.decode().split("one a row: all\n")[1]
        for n in (1, 50, 1000):
            for threads in ("1", "2", "5"):
                cut = self.between("--max-list", str(n), "--threads", threads, "set")
                self.assertEqual(cut["intersecting_pairs"], pairs[:n])
                self.assertEqual(cut["intersecting_pair_count"], len(pairs))
                self.assertEqual(cut["intersecting_pairs_unlisted"], len(pairs) - n)
                self.assertEqual(cut["is_good"], whole["is_good"])
            text = self.run_program("-i", "--max-list", str(n), "set").out.decode()
            self.assertEqual(text.split("one a row: all\n")[1], table)

    def test_parts_of_a_run_make_the_cut_list_of_the_whole(self):
        (self.folder / "set").mkdir()
        for i in range(4):
            self.write(f"set/{i}.mesh", tangle(30, i))
        options = ("-i", "-p", "--max-list", "40")
        whole = self.run_program("--json", *options, "set").out
        for k in ("1", "2"):
            self.run_program(*options, "--shard", f"{k}/2", f"--ndjson={k}.ndjson", "set")
        self.assert_same(self.run_program("merge", "--json", "1.ndjson", "2.ndjson").out, whole, "merged")

    def test_memory_does_not_grow_with_the_pairs(self):
        # 2.2 million pairs would take 27 MB as a list alone.
        def limit_memory():
            resource.setrlimit(resource.RLIMIT_DATA, (64 << 20, 64 << 20))

        self.write("a.mesh", tangle(4000))
        process = self.start("--json", "--threads", "1", "--max-list", "1000", "a.mesh", stdout=program.subprocess.PIPE,
                             preexec_fn=limit_memory)
        out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, program.DONE)
        self.assertGreater(json.loads(out)["meshes"][0]["characteristics"]["intersecting_pairs"], 2000000)

    def test_time_limit_ends_the_search(self):
        self.write("a.mesh", tangle(3000))
        mesh = self.report("--time-limit", "0", "-g", "1e9,0,0", "a.mesh", status=program.NOT_GOOD)["meshes"][0]
        self.assertIs(mesh["characteristics"]["intersecting_pairs_at_least"], True)
        self.assertIn("intersecting pairs of faces: at least 0, the search ended at its time limit", mesh["reasons"])
        text = self.run_program("--time-limit", "0", "a.mesh").out.decode()
        self.assertIn("intersecting pairs: at least 0 (of these unwelded: 0; the search ended at its time limit)", text)

    def test_mesh_that_is_done_in_time_is_as_without_limit(self):
        self.write("a.mesh", tangle(20))
        want = self.run_program("--json", "-p", "a.mesh").out
        self.assert_same(self.run_program("--json", "-p", "--time-limit", "1000", "a.mesh").out, want, "with a limit")

    def test_good_mesh_is_not_good_where_the_search_ended(self):
        cube = str(program.MESHES / "cube.mesh")
        self.assertEqual(self.run_program("-g", "100,5,0.1", "--time-limit", "0", cube, status=program.NOT_GOOD).out, b"0\n")
        self.assertEqual(self.run_program("-g", "100,5,0.1", "--time-limit", "1000", cube).out, b"1\n")

    def test_time_limit_between_meshes(self):
        (self.folder / "set").mkdir()
        for i in range(3):
            self.write(f"set/{i}.mesh", tangle(20, i))
        of_set = self.between("--time-limit", "0", "set")
        self.assertIs(of_set["intersecting_pairs_at_least"], True)
        self.assertIs(of_set["contained_at_least"], True)
        self.assertIs(of_set["intersecting_pairs_within_at_least"], True)
        self.assertIs(of_set["is_good"], False)

    def test_nothing_that_a_time_limit_cut_is_told_as_exact(self):
        self.copy("nest")
        self.write("nest/two.mesh", tangle(3))
        text = self.run_program("-i", "--time-limit", "0", "--html", "all.html", "nest").out.decode().splitlines()
        for line in ("total intersecting pairs within meshes: at least 0",
                     "intersecting pairs between meshes: at least 0 (the search ended at its time limit)",
                     "pairs of meshes that intersect: at least 0", "contained meshes: at least 0",
                     "partly contained meshes: at least 0"):
            self.assertIn(line, text)
        self.assertTrue(any(line.endswith("  intersecting pairs (at least)") for line in text), text)
        page = self.read("all.html").decode()
        self.assertGreaterEqual(page.count("<td>at least 0</td>"), 4)
        whole = self.between("nest")
        self.assertEqual([key for key in whole if key.endswith("_at_least")], [])
        self.assertNotEqual(whole["contained"], [])


if __name__ == "__main__":
    unittest.main()
