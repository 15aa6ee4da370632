// Segments and points as bands and discs of some pixels, which lines of WebGL cannot be.
(function (page) {
  "use strict";

  // How much nearer to the eye than they are: a share of the distance.
  page.kLift = 0.0015;

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

  function strokeMaterial(look, isBehind) {
    return new THREE.ShaderMaterial({
      vertexShader: page.shaders.stroke.vertexShader,
      fragmentShader: page.shaders.stroke.fragmentShader,
      uniforms: {
        colour: { value: new THREE.Color(look.colour) },
        width: { value: look.width },
        opacity: { value: isBehind ? 0.3 : 1 },
        lift: { value: page.kLift * (look.lift || 1) },
        resolution: { value: new THREE.Vector2(1, 1) },
        nearest: { value: 0.01 },
      },
      depthFunc: isBehind ? THREE.GreaterDepth : THREE.LessEqualDepth,
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
    // look: colour "#rrggbb", width in CSS pixels, lift (in kLift, default 1), isSeenThrough:
    // whether the surface in front of them leaves them faintly visible.
    constructor(segments, look) {
      this.geometry = quadGeometry(segments);
      this.width = look.width;
      this.materials = (look.isSeenThrough ? [false, true] : [false]).map((isBehind) => strokeMaterial(look, isBehind));
      this.object = new THREE.Group();
      for (const material of this.materials) {
        const mesh = new THREE.Mesh(this.geometry, material);
        mesh.frustumCulled = false;
        mesh.renderOrder = look.order || 1;
        this.object.add(mesh);
      }
    }

    // size: of the drawing buffer; pixelRatio: of its pixels to those of CSS.
    prepare(size, pixelRatio, nearest) {
      for (const material of this.materials) {
        material.uniforms.resolution.value.copy(size);
        material.uniforms.width.value = this.width * pixelRatio;
        material.uniforms.nearest.value = nearest;
      }
    }

    dispose() {
      this.geometry.dispose();
      this.materials.forEach((material) => material.dispose());
    }
  }

  page.Strokes = Strokes;
})(window.meshPage = window.meshPage || {});
