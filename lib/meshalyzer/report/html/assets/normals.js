// Normals as segments: of faces from their middles, of vertices from themselves. All are unit
// vectors, drawn at one length that suits the mesh.
(function (page) {
  "use strict";

  const kLongest = 0.25;  // of the mesh's radius
  const kOfAnEdge = 0.8;

  // Of at most some thousand edges, evenly chosen: enough for a length that suits.
  function meanEdge(surface) {
    const t = surface.triangles;
    const p = surface.positions;
    const stride = 3 * Math.ceil(t.length / 3 / 5000);
    let sum = 0;
    let count = 0;
    for (let corner = 0; corner < t.length; corner += stride) {
      const a = 3 * t[corner];
      const b = 3 * t[corner + 1];
      sum += Math.hypot(p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]);
      ++count;
    }
    return count > 0 ? sum / count : 0;
  }

  page.normalLength = function (surface) {
    return Math.min(kLongest, kOfAnEdge * meanEdge(surface)) || kLongest;
  };

  function hasLength(normals, at) {
    return normals[at] !== 0 || normals[at + 1] !== 0 || normals[at + 2] !== 0;
  }

  // A segment for each normal that there is; pointOf(at): where the one at that place stands.
  function segmentsOf(normals, length, pointOf) {
    const segments = new Float32Array(2 * normals.length);
    let size = 0;
    for (let at = 0; at < normals.length; at += 3) {
      if (!hasLength(normals, at)) {
        continue;
      }
      const point = pointOf(at);
      for (let k = 0; k < 3; ++k) {
        segments[size + k] = point[k];
        segments[size + 3 + k] = point[k] + length * normals[at + k];
      }
      size += 6;
    }
    return segments.subarray(0, size);
  }

  page.vertexNormalSegments = function (surface) {
    const pointOf = (at) => surface.positions.subarray(at, at + 3);
    return segmentsOf(surface.normals, page.normalLength(surface), pointOf);
  };

  page.faceMiddle = function (surface, face) {
    const p = surface.positions;
    const [a, b, c] = [0, 1, 2].map((k) => 3 * surface.triangles[3 * face + k]);
    return [0, 1, 2].map((k) => (p[a + k] + p[b + k] + p[c + k]) / 3);
  };

  // normals: of the faces.
  page.faceNormalSegments = function (surface, normals) {
    const pointOf = (at) => page.faceMiddle(surface, at / 3);
    return segmentsOf(normals, page.normalLength(surface), pointOf);
  };

  // The edges of faces that have no normal, hence no area: all that is to be seen of them.
  page.flatFaceSegments = function (surface, normals) {
    const p = surface.positions;
    const segments = [];
    for (let at = 0; at < normals.length; at += 3) {
      if (hasLength(normals, at)) {
        continue;
      }
      for (let k = 0; k < 3; ++k) {
        const a = 3 * surface.triangles[at + k];
        const b = 3 * surface.triangles[at + (k + 1) % 3];
        segments.push(p[a], p[a + 1], p[a + 2], p[b], p[b + 1], p[b + 2]);
      }
    }
    return new Float32Array(segments);
  };
})(window.meshPage = window.meshPage || {});
