"""Shared by the tests of pages: opens a page, reads pixels, and checks that no page logs an error or requests anything."""

import base64
import unittest

from pages import scene_data

# Keys of the WebDriver protocol.
LEFT, RIGHT, ENTER, ESCAPE = "\ue012", "\ue014", "\ue007", "\ue00c"

PIXELS = """
  meshView.render();
  const canvas = document.getElementById('view-canvas');
  const copy = document.createElement('canvas');
  copy.width = canvas.clientWidth;
  copy.height = canvas.clientHeight;
  const context = copy.getContext('2d', {willReadFrequently: true});
  context.drawImage(canvas, 0, 0, copy.width, copy.height);
  return arguments[0].map(([x, y]) => Array.from(context.getImageData(Math.round(x), Math.round(y), 1, 1).data).slice(0, 3));
"""


# Each face is looked at from straight ahead, where light does not dim its colour; null where something hides it.
FACE_COLOURS = """
  const canvas = document.getElementById('view-canvas');
  const copy = document.createElement('canvas');
  copy.width = copy.height = 1;
  const context = copy.getContext('2d', {willReadFrequently: true});
  return arguments[0].map(([face, middle, normal]) => {
    meshView.lookFrom(normal);
    const [x, y] = meshView.project(middle);
    const pick = meshView.pick(x, y);
    if (!pick || pick.face !== face) return null;
    meshView.render();
    context.drawImage(canvas, Math.round(x), Math.round(y), 1, 1, 0, 0, 1, 1);
    return Array.from(context.getImageData(0, 0, 1, 1).data).slice(0, 3);
  });
"""


def rgb(hex_colour):
    return tuple(int(hex_colour[i:i + 2], 16) for i in (1, 3, 5))


def far(a, b):
    """The largest difference of two colours in a channel."""
    return max(abs(x - y) for x, y in zip(a, b))


class PageCase(unittest.TestCase):
    # Set by the program: Pages and a Session.
    pages = None
    session = None

    def setUp(self):
        self.opened = []
        self.session.open("about:blank")
        self.session.devtools("Emulation.setEmulatedMedia", media="", features=[])
        self.session.console()
        self.session.requests()

    def tearDown(self):
        told = [entry for entry in self.session.console() if entry["level"] in ("SEVERE", "WARNING")]
        self.assertEqual(told, [])
        asked = {address for address in self.session.requests() if not address.startswith("about:")}
        self.assertLessEqual(asked, set(self.opened))
        if self.session.run("return window.meshView !== undefined"):
            self.assertEqual(self.session.run("return meshView.errors"), [])

    def open(self, page):
        """Opens a page with a view."""
        self.open_plain(page)
        self.session.wait("return window.meshView && meshView.ready")
        self.data = scene_data(page)

    def open_plain(self, page):
        self.opened.append(page.resolve().as_uri())
        self.session.open(self.opened[-1])

    def canvas_png(self):
        url = self.session.run("meshView.render(); return document.getElementById('view-canvas').toDataURL('image/png')")
        return base64.b64decode(url.split(",")[1])

    def pixels(self, places):
        return [tuple(pixel) for pixel in self.session.run(PIXELS, places)]

    def project(self, point):
        return self.session.run("return meshView.project(arguments[0])", point)

    def canvas_size(self):
        return self.session.run("const c = document.getElementById('view-canvas'); return [c.clientWidth, c.clientHeight]")

    def settle(self):
        self.session.wait("return !meshView.isMoving()")

    def focus_canvas(self):
        self.session.run("document.getElementById('view-canvas').focus()")
