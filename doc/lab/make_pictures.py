#!/usr/bin/env python3
"""Makes the pictures of the course, and the one of a page for the README, in headless Chromium from `meshalyzer --html`.

usage: make_pictures.py MESHALYZER LAB_FOLDER [NAME...]

LAB_FOLDER holds the meshes of the laboratory report. All pictures are made, or those named. They go to pictures/ beside this
file, the page to doc/pictures/page.png. Needs chromium and chromedriver.
"""

import base64
import math
import pathlib
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
MESHES = HERE.parent.parent / "meshes"
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent.parent / "tests" / "browser"))
from png import read_png  # noqa: E402  (the folder must be known before)
from small_png import small_png  # noqa: E402
from webdriver import Driver  # noqa: E402

# In pixels of style sheets, of which the view takes most; and how many of the picture's make one.
WINDOW, SCALE = (640, 620), 1.5
PAGE_WINDOW = (1200, 1000)
SECONDS_TO_SAVE = 20
NORMALS = ("show-face-normals", "show-vertex-normals")
EDGES = ("show-wireframe",)
BEHIND = (-1.0, 0.9, -0.5)


@dataclass
class Picture:
    name: str
    # Of LAB_FOLDER, where it has no folder of its own.
    mesh: object
    # "" for a plain surface.
    colour_by: str = ""
    # "" for the field's own.
    palette: str = ""
    look_from: tuple = (0.55, 0.42, 1.0)
    # How much farther off than the page would be.
    farther: float = 1.0
    opacity: float = 1.0
    # Boxes to be ticked, by their id in the page.
    ticks: tuple = ()
    is_smooth: bool = True
    # The code of a defect to fly to.
    defect: str = ""
    window: tuple = WINDOW


# What is made and not read: see torus().
TORUS = "torus of radii 2 and 1.obj"

PICTURES = [
    Picture("cube_normals", MESHES / "cube.mesh", ticks=NORMALS + EDGES, is_smooth=False, farther=1.25),
    Picture("sphere_normals", MESHES / "uv_sphere.mesh", ticks=NORMALS + EDGES, is_smooth=False, farther=1.2),
    Picture("torus_gaussian", TORUS, "gaussian", look_from=(0.2, 0.85, 0.8)),
    Picture("torus_mean", TORUS, "mean", look_from=(0.2, 0.85, 0.8)),
    Picture("torus_jet", TORUS, "gaussian", "jet", look_from=(0.2, 0.85, 0.8)),
    Picture("genuscube", "genuscube.obj", look_from=(0.45, 0.42, 1.0), ticks=EDGES, is_smooth=False, opacity=0.55),
    Picture("cow_pinched", "cow.obj", look_from=BEHIND, ticks=EDGES, is_smooth=False, defect="non-manifold", farther=0.5),
    Picture("bunny_gaussian", "bunnySmall.obj", "gaussian", look_from=(0.1, 0.2, 1.0)),
    Picture("bunny_mean", "bunnySmall.obj", "mean", look_from=(0.1, 0.2, 1.0)),
]
PAGE = Picture("page", "cow.obj", "mean", look_from=BEHIND, ticks=EDGES, defect="non-manifold", farther=0.6, window=PAGE_WINDOW)


def torus(around=120, across=60):
    """As OBJ: radii 2 and 1, its axis upwards."""
    lines = []
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            r = 2 + math.cos(v)
            lines.append(f"v {r * math.sin(u):.15g} {math.sin(v):.15g} {r * math.cos(u):.15g}")
    for i in range(around):
        for j in range(across):
            a, b = i * across, (i + 1) % around * across
            k = (j + 1) % across
            lines += [f"f {a + j + 1} {b + j + 1} {b + k + 1}", f"f {a + j + 1} {b + k + 1} {a + k + 1}"]
    return "\n".join(lines) + "\n"


