// The form under the view and the keys.
(function (page) {
  "use strict";

  const element = (id) => document.getElementById(id);

  function onChange(id, act) {
    const control = element(id);
    control.addEventListener("input", () => act(control));
    return control;
  }

  function fillFields(viewer) {
    const select = element("choose-field");
    select.textContent = "";
    select.append(new Option("nothing (plain)", ""));
    viewer.scene.fields.forEach((field) => select.append(new Option(field.label, field.name)));
  }

  function showLineToggles(viewer) {
    let shown = 0;
    document.querySelectorAll("[data-lines]").forEach((box) => {
      const count = (viewer.scene.lines[box.dataset.lines] || []).length / 6;
      box.closest(".toggle").hidden = count === 0;
      box.closest(".toggle").querySelector(".count").textContent = page.countText(count);
      shown += count;
    });
    element("line-toggles").hidden = shown === 0;
  }

  function showNotes(viewer) {
    const list = element("view-notes");
    list.textContent = "";
    const isEmpty = !viewer.scene.detail && !viewer.scene.context;
    const notes = isEmpty ? viewer.scene.notes.concat(["There is no face to draw."]) : viewer.scene.notes;
    for (const note of notes) {
      const item = document.createElement("li");
      item.textContent = note;
      list.append(item);
    }
    list.hidden = notes.length === 0;
  }

  // What depends on the scene.
  page.showScene = function (viewer) {
    fillFields(viewer);
    showLineToggles(viewer);
    showNotes(viewer);
    document.querySelectorAll("#scene-choice button").forEach((button, i) => {
      button.setAttribute("aria-pressed", String(i === viewer.sceneIndex));
    });
  };

  // What depends on the choice of colours.
  page.showColouring = function (viewer) {
    const isRamp = viewer.field !== null && viewer.field.kind !== "category";
    element("choose-field").value = viewer.field ? viewer.field.name : "";
    element("choose-palette").value = viewer.palette;
    element("choose-range").value = viewer.range;
    element("palette-label").hidden = !isRamp;
    element("range-label").hidden = !isRamp;
  };

  page.showChosen = function (viewer) {
    const highlight = viewer.highlight;
    element("chosen").hidden = !highlight;
    if (highlight) {
      const rest = highlight.isCut ? " (not all of it can be lit up)" : "";
      element("chosen-text").textContent = highlight.code + ": " + highlight.text + rest;
    }
  };

  page.say = function (text) {
    element("view-said").textContent = text;
  };

  function startScenes(viewer) {
    const holder = element("scene-choice");
    holder.hidden = viewer.data.titles.length < 2;
    viewer.data.titles.forEach((title, i) => {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "tool";
      button.textContent = title ? title[0].toUpperCase() + title.slice(1) : "Mesh " + (i + 1);
      button.addEventListener("click", () => viewer.setScene(i));
      holder.append(button);
    });
  }

  page.startControls = function (viewer) {
    startScenes(viewer);
    onChange("choose-field", (select) => viewer.setField(select.value));
    onChange("choose-palette", (select) => viewer.setPalette(select.value));
    onChange("choose-range", (select) => viewer.setRange(select.value));
    onChange("choose-opacity", (slider) => viewer.setOpacity(Number(slider.value)));
    onChange("show-wireframe", (box) => viewer.setEdges(box.checked));
    onChange("show-smooth", (box) => viewer.setSmooth(box.checked));
    onChange("show-face-normals", (box) => viewer.showNormals("faces", box.checked));
    onChange("show-vertex-normals", (box) => viewer.showNormals("vertices", box.checked));
    document.querySelectorAll("[data-lines]").forEach((box) => {
      box.addEventListener("input", () => viewer.showLines(box.dataset.lines, box.checked));
    });
    element("view-whole").addEventListener("click", () => viewer.camera.showWhole());
    element("view-save").addEventListener("click", () => viewer.save());
    element("chosen-next").addEventListener("click", () => viewer.step(1));
    element("chosen-previous").addEventListener("click", () => viewer.step(-1));
    element("chosen-clear").addEventListener("click", () => { viewer.clear(); viewer.canvas.focus(); });
    element("picked-close").addEventListener("click", () => { page.hidePick(); viewer.canvas.focus(); });
  };

  function toggle(id) {
    const box = element(id);
    box.checked = !box.checked;
    box.dispatchEvent(new Event("input"));
  }

  function toggleNormals() {
    const isShown = element("show-face-normals").checked || element("show-vertex-normals").checked;
    for (const id of ["show-face-normals", "show-vertex-normals"]) {
      if (element(id).checked === isShown) {
        toggle(id);
      }
    }
  }

  // Of the view and of the list of defects.
  const letterKeys = {
    f: (viewer) => viewer.camera.showWhole(),
    w: () => toggle("show-wireframe"),
    n: () => toggleNormals(),
    j: (viewer) => viewer.step(1),
    k: (viewer) => viewer.step(-1),
    Escape: (viewer) => { viewer.clear(); page.hidePick(); },
  };

  // Of the view alone: elsewhere they scroll or mean something else.
  const canvasKeys = {
    ArrowLeft: (camera, isMove) => isMove ? camera.move(1, 0) : camera.turn(-1, 0),
    ArrowRight: (camera, isMove) => isMove ? camera.move(-1, 0) : camera.turn(1, 0),
    ArrowUp: (camera, isMove) => isMove ? camera.move(0, -1) : camera.turn(0, -1),
    ArrowDown: (camera, isMove) => isMove ? camera.move(0, 1) : camera.turn(0, 1),
    "+": (camera) => camera.zoom(1 / 1.2),
    "=": (camera) => camera.zoom(1 / 1.2),
    "-": (camera) => camera.zoom(1.2),
  };

  function isTyped(event) {
    return event.target.closest("select, input:not([type=checkbox]), textarea") !== null;
  }

  page.startKeys = function (viewer) {
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !event.target.closest) {
        return;
      }
      const isInCanvas = event.target === viewer.canvas;
      if (isInCanvas && canvasKeys[event.key]) {
        canvasKeys[event.key](viewer.camera, event.shiftKey);
        event.preventDefault();
      } else if (letterKeys[event.key] && event.target.closest("#view, #changes, #defects") && !isTyped(event)) {
        letterKeys[event.key](viewer);
        event.preventDefault();
      }
    });
  };
})(window.meshPage = window.meshPage || {});
