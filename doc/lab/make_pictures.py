#!/usr/bin/env python3
"""Makes the pictures of the course: opens pages of `meshalyzer --html` in headless Chromium, and presses "Save picture".

usage: make_pictures.py MESHALYZER LAB_FOLDER [CHROMEDRIVER CHROMIUM]

LAB_FOLDER holds the meshes of the laboratory report. The pictures go to pictures/ beside this file.
"""

import pathlib
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent.parent / "tests" / "browser"))
from webdriver import Driver  # noqa: E402  (the folder must be known before)

# The view is a part of the window; this one gives pictures of about 600 pixels.
WINDOW = (700, 900)
SECONDS_TO_SAVE = 20


@dataclass
class Picture:
    name: str
    mesh: str
    # "" for a plain surface.
    colour_by: str = ""
    # "" for the field's own.
    palette: str = ""
    look_from: tuple = (0.55, 0.42, 1.0)
    # Boxes to be ticked, by their id in the page, and those that must not be.
    ticks: list = field(default_factory=list)
    smooth: bool = True


PICTURES = [
    Picture("cube_normals", "cube.obj", ticks=["show-face-normals", "show-vertex-normals", "show-wireframe"], smooth=False),
    Picture("sphere_normals", "sphere1.0.obj", ticks=["show-face-normals", "show-vertex-normals"], smooth=False),
    Picture("torus_gaussian", "torus.obj", "gaussian", look_from=(0.2, 1.0, 0.8)),
    Picture("torus_mean", "torus.obj", "mean", look_from=(0.2, 1.0, 0.8)),
    Picture("bunny_gaussian", "bunnySmall.obj", "gaussian", look_from=(0.1, 0.2, 1.0)),
    Picture("bunny_mean", "bunnySmall.obj", "mean", look_from=(0.1, 0.2, 1.0)),
    Picture("cow", "cow.obj", look_from=(0.3, 0.2, 1.0), ticks=["show-wireframe"], smooth=False),
    Picture("torus_genus", "torus.obj", look_from=(0.2, 1.0, 0.8), ticks=["show-wireframe"], smooth=False),
    Picture("genuscube", "genuscube.obj", look_from=(0.6, 0.5, 1.0), ticks=["show-wireframe"], smooth=False),
]


def page_of(program, mesh, folder):
    """The page of a mesh, made once."""
    page = folder / (mesh.name + ".html")
    if not page.exists():
        subprocess.run([program, "--quiet", "--curvature", "--html", page, mesh], check=True, stdout=subprocess.DEVNULL)
    return page


def tick(session, box, is_on):
    """As a click does; the box may be out of sight."""
    session.run("const box = document.getElementById(arguments[0]); if (box.checked !== arguments[1]) box.click();", box, is_on)


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


def take(session, picture, page):
    session.open(page.resolve().as_uri())
    session.devtools("Emulation.setEmulatedMedia", media="", features=[{"name": "prefers-color-scheme", "value": "light"}])
    session.wait("return window.meshView && meshView.ready", seconds=60)
    tick(session, "show-smooth", picture.smooth)
    for box in picture.ticks:
        tick(session, box, True)
    fields = session.run("return Array.from(document.querySelectorAll('#choose-field option'), (option) => option.value)")
    assert picture.colour_by in fields, f"{picture.name}: the page has no field {picture.colour_by}, only {fields}"
    session.run("meshView.setField(arguments[0]); meshView.setPalette(arguments[1]);", picture.colour_by, picture.palette)
    session.run("meshView.lookFrom(arguments[0]); meshView.render();", list(picture.look_from))
    errors = session.run("return meshView.errors")
    assert not errors, f"{picture.name}: {errors}"
    (HERE / "pictures" / f"{picture.name}.png").write_bytes(saved(session))


def main():
    program, lab = sys.argv[1], pathlib.Path(sys.argv[2])
    chromedriver, browser = sys.argv[3:5] or ("chromedriver", "/usr/bin/chromium")
    driver = Driver(chromedriver, browser)
    try:
        session = driver.session(size=WINDOW)
        with tempfile.TemporaryDirectory() as scratch:
            for picture in PICTURES:
                take(session, picture, page_of(program, lab / picture.mesh, pathlib.Path(scratch)))
        session.close()
    finally:
        driver.close()


if __name__ == "__main__":
    main()