class Pages:
    """The pages of meshes, each made once."""

    def __init__(self, program, lab, folder):
        self.program, self.lab, self.folder = program, pathlib.Path(lab), pathlib.Path(folder)

    def of(self, mesh):
        path = self.lab / mesh
        if mesh == TORUS:
            path = self.folder / mesh
            path.write_text(torus())
        page = self.folder / (path.name + ".html")
        if not page.exists():
            command = [self.program, "--quiet", "--curvature", "--html", page, path]
            status = subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode
            assert page.exists(), f"{command}: {status}"
        return page


def set_window(session, size):
    session.devtools("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=SCALE if size == WINDOW else 1,
                     mobile=False)
    session.devtools("Emulation.setEmulatedMedia", media="", features=[{"name": "prefers-color-scheme", "value": "light"}])


def tick(session, box, is_on):
    """As a click does; the box may be out of sight."""
    session.run("const box = document.getElementById(arguments[0]); if (box.checked !== arguments[1]) box.click();", box, is_on)


def fly_to(session, code):
    """To the first defect of a code."""
    found = session.run("""const button = document.querySelector(`details[data-code="${arguments[0]}"] button.defect`);
                           if (button) meshView.select(Number(button.dataset.scene), Number(button.dataset.highlight));
                           return button !== null;""", code)
    assert found, f"there is no defect {code}"


def set_view(session, picture):
    tick(session, "show-smooth", picture.is_smooth)
    for box in picture.ticks:
        tick(session, box, True)
    fields = session.run("return Array.from(document.querySelectorAll('#choose-field option'), (option) => option.value)")
    assert picture.colour_by in fields, f"{picture.name}: the page has no field {picture.colour_by}, only {fields}"
    session.choose("#choose-field", picture.colour_by)
    session.choose("#choose-palette", picture.palette)
    session.choose("#choose-opacity", str(picture.opacity))
    session.run("meshView.lookFrom(arguments[0])", list(picture.look_from))
    if picture.defect:
        fly_to(session, picture.defect)
    step_back(session, picture.farther)
    session.run("meshView.render()")


def step_back(session, times):
    """By the wheel of a mouse, which takes steps of 1 / 0.95; nearer where times is below 1."""
    steps = round(math.log(times) / -math.log(0.95))
    session.run("""for (let i = 0; i < Math.abs(arguments[0]); ++i) {
                     const wheel = new WheelEvent("wheel", {deltaY: arguments[0], cancelable: true});
                     document.getElementById("view-canvas").dispatchEvent(wheel);
                   }""", steps)


def saved(session):
    """The file that the button "Save picture" leaves."""
    downloads = pathlib.Path(session.downloads)
    before = set(downloads.glob("*.png")) if downloads.exists() else set()
    session.run("document.getElementById('view-save').click()")
    end = time.monotonic() + SECONDS_TO_SAVE
    while time.monotonic() < end:
        new = set(downloads.glob("*.png")) - before if downloads.exists() else set()
        if new:
            return new.pop().read_bytes()
        time.sleep(0.1)
    raise TimeoutError("no picture was saved")


def screenshot(session):
    """All of the window."""
    return base64.b64decode(session.devtools("Page.captureScreenshot", format="png")["data"])


def take(session, picture, page):
    set_window(session, picture.window)
    session.open(page.resolve().as_uri())
    session.wait("return window.meshView && meshView.ready", seconds=60)
    set_view(session, picture)
    errors = session.run("return meshView.errors")
    assert not errors, f"{picture.name}: {errors}"
    content = screenshot(session) if picture is PAGE else saved(session)
    folder = HERE.parent if picture is PAGE else HERE
    path = folder / "pictures" / f"{picture.name}.png"
    path.write_bytes(small_png(*read_png(content)))
    print(f"{path.relative_to(HERE.parent)}: {path.stat().st_size // 1000} kB")


def main():
    program, lab, names = sys.argv[1], sys.argv[2], sys.argv[3:]
    driver = Driver("chromedriver", "/usr/bin/chromium")
    try:
        session = driver.session()
        with tempfile.TemporaryDirectory() as scratch:
            pages = Pages(program, lab, scratch)
            for picture in [*PICTURES, PAGE]:
                if not names or picture.name in names:
                    take(session, picture, pages.of(picture.mesh))
        session.close()
    finally:
        driver.close()


if __name__ == "__main__":
    main()
