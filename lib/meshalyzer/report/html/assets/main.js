// Starts the page when all of it is there; window.meshView is for tests and the curious.
(function (page) {
  "use strict";

  const kStill = 4;  // pixels: what moved less was a click

  // A press and release at one place is a click, what moves between turns the mesh.
  function startClicks(viewer) {
    let start = null;
    viewer.canvas.addEventListener("pointerdown", (event) => {
      start = event.button === 0 ? [event.clientX, event.clientY] : null;
      viewer.canvas.focus({ preventScroll: true });
    });
    viewer.canvas.addEventListener("pointerup", (event) => {
      if (start && Math.hypot(event.clientX - start[0], event.clientY - start[1]) < kStill) {
        const frame = viewer.canvas.getBoundingClientRect();
        viewer.tell(event.clientX - frame.left, event.clientY - frame.top);
      }
      start = null;
    });
  }

  function offer(viewer) {
    const view = window.meshView;
    view.select = (scene, highlight) => viewer.choose(scene, highlight, true);
    view.selected = () => viewer.highlight ? { scene: viewer.sceneIndex, highlight: viewer.highlightIndex } : null;
    view.project = (point) => viewer.project(point.map((x) => x * viewer.scene.unit));
    view.pick = (x, y) => viewer.pick(x, y);
    view.setScene = (index) => viewer.setScene(index);
    view.setField = (name) => viewer.setField(name);
    view.setPalette = (name) => viewer.setPalette(name);
    view.setRange = (name) => viewer.setRange(name);
    view.isMoving = () => viewer.camera.flight !== null;
    view.lookFrom = (direction) => {
      viewer.camera.fly(viewer.camera.wholeView(new THREE.Vector3().fromArray(direction)), true);
    };
    view.highlightColour = page.kHighlight;
    view.render = () => viewer.stage.render();
    view.ready = true;
  }

  // Null where the browser cannot.
  function startView(data) {
    const canvas = document.getElementById("view-canvas");
    const context = canvas ? page.webglContext(canvas) : null;
    if (!data || !context) {
      return null;
    }
    document.getElementById("viewer").hidden = false;
    document.getElementById("view-off").hidden = true;
    const viewer = new page.Viewer(data, canvas, context);
    page.startControls(viewer);
    page.startKeys(viewer);
    page.showScene(viewer);
    page.showColouring(viewer);
    startClicks(viewer);
    page.onTheme(() => viewer.stage.ask());
    viewer.stage.render();
    return viewer;
  }

  // What goes wrong in the view is no reason to lose the rest of the page.
  function viewOrNull() {
    try {
      return startView(page.readData());
    } catch (error) {
      window.meshView.errors.push(String(error));
      document.getElementById("viewer").hidden = true;
      const sentence = document.getElementById("view-off");
      sentence.hidden = false;
      sentence.textContent = "The 3D view could not be started (" + error.message + "). All findings are on this page as text, tables and charts.";
      return null;
    }
  }

  function start() {
    page.startTheme();
    const viewer = viewOrNull();
    page.startPaper(viewer ? viewer.stage : null);
    if (viewer) {
      offer(viewer);
    } else {
      new page.DefectList(() => {}).disable();
    }
  }

  window.meshView = { ready: false, errors: [] };
  window.addEventListener("error", (event) => window.meshView.errors.push(String(event.message)));
  window.addEventListener("unhandledrejection", (event) => window.meshView.errors.push(String(event.reason)));
  document.addEventListener("DOMContentLoaded", start);
})(window.meshPage = window.meshPage || {});
