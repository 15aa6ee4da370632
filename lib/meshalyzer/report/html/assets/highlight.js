// The chosen defect, lit up, and from where to look at it.
(function (page) {
  "use strict";

  page.kHighlight = page.styleColour("--highlight");
  // Outlines of many faces show their shape; those of a few make even the thinnest visible.
  const kFewOutlines = { colour: page.kHighlight, width: 3 };
  const kManyOutlines = { colour: "#7a0743", width: 1.5 };
  const kFew = 8;

  function litMaterial(isBehind) {
    return new THREE.ShaderMaterial({
      vertexShader: page.shaders.lit.vertexShader,
      fragmentShader: page.shaders.lit.fragmentShader,
      uniforms: {
        colour: { value: new THREE.Color(page.kHighlight) },
        opacity: { value: isBehind ? 0.28 : 1 },
        lift: { value: 0.5 * page.kLift },
      },
      depthFunc: isBehind ? THREE.GreaterDepth : THREE.LessEqualDepth,
      depthWrite: false,
      transparent: true,
      side: THREE.DoubleSide,
    });
  }

  function facesGeometry(surface, faces) {
    const corners = new Float32Array(9 * faces.length);
    faces.forEach((face, i) => {
      for (let k = 0; k < 9; ++k) {
        corners[9 * i + k] = surface.positions[3 * surface.triangles[3 * face + Math.floor(k / 3)] + k % 3];
      }
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    return geometry;
  }

  function sidesOf(corners) {
    const sides = new Float32Array(2 * corners.length);
    for (let f = 0; f < corners.length; f += 9) {
      for (let k = 0; k < 3; ++k) {
        sides.set(corners.subarray(f + 3 * k, f + 3 * k + 3), 2 * f + 6 * k);
        const next = f + 3 * ((k + 1) % 3);
        sides.set(corners.subarray(next, next + 3), 2 * f + 6 * k + 3);
      }
    }
    return sides;
  }

  class LitHighlight {
    constructor(stage, surface, highlight) {
      this.stage = stage;
      this.strokes = [];
      this.meshes = [];
      const faces = highlight.faces();
      if (faces.length > 0 && surface) {
        this.addFaces(facesGeometry(surface, faces));
      }
      this.addStrokes(highlight.segments(), { colour: page.kHighlight, width: 5, lift: 2, isCased: true, isSeenThrough: true, order: 7 });
      this.addStrokes(page.pointSegments(highlight.points()), { colour: page.kHighlight, width: 11, lift: 2.5, isCased: true, isSeenThrough: true, order: 8 });
    }

    addFaces(geometry) {
      for (const isBehind of [false, true]) {
        const mesh = new THREE.Mesh(geometry, litMaterial(isBehind));
        mesh.frustumCulled = false;
        mesh.renderOrder = 5;
        this.meshes.push(mesh);
        this.stage.scene.add(mesh);
      }
      const sides = sidesOf(geometry.getAttribute("position").array);
      const look = sides.length / 18 <= kFew ? kFewOutlines : kManyOutlines;
      this.addStrokes(sides, Object.assign({ lift: 1.5, isSeenThrough: true, order: 6 }, look));
    }

    addStrokes(segments, look) {
      if (segments.length > 0) {
        const strokes = new page.Strokes(segments, look);
        this.strokes.push(strokes);
        this.stage.add(strokes);
      }
    }

    remove() {
      this.strokes.forEach((strokes) => this.stage.remove(strokes));
      for (const mesh of this.meshes) {
        this.stage.scene.remove(mesh);
        mesh.geometry.dispose();
        mesh.material.dispose();
      }
      this.stage.ask();
    }
  }

  // A place that is lit up: the middle of its first face or segment, or its first point.
  page.anchorOf = function (scene, highlight) {
    const faces = highlight.faces();
    if (faces.length > 0 && scene.detail) {
      return page.faceMiddle(scene.detail, faces[0]);
    }
    const segments = highlight.segments();
    if (segments.length > 0) {
      return [0, 1, 2].map((k) => (segments[k] + segments[3 + k]) / 2);
    }
    const points = highlight.points();
    return points.length > 0 ? Array.from(points.subarray(0, 3)) : highlight.focus;
  };

  // Twice the area vector of the loop that segments make, pointing away from the middle of the
  // mesh; near 0 where they make none. The view into a hole, for no face tells that. Segments may
  // run either way, so each takes the side of those before it.
  function loopNormal(segments, focus) {
    const centre = new THREE.Vector3().fromArray(focus);
    const sum = new THREE.Vector3();
    for (let s = 0; s < segments.length; s += 6) {
      const a = new THREE.Vector3().fromArray(segments, s).sub(centre);
      const b = new THREE.Vector3().fromArray(segments, s + 3).sub(centre);
      const area = a.cross(b);
      sum.addScaledVector(area, sum.dot(area) < 0 ? -1 : 1);
    }
    return sum.dot(centre) < 0 ? sum.negate() : sum;
  }

  function sumOfNormals(surface, vertices) {
    const sum = new THREE.Vector3();
    vertices.forEach((v) => sum.add(new THREE.Vector3().fromArray(surface.normals, 3 * v)));
    return sum;
  }

  // Which way out of the mesh is at a highlight; 0 where there is no telling.
  function outside(surface, highlight) {
    if (!surface) {
      return new THREE.Vector3();
    }
    const faces = highlight.faces();
    if (faces.length > 0) {
      const corners = [];
      faces.forEach((face) => corners.push(...surface.triangles.subarray(3 * face, 3 * face + 3)));
      return sumOfNormals(surface, corners);
    }
    const loop = loopNormal(highlight.segments(), highlight.focus);
    return loop.length() > highlight.radius * highlight.radius ? loop : sumOfNormals(surface, verticesNear(surface, highlight));
  }

  function verticesNear(surface, highlight) {
    const [x, y, z] = highlight.focus;
    const limit = highlight.radius * highlight.radius * 1.44;
    const p = surface.positions;
    const near = [];
    for (let v = 0; 3 * v < p.length; ++v) {
      const dx = p[3 * v] - x, dy = p[3 * v + 1] - y, dz = p[3 * v + 2] - z;
      if (dx * dx + dy * dy + dz * dz <= limit) {
        near.push(v);
      }
    }
    return near;
  }

  // Straight on would show no depth: a little from above and aside.
  function tilted(direction) {
    return direction.clone().normalize().add(new THREE.Vector3(0.18, 0.22, 0.12)).normalize();
  }

  function candidates(scene, highlight, current) {
    const normal = outside(scene.detail, highlight);
    const first = normal.length() > 1e-3 ? [tilted(normal), normal.normalize()] : [];
    const more = [];
    for (const x of [-1, 0, 1]) {
      for (const y of [-1, 0, 1]) {
        for (const z of [-1, 0, 1]) {
          if (x !== 0 || y !== 0 || z !== 0) {
            more.push(new THREE.Vector3(x, y + 0.05, z).normalize());
          }
        }
      }
    }
    const wish = first[0] || current;
    more.sort((a, b) => b.dot(wish) - a.dot(wish));
    return first.concat([current], more);
  }

  // Whether nothing hides a place from an eye that is so far off in a direction.
  page.isFree = function (scene, place, direction, distance) {
    const way = direction.toArray();
    const eye = place.map((x, k) => x + way[k] * distance);
    const hit = page.castRayAtScene(scene, eye, way.map((x) => -x));
    return !hit || hit.t >= distance * (1 - 1e-3);
  };

  // The first of the likely directions from which nothing hides the place.
  page.viewDirection = function (scene, highlight, current, distance) {
    const anchor = page.anchorOf(scene, highlight);
    const all = candidates(scene, highlight, current);
    return all.find((direction) => page.isFree(scene, anchor, direction, distance)) || all[0];
  };

  page.LitHighlight = LitHighlight;
})(window.meshPage = window.meshPage || {});
