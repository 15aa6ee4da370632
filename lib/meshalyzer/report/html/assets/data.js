// The scenes as the page carries them: JSON with flat arrays in base64. Scenes and fields are
// decoded when they are first shown, for a large mesh has more of them than a reader looks at.
(function (page) {
  "use strict";

  function bytesOf(text) {
    if (typeof Uint8Array.fromBase64 === "function") {
      return Uint8Array.fromBase64(text);
    }
    const characters = atob(text);
    const bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i) {
      bytes[i] = characters.charCodeAt(i);
    }
    return bytes;
  }

  function arrayOf(Type, text) {
    const bytes = bytesOf(text || "");
    return new Type(bytes.buffer, bytes.byteOffset, bytes.byteLength / Type.BYTES_PER_ELEMENT);
  }

  // Coordinates for the graphics processor: radius 1, whatever the mesh's size is. Products of
  // very small or very large ones would leave the range of its floats.
  function lengthsOf(text, unit) {
    const values = arrayOf(Float32Array, text);
    for (let i = 0; i < values.length; ++i) {
      values[i] *= unit;
    }
    return values;
  }

  // Unit vectors, or 0, of whole numbers: 127 stands for 1.
  function unitsOf(text) {
    const values = Float32Array.from(arrayOf(Int8Array, text));
    for (let i = 0; i < values.length; i += 3) {
      const length = Math.hypot(values[i], values[i + 1], values[i + 2]) || 1;
      values[i] /= length;
      values[i + 1] /= length;
      values[i + 2] /= length;
    }
    return values;
  }

  function surfaceOf(raw, unit) {
    if (!raw) {
      return null;
    }
    const triangles = arrayOf(Uint32Array, raw.triangles);
    if (triangles.length === 0) {
      return null;
    }
    return {
      positions: lengthsOf(raw.positions, unit),
      normals: unitsOf(raw.normals),
      triangles: triangles,
      vertexIds: arrayOf(Int32Array, raw.vertex_ids),
      faceIds: arrayOf(Int32Array, raw.face_ids),
    };
  }

  class Field {
    // surfaces: by part.
    constructor(raw, surfaces) {
      this.raw = raw;
      this.surfaces = surfaces;
      this.name = raw.name;
      this.label = raw.label;
      this.kind = raw.kind;
      this.palette = raw.palette;
      this.isOfFaces = raw.place === "faces";
      this.clipped = raw.scale.map(Number);
      this.full = raw.range.map(Number);
      this.decoded = {};
    }

    // part: "detail" or "context". NaN where there is no value.
    values(part) {
      if (!this.decoded[part]) {
        this.decoded[part] = this.decode(part);
      }
      return this.decoded[part];
    }

    // One value stands for all.
    decode(part) {
      const values = arrayOf(Float32Array, this.raw[part]);
      const surface = this.surfaces[part];
      const count = surface ? (this.isOfFaces ? surface.faceIds : surface.vertexIds).length : 0;
      return values.length === 1 ? new Float32Array(count).fill(values[0]) : values;
    }
  }

  class Highlight {
    constructor(raw, unit) {
      this.raw = raw;
      this.unit = unit;
      this.code = raw.code;
      this.text = raw.text;
      this.isCut = raw.cut;
      this.focus = raw.focus.map((x) => x * unit);
      this.radius = raw.radius * unit;
    }

    faces() { return arrayOf(Uint32Array, this.raw.faces); }
    segments() { return lengthsOf(this.raw.segments, this.unit); }
    points() { return lengthsOf(this.raw.points, this.unit); }
  }

  function sceneOf(raw) {
    const unit = 1 / raw.radius;
    const surfaces = { detail: surfaceOf(raw.detail, unit), context: surfaceOf(raw.context, unit) };
    const lines = {};
    for (const name of Object.keys(raw.lines)) {
      lines[name] = lengthsOf(raw.lines[name], unit);
    }
    return {
      title: raw.title,
      centre: raw.centre,
      perUnit: raw.radius / raw.scale,
      unit: unit,
      notes: raw.notes,
      defects: raw.defects,
      detail: surfaces.detail,
      context: surfaces.context,
      fields: raw.fields.map((field) => new Field(field, surfaces)),
      lines: lines,
      highlights: raw.highlights.map((highlight) => new Highlight(highlight, unit)),
    };
  }

  class PageData {
    constructor(raw) {
      this.codes = raw.codes;
      this.palettes = {};
      for (const name of Object.keys(raw.palettes)) {
        this.palettes[name] = bytesOf(raw.palettes[name]);
      }
      this.rawScenes = raw.scenes;
      this.titles = raw.scenes.map((scene) => scene.title);
      this.scenes = [];
    }

    // The name of a value of a field of categories: a code, or a number from 1.
    categoryText(field, value) {
      if (field.name !== "defect") {
        return String(value + 1);
      }
      return value === 0 ? "none" : this.codes[value - 1].code;
    }

    scene(index) {
      if (!this.scenes[index]) {
        this.scenes[index] = sceneOf(this.rawScenes[index]);
      }
      return this.scenes[index];
    }
  }

  // Null where the page has no scene.
  page.readData = function () {
    const element = document.getElementById("scene-data");
    if (!element) {
      return null;
    }
    const raw = JSON.parse(element.textContent);
    return raw.scenes && raw.scenes.length > 0 ? new PageData(raw) : null;
  };

  // A place in the file, in its own units, of a place in the view.
  page.placeInFile = function (scene, point) {
    return point.map((x, i) => x * scene.perUnit + scene.centre[i]);
  };

  page.placeInView = function (scene, point) {
    return point.map((x, i) => (x - scene.centre[i]) / scene.perUnit);
  };
})(window.meshPage = window.meshPage || {});
