// The canvas: its renderer, its size, its ground; pictures are made when something changed, never
// in a loop.
(function (page) {
  "use strict";

  const kContext = { alpha: false, antialias: true, preserveDrawingBuffer: true, powerPreference: "high-performance" };

  // Asked for here and not by three.js, which complains on the console where there is none.
  page.webglContext = function (canvas) {
    try {
      return canvas.getContext("webgl2", kContext) || instancing(canvas.getContext("webgl", kContext));
    } catch (error) {
      return null;
    }
  };

  function instancing(context) {
    const needed = ["ANGLE_instanced_arrays", "OES_standard_derivatives"];
    return context && needed.every((name) => context.getExtension(name)) ? context : null;
  }

  class Stage {
    constructor(canvas, context) {
      this.canvas = canvas;
      this.renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true, preserveDrawingBuffer: true });
      // Remarks of drivers are none of the reader's business.
      this.renderer.debug.checkShaderErrors = false;
      this.scene = new THREE.Scene();
      this.strokes = new Set();
      this.isAsked = false;
      this.ground = null;
      this.camera = new page.Camera(canvas, () => this.ask());
      canvas.addEventListener("webglcontextrestored", () => this.ask());
      new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
      this.fit();
    }

    fit() {
      const width = this.canvas.clientWidth;
      const height = this.canvas.clientHeight;
      if (width > 0 && height > 0) {
        this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
        this.renderer.setSize(width, height, false);
        this.camera.setAspect(width / height);
        this.ask();
      }
    }

    // Null: that of the style sheet.
    setGround(colour) {
      this.ground = colour;
      this.ask();
    }

    add(strokes) {
      this.strokes.add(strokes);
      this.scene.add(strokes.object);
      this.ask();
    }

    remove(strokes) {
      this.strokes.delete(strokes);
      this.scene.remove(strokes.object);
      strokes.dispose();
      this.ask();
    }

    // A picture soon, however often it is asked for until then.
    ask() {
      if (!this.isAsked) {
        this.isAsked = true;
        requestAnimationFrame(() => {
          if (this.isAsked) {
            this.render();
          }
        });
      }
    }

    render() {
      this.isAsked = false;
      const ground = this.ground || page.styleColour("--view");
      this.renderer.setClearColor(new THREE.Color(ground), 1);
      this.camera.prepare();
      const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
      for (const strokes of this.strokes) {
        strokes.prepare(size, this.renderer.getPixelRatio(), this.camera.three.near);
      }
      this.renderer.render(this.scene, this.camera.three);
    }
  }

  page.Stage = Stage;
})(window.meshPage = window.meshPage || {});
