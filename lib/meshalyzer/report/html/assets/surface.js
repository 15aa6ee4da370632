// A surface as it is drawn: corners of faces apart, so that each face can have a colour, a normal
// and edges of its own.
(function (page) {
  "use strict";

  // Cosine of the largest angle between a face and a corner's normal that is shaded smoothly:
  // where the surface turns more it has an edge, which is to be seen.
  const kSmooth = Math.cos(Math.PI / 6);

  page.kModes = { plain: 0, ramp: 1, category: 2 };

  function cornerPositions(surface) {
    const corners = new Float32Array(3 * surface.triangles.length);
    surface.triangles.forEach((vertex, corner) => {
      for (let k = 0; k < 3; ++k) {
        corners[3 * corner + k] = surface.positions[3 * vertex + k];
      }
    });
    return corners;
  }

  // Unit normals of faces, 0 where a face has no area, from the positions of their corners.
  page.faceNormals = function (corners) {
    const normals = new Float32Array(corners.length / 3);
    for (let f = 0; f < normals.length; f += 3) {
      const c = 3 * f;
      const ax = corners[c + 3] - corners[c], ay = corners[c + 4] - corners[c + 1], az = corners[c + 5] - corners[c + 2];
      const bx = corners[c + 6] - corners[c], by = corners[c + 7] - corners[c + 1], bz = corners[c + 8] - corners[c + 2];
      const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
      const length = Math.sqrt(x * x + y * y + z * z);
      const factor = length > 0 ? 1 / length : 0;
      normals[f] = x * factor;
      normals[f + 1] = y * factor;
      normals[f + 2] = z * factor;
    }
    return normals;
  };

  function fillNormals(normals, surface, ofFaces, isSmooth) {
    const ofVertices = surface.normals;
    for (let corner = 0; corner < surface.triangles.length; ++corner) {
      const f = 3 * Math.floor(corner / 3);
      const v = 3 * surface.triangles[corner];
      const cosine = ofFaces[f] * ofVertices[v] + ofFaces[f + 1] * ofVertices[v + 1] + ofFaces[f + 2] * ofVertices[v + 2];
      const source = isSmooth && cosine > kSmooth ? ofVertices : ofFaces;
      const at = source === ofVertices ? v : f;
      normals[3 * corner] = source[at];
      normals[3 * corner + 1] = source[at + 1];
      normals[3 * corner + 2] = source[at + 2];
    }
  }

  // Barycentric coordinates, from which the shader draws edges.
  function cornerMarks(count) {
    const marks = new Uint8Array(4 * count);
    for (let corner = 0; corner < count; ++corner) {
      marks[4 * corner + corner % 3] = 255;
    }
    return marks;
  }

  function surfaceMaterial() {
    return new THREE.ShaderMaterial({
      vertexShader: page.shaders.surface.vertexShader,
      fragmentShader: page.shaders.surface.fragmentShader,
      uniforms: {
        palette: { value: null },
        plain: { value: new THREE.Color().fromArray(page.kPlain) },
        none: { value: new THREE.Color().fromArray(page.kNoValue) },
        edgeColour: { value: new THREE.Color(0x1d252d) },
        mode: { value: 0 },
        edges: { value: 0 },
        opacity: { value: 1 },
      },
      side: THREE.DoubleSide,
      extensions: { derivatives: true },
    });
  }

  class DrawnSurface {
    constructor(surface, part) {
      const count = surface.triangles.length;
      const corners = cornerPositions(surface);
      this.surface = surface;
      this.part = part;
      this.ofFaces = page.faceNormals(corners);
      this.geometry = new THREE.BufferGeometry();
      this.geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
      this.geometry.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
      this.geometry.setAttribute("value", new THREE.BufferAttribute(new Float32Array(2 * count), 2));
      this.geometry.setAttribute("corner", new THREE.BufferAttribute(cornerMarks(count), 4, true));
      this.material = surfaceMaterial();
      this.mesh = new THREE.Mesh(this.geometry, this.material);
      this.mesh.frustumCulled = false;
      this.setSmooth(true);
    }

    setSmooth(isSmooth) {
      const normals = this.geometry.getAttribute("normal");
      fillNormals(normals.array, this.surface, this.ofFaces, isSmooth);
      normals.needsUpdate = true;
    }

    setEdges(isShown) { this.material.uniforms.edges.value = isShown ? 1 : 0; }

    setOpacity(opacity) {
      this.material.uniforms.opacity.value = opacity;
      this.material.transparent = opacity < 1;
      this.material.depthWrite = opacity === 1;
    }

    setPlain() { this.material.uniforms.mode.value = page.kModes.plain; }

    // coordinate: from page.paletteCoordinate.
    setField(field, coordinate, texture) {
      const uniforms = this.material.uniforms;
      uniforms.mode.value = field.kind === "category" ? page.kModes.category : page.kModes.ramp;
      uniforms.palette.value = texture;
      this.fillValues(field, coordinate);
    }

    fillValues(field, coordinate) {
      const values = field.values(this.part);
      const triangles = this.surface.triangles;
      const attribute = this.geometry.getAttribute("value");
      for (let corner = 0; corner < triangles.length; ++corner) {
        const value = values[field.isOfFaces ? Math.floor(corner / 3) : triangles[corner]];
        const isThere = !Number.isNaN(value);
        attribute.array[2 * corner] = isThere ? coordinate(value) : 0;
        attribute.array[2 * corner + 1] = isThere ? 1 : 0;
      }
      attribute.needsUpdate = true;
    }

    dispose() {
      this.geometry.dispose();
      this.material.dispose();
    }
  }

  page.DrawnSurface = DrawnSurface;
})(window.meshPage = window.meshPage || {});
