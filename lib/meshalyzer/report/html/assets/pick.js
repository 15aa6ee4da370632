// Which face is under a place of the picture: the ray through it against every face. That is a
// few milliseconds for some hundred thousand faces, once a click; an index would cost more.
(function (page) {
  "use strict";

  // Where the ray o + t d meets triangle (a, b, c) of p with t > 0; Infinity where it does not.
  // After Moeller and Trumbore 1997, from both sides.
  function meeting(p, a, b, c, o, d) {
    const ex = p[b] - p[a], ey = p[b + 1] - p[a + 1], ez = p[b + 2] - p[a + 2];
    const fx = p[c] - p[a], fy = p[c + 1] - p[a + 1], fz = p[c + 2] - p[a + 2];
    const hx = d[1] * fz - d[2] * fy, hy = d[2] * fx - d[0] * fz, hz = d[0] * fy - d[1] * fx;
    const determinant = ex * hx + ey * hy + ez * hz;
    if (determinant === 0) {
      return Infinity;
    }
    const sx = o[0] - p[a], sy = o[1] - p[a + 1], sz = o[2] - p[a + 2];
    const u = (sx * hx + sy * hy + sz * hz) / determinant;
    if (!(u >= 0 && u <= 1)) {
      return Infinity;
    }
    const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
    const v = (d[0] * qx + d[1] * qy + d[2] * qz) / determinant;
    if (!(v >= 0 && u + v <= 1)) {
      return Infinity;
    }
    const t = (fx * qx + fy * qy + fz * qz) / determinant;
    return t > 0 ? t : Infinity;
  }

  // The nearest face of a surface: {face, t}, t Infinity where there is none.
  page.castRay = function (surface, origin, direction) {
    const triangles = surface.triangles;
    const best = { face: -1, t: Infinity };
    for (let i = 0; i < triangles.length; i += 3) {
      const t = meeting(surface.positions, 3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2], origin, direction);
      if (t < best.t) {
        best.t = t;
        best.face = i / 3;
      }
    }
    return best;
  };

  // Of all of a scene: {part, surface, face, t} or null.
  page.castRayAtScene = function (scene, origin, direction) {
    let best = null;
    for (const part of ["detail", "context"]) {
      const surface = scene[part];
      const hit = surface ? page.castRay(surface, origin, direction) : { t: Infinity };
      if (hit.t < (best ? best.t : Infinity)) {
        best = { part: part, surface: surface, face: hit.face, t: hit.t };
      }
    }
    return best;
  };

  // What a page tells of a face: its ids, corners in the file's coordinates, values of fields.
  page.describeFace = function (scene, hit) {
    const surface = hit.surface;
    const corners = [0, 1, 2].map((k) => surface.triangles[3 * hit.face + k]);
    return {
      part: hit.part,
      face: hit.face,
      faceId: surface.faceIds[hit.face],
      vertexIds: corners.map((v) => surface.vertexIds[v]),
      places: corners.map((v) => page.placeInFile(scene, Array.from(surface.positions.subarray(3 * v, 3 * v + 3)))),
      values: scene.fields.map((field) => {
        const values = field.values(hit.part);
        return { field: field, values: field.isOfFaces ? [values[hit.face]] : corners.map((v) => values[v]) };
      }),
    };
  };
})(window.meshPage = window.meshPage || {});
