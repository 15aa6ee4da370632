// The view: which scene is shown, how it is coloured, what is chosen.
(function (page) {
  "use strict";

  // Of what is wrong: in colours that no surface has, and seen through what is in front of it.
  const kDefectLine = { width: 3.5, isCased: true, isSeenThrough: true };
  const kLines = {
    borders: { colour: page.styleColour("--borders"), width: 2.5, order: 1 },
    flipped_edges: { colour: page.styleColour("--flipped-edges"), lift: 1.2, order: 2 },
    intersections: { colour: page.styleColour("--intersections"), lift: 1.3, order: 3 },
    non_manifold_edges: { colour: page.styleColour("--non-manifold-edges"), lift: 1.4, order: 4 },
  };
  const kNormals = {
    faces: { colour: page.styleColour("--face-normals"), width: 1.8 },
    vertices: { colour: page.styleColour("--vertex-normals"), width: 1.8 },
  };
  const kFlat = { colour: "#27313b", width: 1.5 };

  class Viewer {
    constructor(data, canvas, context) {
      this.data = data;
      this.canvas = canvas;
      this.stage = new page.Stage(canvas, context);
      this.camera = this.stage.camera;
      this.list = new page.DefectList((scene, highlight) => {
        this.choose(scene, highlight);
        this.bringIntoSight();
      });
      this.surfaces = [];
      this.shown = {};  // strokes by the name of what they show
      this.hidden = new Set();
      this.normals = { faces: false, vertices: false };
      this.look = { edges: false, smooth: true, opacity: 1 };
      this.palette = "";
      this.range = "clipped";
      this.field = null;
      this.legend = null;
      this.texture = null;
      this.sceneIndex = -1;
      this.scene = null;
      this.highlight = null;
      this.highlightIndex = -1;
      this.lit = null;
      this.setScene(0);
      this.camera.fly(this.camera.wholeView(page.firstDirection(this.scene)), true);
    }

    // Scenes

    // The same place of the file stays in sight: before and after are seen from one point.
    setScene(index) {
      if (index === this.sceneIndex) {
        return;
      }
      const last = this.scene;
      const fieldName = this.field ? this.field.name : "";
      this.clear();
      page.hidePick();
      this.removeScene();
      this.sceneIndex = index;
      this.scene = this.data.scene(index);
      this.addScene();
      page.showScene(this);
      const hasField = last && this.scene.fields.some((field) => field.name === fieldName);
      this.setField(hasField || (last && fieldName === "") ? fieldName : this.firstField());
      if (last) {
        this.keepView(last);
      }
    }

    keepView(last) {
      const view = this.camera.view();
      view.target.fromArray(page.placeInView(this.scene, page.placeInFile(last, view.target.toArray())));
      view.distance *= last.perUnit / this.scene.perUnit;
      this.camera.fly(view, true);
    }

    // Where something is wrong, that is what is to be seen first.
    firstField() {
      const field = this.scene.fields.find((candidate) => candidate.name === "defect");
      return field && this.scene.defects > 0 ? "defect" : "";
    }

    removeScene() {
      for (const surface of this.surfaces) {
        this.stage.scene.remove(surface.mesh);
        surface.dispose();
      }
      this.surfaces = [];
      Object.keys(this.shown).forEach((name) => this.hideStrokes(name));
    }

    addScene() {
      for (const part of ["detail", "context"]) {
        if (this.scene[part]) {
          const surface = new page.DrawnSurface(this.scene[part], part);
          this.surfaces.push(surface);
          this.stage.scene.add(surface.mesh);
          this.showStrokes("flat " + part, page.flatFaceSegments(surface.surface, surface.ofFaces), kFlat);
        }
      }
      this.camera.setContent(this.surfaces.map((surface) => surface.surface.positions));
      this.applyLook();
      for (const name of Object.keys(kLines)) {
        this.showLines(name, !this.hidden.has(name));
      }
      Object.keys(this.normals).forEach((kind) => this.showNormals(kind, this.normals[kind]));
    }

    // Lines

    showStrokes(name, segments, look) {
      if (segments && segments.length > 0 && !this.shown[name]) {
        this.shown[name] = new page.Strokes(segments, look);
        this.stage.add(this.shown[name]);
      }
    }

    hideStrokes(name) {
      if (this.shown[name]) {
        this.stage.remove(this.shown[name]);
        delete this.shown[name];
      }
    }

    showLines(name, isShown) {
      if (isShown) {
        this.hidden.delete(name);
        this.showStrokes(name, this.scene.lines[name], Object.assign({}, kDefectLine, kLines[name]));
      } else {
        this.hidden.add(name);
        this.hideStrokes(name);
      }
    }

    // kind: "faces" or "vertices".
    showNormals(kind, isShown) {
      this.normals[kind] = isShown;
      const name = "normals of " + kind;
      const drawn = this.surfaces.find((surface) => surface.part === "detail");
      if (!isShown) {
        this.hideStrokes(name);
      } else if (drawn) {
        const segments = kind === "faces" ? page.faceNormalSegments(drawn.surface, drawn.ofFaces)
                                          : page.vertexNormalSegments(drawn.surface);
        this.showStrokes(name, segments, kNormals[kind]);
      }
    }

    // The surface's look

    applyLook() {
      for (const surface of this.surfaces) {
        surface.setEdges(this.look.edges);
        surface.setOpacity(this.look.opacity);
        if (!this.look.smooth) {
          surface.setSmooth(false);
        }
      }
      this.stage.ask();
    }

    setEdges(isShown) {
      this.look.edges = isShown;
      this.applyLook();
    }

    setOpacity(opacity) {
      this.look.opacity = opacity;
      this.applyLook();
    }

    setSmooth(isSmooth) {
      this.look.smooth = isSmooth;
      this.surfaces.forEach((surface) => surface.setSmooth(isSmooth));
      this.stage.ask();
    }

    // Colours

    // "" for a plain surface.
    setField(name) {
      this.field = this.scene.fields.find((field) => field.name === name) || null;
      this.recolour();
    }

    // "" for the field's own.
    setPalette(name) {
      this.palette = name;
      this.recolour();
    }

    // "clipped" or "full".
    setRange(name) {
      this.range = name;
      this.recolour();
    }

    recolour() {
      if (this.texture) {
        this.texture.dispose();
        this.texture = null;
      }
      const field = this.field;
      const range = field ? page.rangeOf(field, this.range) : null;
      const bytes = field ? page.paletteOf(this.data, field, this.palette) : null;
      if (field) {
        this.texture = page.paletteTexture(bytes);
        const coordinate = page.paletteCoordinate(field, range);
        this.surfaces.forEach((surface) => surface.setField(field, coordinate, this.texture));
      } else {
        this.surfaces.forEach((surface) => surface.setPlain());
      }
      this.legend = page.legendOf(this.data, this.scene, field, range, bytes);
      page.showLegend(document.getElementById("legend"), this.legend);
      page.showColouring(this);
      this.stage.ask();
    }

    // Defects

    // Flies there and tells it; at once where asked.
    choose(sceneIndex, highlightIndex, isAtOnce) {
      this.setScene(sceneIndex);
      this.unlight();
      const highlight = this.scene.highlights[highlightIndex];
      if (!highlight) {
        return;
      }
      this.highlight = highlight;
      this.highlightIndex = highlightIndex;
      this.lit = new page.LitHighlight(this.stage, this.scene.detail, highlight);
      this.list.mark(sceneIndex, highlightIndex);
      this.flyTo(highlight, isAtOnce);
      page.showChosen(this);
      page.say("Shown: " + highlight.code + ", " + highlight.text);
    }

    flyTo(highlight, isAtOnce) {
      const distance = this.camera.distanceFor(Math.min(2.4 * highlight.radius, 1.02));
      const direction = page.viewDirection(this.scene, highlight, this.camera.view().direction, distance);
      const target = new THREE.Vector3().fromArray(highlight.focus);
      this.camera.fly({ target: target, direction: direction, distance: distance }, isAtOnce);
    }

    // On a narrow page the list is below the view.
    bringIntoSight() {
      const frame = this.canvas.getBoundingClientRect();
      if (frame.bottom < frame.height / 2 || frame.top > window.innerHeight - frame.height / 2) {
        this.canvas.scrollIntoView({ block: "nearest" });
      }
    }

    unlight() {
      if (this.lit) {
        this.lit.remove();
      }
      this.lit = null;
      this.highlight = null;
      this.highlightIndex = -1;
    }

    clear() {
      const hadChoice = this.highlight !== null;
      this.unlight();
      this.list.mark(null, null);
      page.showChosen(this);
      if (hadChoice) {
        page.say("Nothing is chosen.");
      }
    }

    step(by) {
      const next = this.list.next(by);
      if (next) {
        this.choose(next.sceneIndex, next.highlightIndex);
      }
    }

    // Places of the canvas, in CSS pixels

    // point: in the view's lengths.
    project(point) {
      this.camera.prepare();
      const p = new THREE.Vector3().fromArray(point).project(this.camera.three);
      return [(p.x + 1) / 2 * this.canvas.clientWidth, (1 - p.y) / 2 * this.canvas.clientHeight];
    }

    // Null where there is no surface.
    pick(x, y) {
      this.camera.prepare();
      const eye = this.camera.three.position;
      const far = new THREE.Vector3(2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight, 0.5);
      const way = far.unproject(this.camera.three).sub(eye).normalize();
      const hit = page.castRayAtScene(this.scene, eye.toArray(), way.toArray());
      return hit ? page.describeFace(this.scene, hit) : null;
    }

    tell(x, y) {
      const pick = this.pick(x, y);
      if (pick) {
        page.showPick(this.data, pick);
        page.say(page.titleOfPick(pick) + ", vertices " + pick.vertexIds.join(", "));
      } else {
        page.hidePick();
      }
    }

    save() {
      this.stage.render();
      const heading = document.querySelector("h1");
      const name = (heading ? heading.textContent : "mesh").replace(/[^\w.-]+/g, "_");
      page.savePicture(page.pictureOf(this.canvas, this.legend), name + ".png");
    }
  }

  page.Viewer = Viewer;
})(window.meshPage = window.meshPage || {});
