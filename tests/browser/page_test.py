"""The pages of the programs in a real browser: page_test.py MESHALYZER MESHFIXER MESHES."""

import argparse
import os
import shutil
import sys
import tempfile
import time
import unittest

from page_case import ESCAPE, PageCase
from pages import Pages, Surface, values_of
from png import read_png
from view_cases import Choosing, Drawing, Keys, Legend, Lines
from webdriver import WITHOUT_WEBGL, Driver

CONTRASTS = """
  const style = getComputedStyle(document.documentElement);
  const luminance = (name) => {
    const probe = document.createElement('i');
    probe.style.color = style.getPropertyValue(name);
    document.body.append(probe);
    const channels = getComputedStyle(probe).color.match(/[\\d.]+/g).slice(0, 3).map((c) => c / 255);
    probe.remove();
    const [r, g, b] = channels.map((c) => c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  return arguments[0].map(([text, ground]) => {
    const [a, b] = [luminance(text), luminance(ground)];
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  });
"""


class Page(PageCase):
    PAIRS = [["--ink", "--paper"], ["--ink", "--card"], ["--ink-soft", "--paper"], ["--ink-soft", "--card"],
             ["--accent", "--paper"], ["--accent", "--card"], ["--accent", "--accent-paper"],
             ["--ink", "--accent-paper"], ["--ink-soft", "--accent-paper"], ["--paper", "--ink"],
             ["--good", "--good-paper"], ["--good", "--paper"], ["--bad", "--bad-paper"], ["--bad", "--paper"]]

    def ground(self):
        return self.pixels([[2, self.canvas_size()[1] - 3]])[0]

    def test_it_is_light_or_dark_as_the_system_wishes_and_as_the_switch_says(self):
        self.session.devtools("Emulation.setEmulatedMedia",
                              features=[{"name": "prefers-color-scheme", "value": "dark"}])
        self.open(self.pages.mesh("cube.obj"))
        self.session.run("localStorage.clear(); delete document.documentElement.dataset.theme")
        self.assertLess(max(self.ground()), 80)
        self.assertGreaterEqual(min(self.session.run(CONTRASTS, self.PAIRS)), 4.5)
        self.session.click(".theme")
        self.assertGreater(min(self.ground()), 200)
        self.assertGreaterEqual(min(self.session.run(CONTRASTS, self.PAIRS)), 4.5)
        self.open(self.pages.mesh("cube.obj"))
        self.assertGreater(min(self.ground()), 200, "the switch is remembered")
        self.session.run("localStorage.clear()")

    def test_a_union_that_is_not_written_is_called_the_result(self):
        self.open(self.pages.union("cube.mesh", "torus.mesh"))
        self.assertEqual(self.session.text("h1"), "the result")

    def test_a_repair_is_seen_before_and_after(self):
        self.open(self.pages.repair("cube_with_hole.mesh"))
        before, after = self.data["scenes"]
        buttons = self.session.run("return Array.from(document.querySelectorAll('#scene-choice button'), (b) => b.textContent)")
        self.assertEqual([text.lower() for text in buttons], [before["title"], after["title"]])
        self.assertLess(before["faces"], after["faces"])
        self.session.run("meshView.lookFrom([0.3, 0.2, 1])")
        was = self.canvas_png(), self.project(Surface(before["detail"]).points[0])
        self.session.click("#scene-choice button:nth-child(2)")
        place = [x / before["scale"] + c for x, c in zip(Surface(before["detail"]).points[0], before["centre"])]
        again = self.project([(x - c) * after["scale"] for x, c in zip(place, after["centre"])])
        for now, then in zip(again, was[1]):
            self.assertAlmostEqual(now, then, delta=0.5, msg="the same place of the file stays in sight")
        self.session.run("meshView.select(0, 0)")
        self.assertEqual(self.session.run("return meshView.selected()"), {"scene": 0, "highlight": 0})

    def test_a_change_is_seen_where_it_was_and_what_came_of_it(self):
        self.open(self.pages.repair("crossing_cubes.mesh"))
        for scene in (0, 1):
            self.session.click(f"#changes button[data-scene='{scene}']")
            chosen = self.session.run("return meshView.selected()")
            self.assertEqual(chosen["scene"], scene)
            change = self.data["scenes"][scene]["highlights"][chosen["highlight"]]
            self.assertEqual(change["code"], "cut intersections")
            self.assertIn(change["text"], self.session.run("return document.getElementById('chosen-text').textContent"))
        self.assertIn("a seam of 14 edges", change["text"])

    def test_a_repair_is_coloured_by_its_deviation(self):
        self.open(self.pages.repair("crossing_cubes.mesh"))
        deviations = []
        for scene in self.data["scenes"]:
            field = next(field for field in scene["fields"] if field["name"] == "deviation")
            ids = Surface(scene["detail"]).vertex_ids
            deviations.append(dict(zip(ids, values_of(field, scene["detail"]))))
        # Of the corners of the cubes only 7 and 9 are inside the other cube, each 0.125 below the faces that are nearest.
        self.assertEqual(deviations[0], {v: 0.125 if v in (7, 9) else 0 for v in range(1, 17)})
        self.assertEqual(set(deviations[1].values()), {0})
        self.session.run("meshView.setField('deviation')")
        self.assertIn("Deviation d", self.session.text(".legend-title"))

    def test_an_index_leads_to_the_pages_and_back(self):
        index = self.pages.index("clash", "-i", "-s")
        self.open_plain(index)
        self.assertIn("Not good", self.session.text(".verdict"))
        names = self.session.run("return Array.from(document.querySelectorAll('#meshes a'), (a) => a.href)")
        self.assertEqual([name.rsplit("/", 1)[1] for name in names],
                         [f"{path.stem}.html" for path in sorted((self.pages.meshes / "clash").glob("*.mesh"))])
        for address in names:
            self.opened.append(address)
            self.session.open(address)
            self.session.wait("return window.meshView && meshView.ready")
            self.session.click("nav a")
            self.assertEqual(self.session.url(), index.resolve().as_uri())

    def test_an_index_tells_at_once_what_is_with_each_mesh(self):
        self.open_plain(self.pages.index("clash", "-i", "-s"))
        self.session.devtools("Emulation.setDeviceMetricsOverride", width=1400, height=900, deviceScaleFactor=1, mobile=False)
        try:
            titles = self.session.run("return Array.from(document.querySelectorAll('#meshes thead th'), (th) => th.textContent.trim())")
            self.assertEqual(titles[:4], ["mesh", "verdict", "why", "defects"])
            rows = self.session.run("return Array.from(document.querySelectorAll('#meshes tbody tr'), (tr) => Array.from(tr.cells, (cell) => cell.textContent))")
            why = {row[0]: row[2] for row in rows}
            self.assertEqual(why["inside.mesh"], "inside base.mesh")
            self.assertEqual(why["apart.mesh"], "")
            self.assertIn("crossing.mesh", why["base.mesh"])
            right = self.session.run("return document.querySelector('#meshes td.why').getBoundingClientRect().right")
            self.assertLess(right, 1400)
        finally:
            self.session.devtools("Emulation.clearDeviceMetricsOverride")

    def test_an_index_is_sorted_by_a_column(self):
        self.open_plain(self.pages.index("clash", "-i", "-s"))
        areas = "return Array.from(document.querySelectorAll('#meshes tbody tr'), (tr) => Number(tr.cells[6].textContent))"
        self.session.click("#meshes thead th:nth-child(7) button")
        found = self.session.run(areas)
        self.assertIn(found, (sorted(found), sorted(found, reverse=True)))
        self.session.click("#meshes thead th:nth-child(7) button")
        self.assertEqual(self.session.run(areas), found[::-1])

    def test_a_picture_is_saved_with_its_legend(self):
        self.open(self.pages.mesh("torus.obj"))
        self.session.choose("#choose-field", "valence")
        folder = self.session.downloads
        self.session.devtools("Browser.setDownloadBehavior", behavior="allow", downloadPath=folder)
        self.session.click("#view-save")
        file = os.path.join(folder, "torus.obj.png")
        end = time.monotonic() + 60
        while not os.path.exists(file) and time.monotonic() < end:
            time.sleep(0.05)
        with open(file, "rb") as picture:
            width, height, rows = read_png(picture.read())
        self.assertEqual(width, self.canvas_size()[0])
        self.assertGreater(height, self.canvas_size()[1] + 30)
        self.assertGreater(len(set(rows[self.canvas_size()[1] + 40])), 30, "the bar of the legend")
        self.session.requests()

    def test_print_opens_everything_and_puts_it_back(self):
        self.open(self.pages.mesh("torus.obj"))
        closed = "return document.querySelectorAll('details:not([open]):not(.keys)').length"
        before = self.session.run(closed)
        self.assertGreater(before, 0)
        self.session.run("window.dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.session.run(closed), 0)
        self.assertEqual(self.ground_as_it_is(), (255, 255, 255))
        self.session.run("window.dispatchEvent(new Event('afterprint'))")
        self.assertEqual(self.session.run(closed), before)
        self.assertGreater(len(self.session.devtools("Page.printToPDF", printBackground=False)["data"]), 10000)

    def ground_as_it_is(self):
        return self.pixels([[2, 3]])[0]

    def test_definitions_come_with_the_focus_and_go_with_escape(self):
        self.open(self.pages.mesh("cube.obj"))
        visible = "return getComputedStyle(document.querySelector('#attributes .definition')).visibility"
        self.assertEqual(self.session.run(visible), "hidden")
        self.session.run("document.querySelector('#attributes .term').focus()")
        self.session.wait(visible + " === 'visible'")
        self.session.press(ESCAPE)
        self.session.wait(visible + " === 'hidden'")

    def test_headings_go_down_a_level_at_a_time(self):
        for page in (self.pages.mesh("crossing_cubes.mesh"), self.pages.repair("cube_with_hole.mesh"), self.pages.index("clash", "-i", "-s")):
            with self.subTest(page.name):
                self.open_plain(page)
                levels = self.session.run("return Array.from(document.querySelectorAll('h1, h2, h3, h4'), (h) => Number(h.tagName[1]))")
                self.assertEqual(levels[0], 1)
                self.assertEqual(levels.count(1), 1)
                self.assertTrue(all(after <= before + 1 for before, after in zip(levels, levels[1:])), levels)

    def test_every_control_has_a_name_and_every_id_is_one(self):
        self.open(self.pages.mesh("cube_with_hole.mesh"))
        nameless = self.session.run("""
          return Array.from(document.querySelectorAll('button, select, input, canvas, svg'))
            .filter((e) => !(e.textContent.trim() && e.tagName === 'BUTTON') && !e.getAttribute('aria-label') &&
                           !(e.labels && e.labels.length))
            .map((e) => e.outerHTML.slice(0, 80));""")
        self.assertEqual(nameless, [])
        twice = self.session.run("""
          const ids = Array.from(document.querySelectorAll('[id]'), (e) => e.id);
          return ids.filter((id, i) => ids.indexOf(id) !== i);""")
        self.assertEqual(twice, [])

    def be_narrow(self):
        self.session.devtools("Emulation.setDeviceMetricsOverride", width=360, height=700, deviceScaleFactor=1, mobile=False)
        self.addCleanup(self.session.devtools, "Emulation.clearDeviceMetricsOverride")
        self.session.wait("return window.innerWidth === 360")

    def test_a_narrow_page_does_not_scroll_sideways(self):
        pages = [self.pages.mesh("cube_with_hole.mesh"), self.pages.mesh_far_down("crossing_cubes.mesh"),
                 self.pages.repair("cube_with_hole.mesh"), self.pages.index("clash", "-i", "-s")]
        self.be_narrow()
        for page in pages:
            with self.subTest(page.name):
                self.open_plain(page)
                self.assertLessEqual(self.session.run("return document.documentElement.scrollWidth"), 360)

    def test_a_defect_is_seen_where_the_list_is_below_the_view(self):
        self.be_narrow()
        self.open(self.pages.mesh("cube_with_hole.mesh"))
        self.session.run("document.querySelector('button.defect').scrollIntoView({block: 'start'})")
        top = "return document.getElementById('view-canvas').getBoundingClientRect().top"
        self.assertLess(self.session.run(top), -100)
        self.session.click("button.defect")
        self.assertGreaterEqual(self.session.run(top), -1)


class WithoutWebgl(PageCase):
    def test_the_page_reads(self):
        self.open_plain(self.pages.mesh("cube_with_hole.mesh"))
        self.assertIn("WebGL", self.session.text("#view-off"))
        self.assertEqual(self.session.text("#viewer"), "")
        self.assertIn("Not good", self.session.text(".verdict"))
        self.assertTrue(self.session.text("button.defect"))
        self.assertTrue(self.session.run("return document.querySelector('button.defect').disabled"))
        self.assertTrue(self.session.run("return !meshView.ready"))
        self.assertTrue(self.session.run("return document.querySelector('#defects .hint').hidden"))
        self.session.click(".theme")
        self.session.run("localStorage.clear()")


class WithoutScripts(PageCase):
    def setUp(self):
        super().setUp()
        self.session.devtools("Emulation.setScriptExecutionDisabled", value=True)
        self.addCleanup(self.session.devtools, "Emulation.setScriptExecutionDisabled", value=False)

    def test_the_page_reads(self):
        self.open_plain(self.pages.mesh("cube_with_hole.mesh"))
        for selector, text in ((".verdict", "Not good"), (".facts", "10 faces"), ("#view-off", "JavaScript"),
                               ("#defects", "edges"), ("#attributes", "closed"), ("#statistics", "variance")):
            self.assertIn(text, self.session.text(selector))


def run(pages, browser, chromedriver):
    """Whether all tests pass."""
    driver = Driver(chromedriver, browser)
    try:
        loader = unittest.defaultTestLoader
        is_good = True
        for cases, graphics in (((Drawing, Choosing, Lines, Keys, Legend, Page), {}), ((WithoutWebgl, WithoutScripts), {"graphics": WITHOUT_WEBGL})):
            PageCase.pages = pages
            PageCase.session = driver.session(size=(600, 560), **graphics)
            suite = unittest.TestSuite(loader.loadTestsFromTestCase(case) for case in cases)
            is_good &= unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful()
            PageCase.session.close()
        return is_good
    finally:
        driver.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("meshalyzer")
    parser.add_argument("meshfixer")
    parser.add_argument("meshes")
    parser.add_argument("--browser", default=shutil.which("chromium"))
    parser.add_argument("--chromedriver", default=shutil.which("chromedriver"))
    arguments = parser.parse_args()
    if not arguments.browser or not arguments.chromedriver:
        print("skipped: there is no Chromium with chromedriver")
        return 0
    with tempfile.TemporaryDirectory(prefix="page_test_") as folder:
        pages = Pages(arguments.meshalyzer, arguments.meshfixer, arguments.meshes, folder)
        return 0 if run(pages, arguments.browser, arguments.chromedriver) else 1


if __name__ == "__main__":
    sys.exit(main())
