"""The view of a page: what is drawn, chosen, switched and told."""

import re

from page_case import ENTER, ESCAPE, FACE_COLOURS, LEFT, RIGHT, PageCase, far, rgb
from pages import Surface, middle, numbers, points, values_of
from png import read_png


def lit_places(scene, highlight):
    """Places that the highlight colours: of its faces the middles, else of its segments, else its points."""
    surface = Surface(scene["detail"])
    faces = numbers(highlight["faces"], "I")
    if faces:
        return [surface.middle(face) for face in faces]
    ends = points(highlight["segments"])
    return [middle(ends[i:i + 2]) for i in range(0, len(ends), 2)] or points(highlight["points"])


class Drawing(PageCase):
    def test_a_mesh_is_drawn(self):
        self.open(self.pages.mesh("torus.obj"))
        width, height, rows = read_png(self.canvas_png())
        ground = rows[0][0]
        drawn = {pixel for row in rows for pixel in row if far(pixel, ground) > 8}
        share = sum(far(pixel, ground) > 8 for row in rows for pixel in row) / (width * height)
        self.assertGreater(len(drawn), 50)
        self.assertGreater(share, 0.1)
        self.assertLess(share, 0.9)

    def face_colours(self, field):
        """By face that nothing hides: the colour of its middle."""
        surface = Surface(self.data["scenes"][0]["detail"])
        self.session.run("meshView.setField(arguments[0])", field)
        faces = [[face, surface.middle(face), surface.normal(face)] for face in range(len(surface.faces))]
        colours = self.session.run(FACE_COLOURS, faces)
        return {face: colour for face, colour in enumerate(colours) if colour}

    def field(self, name):
        scene = self.data["scenes"][0]
        return values_of(next(field for field in scene["fields"] if field["name"] == name), scene["detail"])

    def test_components_have_the_colours_of_their_numbers(self):
        self.open(self.pages.mesh("two_cubes.mesh"))
        palette = numbers(self.data["palettes"]["category"], "B")
        component = self.field("component")
        colours = self.face_colours("component")
        self.assertEqual({component[face] for face in colours}, {0.0, 1.0})
        for face, colour in colours.items():
            entry = 3 * int(component[face])
            self.assertLessEqual(far(colour, palette[entry:entry + 3]), 3)

    def test_defects_have_the_colours_of_their_codes(self):
        self.open(self.pages.mesh("cube_flipped_face.mesh"))
        defect = self.field("defect")
        colours = self.face_colours("defect")
        self.assertTrue(any(defect[face] > 0 for face in colours))
        self.assertTrue(any(defect[face] == 0 for face in colours))
        for face, colour in colours.items():
            if defect[face] > 0:
                code = self.data["codes"][int(defect[face]) - 1]
                self.assertLessEqual(far(colour, rgb(code["colour"])), 3)
            else:
                self.assertLess(max(colour) - min(colour), 30, "a face without defect is grey")

    def test_edges_and_normals_are_drawn_on_demand(self):
        self.open(self.pages.mesh("cube.obj"))
        surface = Surface(self.data["scenes"][0]["detail"])
        self.session.run("meshView.lookFrom([0.5, 0.4, 1])")
        edge = self.project(middle([surface.points[v] for v in surface.faces[0][:2]]))
        plain = self.canvas_png()
        self.session.click("#show-wireframe")
        with_edges = self.canvas_png()
        self.assertNotEqual(plain, with_edges)
        self.session.click("#show-wireframe")
        for box, is_colour in (("#show-face-normals", lambda r, g, b: r > 180 and g < 90 and b < 90),
                               ("#show-vertex-normals", lambda r, g, b: g > 130 and r < 90 and b < 110)):
            self.session.click(box)
            _, _, rows = read_png(self.canvas_png())
            self.assertGreater(sum(is_colour(*pixel[:3]) for row in rows for pixel in row), 60, box)
            self.session.click(box)
        self.assertEqual(self.canvas_png(), plain)
        self.assertTrue(all(coordinate > 0 for coordinate in edge))

    def test_nothing_is_drawn_while_nothing_changes(self):
        self.open(self.pages.mesh("torus.obj"))
        count = self.session.run_async("""
          const done = arguments[arguments.length - 1];
          const stage = meshPage.Stage.prototype;
          const render = stage.render;
          let count = 0;
          let frames = 0;
          stage.render = function () { ++count; render.call(this); };
          const step = () => {
            ++frames;
            if (frames === 5) count = 0;  // what was asked for when the page opened is drawn by now
            if (frames < 25) return requestAnimationFrame(step);
            stage.render = render;
            done(count);
          };
          requestAnimationFrame(step);""")
        self.assertEqual(count, 0)


