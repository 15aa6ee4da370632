"""Pages that the programs make of meshes, each made once."""

import base64
import json
import pathlib
import re
import shutil
import struct
import subprocess


class Pages:
    def __init__(self, meshalyzer, meshfixer, meshes, folder):
        self.meshalyzer = meshalyzer
        self.meshfixer = meshfixer
        self.meshes = pathlib.Path(meshes)
        self.folder = pathlib.Path(folder)

    def mesh(self, name):
        """The page of a mesh."""
        page = self.folder / f"{name}.html"
        if not page.exists():
            self._run(self.meshalyzer, "--html", page, self.meshes / name)
        return page

    def mesh_far_down(self, name):
        """The page of a mesh with a path that fits on no line."""
        folder = self.folder / ("a_folder_with_a_long_name" * 4)
        folder.mkdir(exist_ok=True)
        page = folder / "page.html"
        if not page.exists():
            shutil.copy(self.meshes / name, folder / name)
            self._run(self.meshalyzer, "--html", page, folder / name)
        return page

    def repair(self, name):
        """The page of the repair of a mesh."""
        page = self.folder / f"repair_{name}.html"
        if not page.exists():
            self._run(self.meshfixer, "--html", page, self.meshes / name, "-o", self.folder / f"fixed_{name}")
        return page

    def union(self, *names):
        """The page of the union of meshes, which is not written."""
        page = self.folder / f"union_{'_'.join(names)}.html"
        if not page.exists():
            self._run(self.meshfixer, "--union", *(self.meshes / name for name in names), "--dry-run", "--html", page)
        return page

    def index(self, name, *options):
        """The index page of a folder."""
        page = self.folder / f"index_{name}.html"
        if not page.exists():
            self._run(self.meshalyzer, *options, "--html", page, self.meshes / name)
        return page

    def _run(self, *command):
        result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
        if result.returncode not in (0, 1):
            raise RuntimeError(f"{command}: {result.stderr}")


def scene_data(page):
    """What the view of a page is made of."""
    text = page.read_text(encoding="utf-8")
    return json.loads(re.search(r'id="scene-data">(.*?)</script>', text, re.DOTALL)[1])


def numbers(text, kind):
    """An array of scene data: kind as in `struct`, f or I or i or B."""
    data = base64.b64decode(text)
    return struct.unpack(f"<{len(data) // struct.calcsize(kind)}{kind}", data)


def values_of(field, surface):
    """The values of a field on a drawn surface: one that stands alone stands for all."""
    values = numbers(field["detail"], "f")
    ids = surface["face_ids" if field["place"] == "faces" else "vertex_ids"]
    return values * len(numbers(ids, "i")) if len(values) == 1 else values


def points(text):
    """Coordinates by threes."""
    flat = numbers(text, "f")
    return [flat[i:i + 3] for i in range(0, len(flat), 3)]


def middle(places):
    return [sum(coordinates) / len(places) for coordinates in zip(*places)]


class Surface:
    """A drawn surface."""

    def __init__(self, data):
        self.points = points(data["positions"])
        triangles = numbers(data["triangles"], "I")
        self.faces = [triangles[i:i + 3] for i in range(0, len(triangles), 3)]
        self.face_ids = numbers(data["face_ids"], "i")
        self.vertex_ids = numbers(data["vertex_ids"], "i")

    def middle(self, face):
        return middle([self.points[vertex] for vertex in self.faces[face]])

    def normal(self, face):
        """Of any length."""
        a, b, c = (self.points[vertex] for vertex in self.faces[face])
        u = [q - p for p, q in zip(a, b)]
        v = [q - p for p, q in zip(a, c)]
        return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
