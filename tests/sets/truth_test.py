"""Checks that the findings between the meshes of the sets in meshes/ are those of their expected_sets.json."""

import json
import math
import unittest

import program

TRUTH = json.loads((program.MESHES / "expected_sets.json").read_text())


class Truth(program.SetTest):
    def setUp(self):
        super().setUp()
        self.sets = {name: self.report("-p", str(program.MESHES / name))["set"] for name in TRUTH}

    def assert_near(self, got, want, what):
        self.assertTrue(math.isclose(got, want, rel_tol=1e-12, abs_tol=1e-12), f"{what} is {got}, not {want}")

    def test_totals(self):
        for name, truth in TRUTH.items():
            for key in ("meshes", "vertices", "faces"):
                self.assertEqual(self.sets[name][key], truth[key], f"{name}: {key}")
            for key in ("area", "volume"):
                self.assert_near(self.sets[name][key], truth[key], f"{name}: {key}")
            self.assertEqual(self.sets[name]["good"], truth["meshes"], name)

    def test_statistics_are_of_all_faces(self):
        for name in TRUTH:
            report = self.report(str(program.MESHES / name))
            for key in ("vertex_valence", "face_area", "aspect_ratio", "corner_angle", "edge_length", "edge_angle"):
                parts = [mesh["characteristics"][key] for mesh in report["meshes"]]
                whole = report["set"][key]
                count = sum(part["count"] for part in parts)
                mean = sum(part["count"] * part["mean"] for part in parts) / count
                squares = sum((part["count"] - 1) * part["variance"] + part["count"] * (part["mean"] - mean) ** 2
                              for part in parts)
                self.assertEqual(whole["count"], count, f"{name}: {key}")
                self.assertEqual(whole["min"], min(part["min"] for part in parts), f"{name}: {key}")
                self.assertEqual(whole["max"], max(part["max"] for part in parts), f"{name}: {key}")
                self.assert_near(whole["mean"], mean, f"{name}: mean of {key}")
                self.assert_near(whole["variance"], squares / (count - 1), f"{name}: variance of {key}")
                self.assertEqual(sum(whole["histogram"]["counts"]), count, f"{name}: {key}")

    def test_intersections(self):
        for name, truth in TRUTH.items():
            self.assertEqual(self.sets[name]["intersecting_pairs"], truth["intersecting_pairs"], name)
            self.assertEqual(self.sets[name]["intersecting_pair_count"], len(truth["intersecting_pairs"]), name)
            self.assertEqual(self.sets[name]["contained"], truth["contained"], name)
        self.assertEqual(self.sets["nest"]["partly_contained"], [["half_in.mesh", "outer.mesh"]])

    def test_text_names_the_same_pairs(self):
        for name, truth in TRUTH.items():
            text = self.run_program("-a", "-i", "-p", str(program.MESHES / name)).out.decode()
            pairs = [line for line in text.splitlines() if " face " in line]
            want = [f"{a} face {f}, {b} face {g}: {kind}" for a, f, b, g, kind in truth["intersecting_pairs"]]
            self.assertEqual(pairs, want, name)

    def test_set_is_good_where_nothing_meets(self):
        for name, truth in TRUTH.items():
            apart = not truth["intersecting_pairs"] and not truth["contained"]
            self.assertIs(self.sets[name]["is_good"], apart, name)

    def test_separation(self):
        for name, truth in TRUTH.items():
            for mesh, distances in truth["separation"].items():
                rows = self.sets[name]["closest"][mesh]
                self.assertEqual([row[0] for row in rows], [vertex for vertex, _ in distances], f"{name}/{mesh}")
                for row, (vertex, distance) in zip(rows, distances):
                    self.assert_near(row[1], distance, f"{name}/{mesh}: separation of vertex {vertex}")

    def test_statistics_of_separation(self):
        for name, truth in TRUTH.items():
            everything = [d for distances in truth["separation"].values() for _, d in distances]
            self.check_statistics(self.sets[name]["separation_all"], everything, name)
            for mesh, distances in truth["separation"].items():
                self.check_statistics(self.sets[name]["separation"][mesh], [d for _, d in distances],
                                      f"{name}/{mesh}")
            self.assertEqual(self.sets[name]["separation_inside_count"], sum(d < 0.0 for d in everything), name)

    def check_statistics(self, got, values, what):
        self.assertEqual(got["count"], len(values), what)
        self.assert_near(got["min"], min(values), f"{what}: min")
        self.assert_near(got["max"], max(values), f"{what}: max")
        self.assert_near(got["mean"], sum(values) / len(values), f"{what}: mean")

    def test_width_of_a_fold(self):
        fold = self.report("-s", "-a", "--include-self", "1.5", str(program.MESHES / "fold"))["set"]
        distances = {row[0]: row[1] for row in fold["closest"]["clamp.mesh"]}
        for vertex, width in TRUTH["fold"]["folds"]["clamp.mesh"]:
            self.assert_near(distances[vertex], width, f"width at vertex {vertex}")

    def test_search_radius_only_leaves_out(self):
        radius = 3.5
        near = self.report("-s", "-a", "--search-radius", str(radius), str(program.MESHES / "gap"))["set"]
        for mesh, rows in self.sets["gap"]["closest"].items():
            want = [row if row[1] <= radius else [row[0], None, None, None, None] for row in rows]
            self.assertEqual(near["closest"][mesh], want, mesh)
            self.assertEqual(near["separation_without_closest"][mesh], sum(row[1] is None for row in want), mesh)


if __name__ == "__main__":
    unittest.main()