class Choosing(PageCase):
    def colours_when_chosen(self, name):
        """Chooses each defect in turn; (its places' colours before, and after) a defect."""
        self.open(self.pages.mesh(name))
        scene = self.data["scenes"][0]
        self.assertTrue(scene["highlights"])
        for index, highlight in enumerate(scene["highlights"]):
            self.session.run("meshView.select(0, arguments[0])", index)
            places = [self.project(place) for place in lit_places(scene, highlight)]
            lit = self.pixels(places)
            self.assertEqual(self.session.run("return meshView.selected()"), {"scene": 0, "highlight": index})
            self.session.run("document.getElementById('view-canvas').focus()")
            self.session.press(ESCAPE)
            self.assertIsNone(self.session.run("return meshView.selected()"))
            yield self.pixels(places), lit

    def test_a_chosen_defect_is_lit_up_where_it_is(self):
        for name in ("cube_with_hole.mesh", "zero_area_face.mesh", "pinched_vertex.mesh", "crossing_cubes.mesh", "cube_flipped_face.mesh"):
            with self.subTest(name):
                for before, lit in self.colours_when_chosen(name):
                    colour = rgb(self.session.run("return meshView.highlightColour"))
                    self.assertTrue(all(far(pixel, colour) > 40 for pixel in before))
                    self.assertTrue(any(far(pixel, colour) <= 25 for pixel in lit), (lit, colour))

    def test_a_defect_of_faces_without_a_place_is_not_called_too_large(self):
        self.open(self.pages.mesh("missing_vertex.mesh"))
        highlights = self.data["scenes"][0]["highlights"]
        corrupt = next(index for index, highlight in enumerate(highlights) if highlight["code"] == "corrupt")
        self.session.run("meshView.select(0, arguments[0])", corrupt)
        text = self.session.text("#chosen-text")
        self.assertIn("not all of it can be lit up", text)
        self.assertNotIn("too large", text)

    def test_a_click_on_the_list_chooses_and_flies(self):
        self.open(self.pages.mesh("cube_with_hole.mesh"))
        button = "button.defect[data-highlight='0']"
        highlight = self.data["scenes"][0]["highlights"][0]
        self.session.click(button)
        self.settle()
        self.assertEqual(self.session.run("return meshView.selected()"), {"scene": 0, "highlight": 0})
        self.assertEqual(self.session.run("return document.querySelector(arguments[0]).getAttribute('aria-pressed')", button), "true")
        self.assertIn(highlight["text"], self.session.run("return document.getElementById('view-said').textContent"))
        self.assertIn(highlight["code"], self.session.text("#chosen-text"))
        width, height = self.canvas_size()
        x, y = self.project(highlight["focus"])
        self.assertAlmostEqual(x, width / 2, delta=2)
        self.assertAlmostEqual(y, height / 2, delta=2)
        self.session.click("#chosen-clear")
        self.assertIsNone(self.session.run("return meshView.selected()"))
        self.assertEqual(self.session.run("return document.querySelectorAll('[aria-pressed=true].defect').length"), 0)

    def test_a_click_on_the_surface_tells_of_the_face_there(self):
        self.open(self.pages.mesh("icosphere.mesh"))
        scene = self.data["scenes"][0]
        surface = Surface(scene["detail"])
        for face in (0, len(surface.faces) // 2, len(surface.faces) - 1):
            self.session.run("meshView.lookFrom(arguments[0])", surface.normal(face))
            self.session.run("window.scrollTo(0, 0)")
            self.session.click_at("#view-canvas", *self.project(surface.middle(face)))
            self.assertEqual(self.session.text("#picked-title"), f"Face {surface.face_ids[face]}")
            rows = self.session.run("""return Array.from(document.querySelectorAll('#picked-rows tr'),
                                         (row) => Array.from(row.cells, (cell) => cell.textContent))""")
            for row, vertex in zip(rows, surface.faces[face]):
                self.assertEqual(row[0], f"vertex {surface.vertex_ids[vertex]}")
                for text, drawn, centre in zip(row[1:], surface.points[vertex], scene["centre"]):
                    self.assertAlmostEqual(float(text.replace("−", "-")), drawn / scene["scale"] + centre, places=5)
            labels = {row[0] for row in rows}
            self.assertLessEqual({field["label"] for field in scene["fields"]}, labels)

    def test_a_click_beside_the_surface_tells_nothing(self):
        self.open(self.pages.mesh("icosphere.mesh"))
        self.session.click_at("#view-canvas", 6, self.canvas_size()[1] - 6)
        self.assertTrue(self.session.run("return document.getElementById('picked').hidden"))


LINE_COLOURS = """
  return Object.fromEntries(Array.from(document.querySelectorAll('[data-lines]'),
    (box) => [box.dataset.lines, getComputedStyle(box.parentElement.querySelector('.line-mark')).color.match(/\\d+/g).map(Number)]));
"""


class Lines(PageCase):
    """Lines over the surface, in the colours that the page says they have."""

    def share(self, colour):
        width, height, rows = read_png(self.canvas_png())
        return sum(far(pixel[:3], colour) <= 25 for row in rows for pixel in row) / (width * height)

    def test_they_are_seen_at_once_and_go_with_their_box(self):
        for name, kind in (("crossing_cubes.mesh", "intersections"), ("cube_with_hole.mesh", "borders"),
                           ("fan_of_three.mesh", "non_manifold_edges"), ("cube_flipped_face.mesh", "flipped_edges")):
            with self.subTest(kind):
                self.open(self.pages.mesh(name))
                self.session.choose("#choose-field", "")
                colour = self.session.run(LINE_COLOURS)[kind]
                self.assertGreater(self.share(colour), 0.0008)
                self.session.click(f"[data-lines='{kind}']")
                self.assertLess(self.share(colour), 0.0001)

    def test_they_are_seen_through_what_is_in_front_of_them(self):
        self.open(self.pages.mesh("crossing_cubes.mesh"))
        self.session.choose("#choose-field", "")
        self.session.run("meshView.lookFrom([0.55, 0.42, 1])")
        with_lines = self.canvas_png()
        self.session.click("[data-lines='intersections']")
        self.assertTrue(with_lines != self.canvas_png(), "the lines are behind the cube")


class Keys(PageCase):
    def test_the_mesh_turns_nears_and_comes_back(self):
        self.open(self.pages.mesh("torus.obj"))
        corner = Surface(self.data["scenes"][0]["detail"]).points[0]
        self.focus_canvas()
        start = self.project(corner)
        self.session.press(RIGHT)
        self.assertGreater(abs(self.project(corner)[0] - start[0]), 2)
        self.session.press(LEFT)
        for now, then in zip(self.project(corner), start):
            self.assertAlmostEqual(now, then, delta=0.01)
        width, _ = self.canvas_size()
        self.session.press("+", "+")
        self.assertGreater(abs(self.project(corner)[0] - width / 2), abs(start[0] - width / 2))
        self.session.press("f")
        self.settle()
        for now, then in zip(self.project(corner), start):
            self.assertAlmostEqual(now, then, delta=0.01)

    def test_letters_switch_edges_and_normals(self):
        self.open(self.pages.mesh("cube.obj"))
        self.focus_canvas()
        for key, boxes in (("w", ["show-wireframe"]), ("n", ["show-face-normals", "show-vertex-normals"])):
            for is_on in (True, False):
                self.session.press(key)
                for box in boxes:
                    self.assertEqual(self.session.run("return document.getElementById(arguments[0]).checked", box), is_on)

    def test_defects_are_walked_through_and_left(self):
        self.open(self.pages.mesh("crossing_cubes.mesh"))
        count = len(self.data["scenes"][0]["highlights"])
        self.focus_canvas()
        walk = []
        for _ in range(count + 1):
            self.session.press("j")
            walk.append(self.session.run("return meshView.selected().highlight"))
        self.assertEqual(sorted(walk[:count]), list(range(count)))
        self.assertEqual(walk[count], walk[0])
        self.session.press("k")
        self.assertEqual(self.session.run("return meshView.selected().highlight"), walk[count - 1])
        self.session.press(ESCAPE)
        self.assertIsNone(self.session.run("return meshView.selected()"))

    def test_the_list_is_used_without_a_mouse(self):
        self.open(self.pages.mesh("crossing_cubes.mesh"))
        focused = "return document.activeElement.className + document.activeElement.getAttribute('data-highlight')"
        self.session.run("document.querySelector('button.defect').focus()")
        first = self.session.run(focused)
        self.session.press(ENTER)
        self.assertEqual(self.session.run(focused), first)
        self.assertIn("Shown:", self.session.run("return document.getElementById('view-said').textContent"))
        self.session.press("j")
        self.assertNotEqual(self.session.run(focused), first)
        self.assertEqual(self.session.run("return document.activeElement.getAttribute('aria-pressed')"), "true")
        self.session.press(ESCAPE)
        self.assertIsNone(self.session.run("return meshView.selected()"))

    def test_letters_do_nothing_outside_the_view(self):
        self.open(self.pages.mesh("crossing_cubes.mesh"))
        self.session.run("document.querySelector('.theme').focus()")
        self.session.press("j", "w")
        self.assertIsNone(self.session.run("return meshView.selected()"))
        self.assertFalse(self.session.run("return document.getElementById('show-wireframe').checked"))


class Legend(PageCase):
    def signed_field(self):
        return next(field for field in self.data["scenes"][0]["fields"] if field["kind"] == "signed")

    def test_it_tells_the_range_of_the_colours_and_of_the_values(self):
        self.open(self.pages.mesh("torus.obj"))
        field = self.signed_field()
        self.session.choose("#choose-field", field["name"])
        self.assertEqual(self.session.text(".legend-title"), field["label"])
        told = [float(text.replace("−", "-")) for text in
                re.findall(r"[-−]?\d+\.?\d*(?:e[-−]?\d+)?", self.session.text(".legend-notes"))][:4]
        for number, expected in zip(told, [*field["scale"], *field["range"]], strict=True):
            self.assertAlmostEqual(number, expected, delta=1e-4 * max(1, abs(expected)))
        ticks = self.session.run("""return Array.from(document.querySelectorAll('.legend-tick'),
            (tick) => [tick.textContent, parseFloat(tick.style.left) / 100])""")
        low, high = field["scale"]
        self.assertGreaterEqual(len(ticks), 2)
        for text, at in ticks:
            self.assertAlmostEqual(low + at * (high - low), float(text.replace("−", "-")), delta=1e-4 * (high - low))

    def test_the_palette_asked_for_is_in_the_legend_and_on_the_mesh(self):
        self.open(self.pages.mesh("torus.obj"))
        self.session.choose("#choose-field", self.signed_field()["name"])
        pictures = set()
        for name in ("viridis", "diverging", "jet", "hot"):
            self.session.choose("#choose-palette", name)
            low = numbers(self.data["palettes"][name], "B")[:3]
            bar = self.session.run("return document.querySelector('.legend-bar').style.background")
            self.assertEqual(tuple(map(int, re.search(r"rgb\((\d+),? (\d+),? (\d+)", bar).groups())), low)
            pictures.add(self.canvas_png())
        self.assertEqual(len(pictures), 4)

    def test_categories_are_named(self):
        self.open(self.pages.mesh("zero_area_face.mesh"))
        self.session.choose("#choose-field", "defect")
        codes = {highlight["code"] for highlight in self.data["scenes"][0]["highlights"]}
        named = set(self.session.run("return Array.from(document.querySelectorAll('.legend-swatches li'), (li) => li.textContent)"))
        self.assertIn("none", named)
        self.assertTrue(named & codes)

    def test_a_plain_surface_has_none(self):
        self.open(self.pages.mesh("torus.obj"))
        self.session.choose("#choose-field", "")
        self.assertEqual(self.session.text("#legend"), "")
