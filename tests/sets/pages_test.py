"""--html writes a page a mesh and an index, whatever the files are."""

import re
import subprocess
import unittest

import program

TRIANGLE = "Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 0 1 0\n"


class Pages(program.SetTest):
    def page(self, name):
        return self.read(name).decode()

    def test_index_leads_to_the_page_of_each_mesh(self):
        self.copy("gap")
        self.run_program("--html", "all.html", "gap")
        links = re.findall(r'href="(all_pages/[^"]+)"', self.page("all.html"))
        self.assertEqual(len(set(links)), len(list((self.folder / "gap").glob("*.mesh"))))
        for link in links:
            self.assertIn('href="../all.html"', self.page(link))

    def test_unreadable_file_stands_in_the_index_with_the_reason(self):
        self.copy("gap")
        self.write("gap/broken.mesh", program.NO_MESH)
        self.run_program("--html", "all.html", "gap", status=program.TROUBLE)
        self.assertIn("gap/broken.mesh:2:", self.page("all.html"))
        self.assertFalse((self.folder / "all_pages" / "broken.html").exists())

    def test_torn_line_and_numbering_are_told_by_their_first(self):
        self.write("torn.mesh", TRIANGLE + "7 7 7\nFace 5 1 2 3\n")
        self.run_program("--html", "torn.html", "torn.mesh")
        page = self.page("torn.html")
        self.assertIn("first: line 4", page)
        self.assertIn("first offender in brackets: [5]", page)

    def test_file_without_faces_has_a_page(self):
        self.write("points.mesh", TRIANGLE)
        self.run_program("--html", "page.html", "points.mesh")
        self.assertIn("There is no face to draw", self.page("page.html"))

    def test_standard_input_has_a_page(self):
        done = subprocess.run([program.PROGRAM, "--html", "page.html", "-"], cwd=self.folder, capture_output=True,
                              input=(TRIANGLE + "Face 1 1 2 3\n").encode(), check=True)
        self.assertEqual(done.stderr, b"")
        self.assertIn("1 face", self.page("page.html"))

    def test_page_that_cannot_be_written_leaves_the_old_one(self):
        self.copy("gap")
        self.write("all.html", "old")
        self.write("all_pages", "in the way")
        said = self.run_program("--html", "all.html", "gap", status=program.TROUBLE)
        self.assertIn("all_pages", said.errors)
        self.assertEqual(self.read("all.html"), b"old")


if __name__ == "__main__":
    unittest.main()
