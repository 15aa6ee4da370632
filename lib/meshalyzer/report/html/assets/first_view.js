// From where the mesh is seen first: where much of it is to be seen, and much of what is wrong.
(function (page) {
  "use strict";

  // The usual view, which others must beat, then its like from other sides.
  const kUsual = [0.55, 0.42, 1];
  const kOthers = [
    [-0.55, 0.42, 1], [1, 0.42, 0.55], [-1, 0.42, 0.55], [0.55, 0.42, -1], [-0.55, 0.42, -1], [1, 0.42, -0.55],
    [-1, 0.42, -0.55], [0.3, 1, 0.5], [0.12, 0.16, 1], [1, 0.16, 0.12], [0.3, -1, 0.5], [0.55, -0.42, 1],
  ];
  // What a direction is worth beforehand: the usual one, others, those from below.
  const kWorth = { usual: 0.3, other: 0.1, below: 0 };
  const kSampledFaces = 20000;
  const kPlaces = 12;
  // Of faces that rays are tried against: a fraction of a second.
  const kTries = 5e6;
  const kFarOff = 4;

  function worthBeforehand(direction, i) {
    if (i === 0) {
      return kWorth.usual;
    }
    return direction.y < 0 ? kWorth.below : kWorth.other;
  }

  // Twice the area vectors of some of the faces, as a flat array.
  function areaVectors(surface) {
    const step = Math.max(1, Math.floor(surface.triangles.length / 3 / kSampledFaces));
    const vectors = [];
    for (let f = 0; 3 * f < surface.triangles.length; f += step) {
      const [a, b, c] = [0, 1, 2].map((k) => new THREE.Vector3().fromArray(surface.positions, 3 * surface.triangles[3 * f + k]));
      const vector = b.sub(a).cross(c.sub(a));
      vectors.push(vector.x, vector.y, vector.z);
    }
    return vectors;
  }

  function areaTowards(vectors, direction) {
    let sum = 0;
    for (let i = 0; i < vectors.length; i += 3) {
      sum += Math.abs(vectors[i] * direction.x + vectors[i + 1] * direction.y + vectors[i + 2] * direction.z);
    }
    return sum;
  }

  // Places of some of the defects, as many as there is time for.
  function somePlaces(scene, surfaces, directions) {
    const faces = surfaces.reduce((sum, surface) => sum + surface.triangles.length / 3, 0);
    const count = Math.min(kPlaces, scene.highlights.length, Math.floor(kTries / (faces * directions)));
    const places = [];
    for (let i = 0; i < count; ++i) {
      places.push(page.anchorOf(scene, scene.highlights[Math.floor(i * scene.highlights.length / count)]));
    }
    return places;
  }

  page.firstDirection = function (scene) {
    const directions = [kUsual].concat(kOthers).map((way) => new THREE.Vector3().fromArray(way).normalize());
    const surfaces = [scene.detail, scene.context].filter((surface) => surface);
    if (surfaces.length === 0) {
      return directions[0];
    }
    const vectors = surfaces.map(areaVectors);
    const areas = directions.map((direction) => vectors.reduce((sum, some) => sum + areaTowards(some, direction), 0));
    const largest = Math.max(...areas);
    const places = somePlaces(scene, surfaces, directions.length);
    const worths = directions.map((direction, i) => {
      const seen = places.filter((place) => page.isFree(scene, place, direction, kFarOff)).length;
      const shareOfArea = largest > 0 ? areas[i] / largest : 0;
      return worthBeforehand(direction, i) + shareOfArea + (places.length > 0 ? seen / places.length : 0);
    });
    return directions[worths.indexOf(Math.max(...worths))];
  };
})(window.meshPage = window.meshPage || {});
