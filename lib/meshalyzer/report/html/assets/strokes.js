// Segments and points as bands and discs of some pixels, which lines of WebGL cannot be.
(function (page) {
  "use strict";

  // How much nearer to the eye than they are: a share of the distance.
  page.kLift = 0.0015;
  // Dark on both sides of a line, so that it is seen on any colour of surface and ground.
  const kCasing = { colour: page.styleColour("--casing"), more: 2.2, opacity: 0.85 };
  const kThrough = 0.38;
  // More segments than this cover the surface: they are thin then, and without casing.
  const kMany = 20000;
  const kThin = 0.5;

  function quadGeometry(segments) {
    const geometry = new THREE.InstancedBufferGeometry();
    const quad = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);
    const ends = new THREE.InstancedInterleavedBuffer(segments, 6, 1);
    geometry.setAttribute("position", new THREE.BufferAttribute(quad, 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute("from", new THREE.InterleavedBufferAttribute(ends, 3, 0));
    geometry.setAttribute("to", new THREE.InterleavedBufferAttribute(ends, 3, 3));
    geometry.maxInstancedCount = segments.length / 6;
    return geometry;
  }

  // What is drawn one over the other: {colour, more (pixels of width), opacity, isBehind, isBelow}.
  function passesOf(look, isMany) {
    const passes = [{ colour: look.colour, more: 0, opacity: 1 }];
    if (look.isCased && !isMany) {
      passes.push(Object.assign({ isBelow: true }, kCasing));
    }
    if (look.isSeenThrough && !isMany) {
      passes.push({ colour: look.colour, more: 0, opacity: kThrough, isBehind: true });
    }
    return passes;
  }

  function strokeMaterial(look, pass) {
    return new THREE.ShaderMaterial({
      vertexShader: page.shaders.stroke.vertexShader,
      fragmentShader: page.shaders.stroke.fragmentShader,
      uniforms: {
        colour: { value: new THREE.Color(pass.colour) },
        width: { value: look.width + pass.more },
        opacity: { value: pass.opacity },
        lift: { value: page.kLift * (look.lift || 1) },
        resolution: { value: new THREE.Vector2(1, 1) },
        nearest: { value: 0.01 },
      },
      depthFunc: pass.isBehind ? THREE.GreaterDepth : THREE.LessEqualDepth,
      depthWrite: false,
      transparent: true,
      side: THREE.DoubleSide,
    });
  }

  // Points as the segments from each to itself.
  page.pointSegments = function (points) {
    const segments = new Float32Array(2 * points.length);
    for (let p = 0; p < points.length; p += 3) {
      segments.set(points.subarray(p, p + 3), 2 * p);
      segments.set(points.subarray(p, p + 3), 2 * p + 3);
    }
    return segments;
  };

  class Strokes {
    // look: colour "#rrggbb", width in CSS pixels, lift (in kLift, default 1), order, isCased:
    // whether they have dark sides, isSeenThrough: whether the surface in front of them leaves them
    // faintly visible.
    constructor(segments, look) {
      const isMany = segments.length / 6 > kMany;
      const passes = passesOf(look, isMany);
      this.geometry = quadGeometry(segments);
      this.widths = passes.map((pass) => (isMany ? kThin : 1) * look.width + pass.more);
      this.materials = passes.map((pass) => strokeMaterial(look, pass));
      this.object = new THREE.Group();
      this.materials.forEach((material, i) => {
        const mesh = new THREE.Mesh(this.geometry, material);
        mesh.frustumCulled = false;
        mesh.renderOrder = (look.order || 1) - (passes[i].isBelow ? 0.5 : 0);
        this.object.add(mesh);
      });
    }

    // size: of the drawing buffer; pixelRatio: of its pixels to those of CSS.
    prepare(size, pixelRatio, nearest) {
      this.materials.forEach((material, i) => {
        material.uniforms.resolution.value.copy(size);
        material.uniforms.width.value = this.widths[i] * pixelRatio;
        material.uniforms.nearest.value = nearest;
      });
    }

    dispose() {
      this.geometry.dispose();
      this.materials.forEach((material) => material.dispose());
    }
  }

  page.Strokes = Strokes;
})(window.meshPage = window.meshPage || {});
