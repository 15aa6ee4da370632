// Colours: those of the style sheet, and those of values: palettes of 256 entries, and where along
// one a value lies.
(function (page) {
  "use strict";

  page.kSize = 256;
  // What has no colour of a field: grey, in no palette.
  page.kNoValue = [128 / 255, 128 / 255, 128 / 255];
  // The surface without a field, and faces without a defect.
  page.kPlain = [0.78, 0.81, 0.845];

  // name: of a variable of the style sheet, "--view".
  page.styleColour = function (name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  };

  page.cssColour = function (bytes, entry) {
    return "rgb(" + bytes.slice(3 * entry, 3 * entry + 3).join(" ") + ")";
  };

  page.hexToRgb = function (hex) {
    const value = parseInt(hex.slice(1), 16);
    return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
  };

  // A line of 256 texels.
  page.paletteTexture = function (bytes) {
    const texels = new Uint8Array(4 * page.kSize);
    for (let i = 0; i < page.kSize; ++i) {
      texels.set(bytes.subarray(3 * i, 3 * i + 3), 4 * i);
      texels[4 * i + 3] = 255;
    }
    const texture = new THREE.DataTexture(texels, page.kSize, 1, THREE.RGBAFormat);
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
  };

  // Entry 0 for what has no defect, then the codes.
  function defectPalette(codes) {
    const bytes = new Uint8Array(3 * page.kSize);
    bytes.set(page.kPlain.map((x) => Math.round(255 * x)), 0);
    codes.forEach((code, i) => bytes.set(page.hexToRgb(code.colour).map((x) => Math.round(255 * x)), 3 * i + 3));
    return bytes;
  }

  // The bytes of the palette that a field is drawn with; `asked` is "" for the field's own.
  page.paletteOf = function (data, field, asked) {
    if (field.kind === "category") {
      return field.name === "defect" ? defectPalette(data.codes) : data.palettes.category;
    }
    return data.palettes[asked || field.palette] || data.palettes.viridis;
  };

  // The values at both ends of the palette; of a signed field 0 stays in the middle.
  page.rangeOf = function (field, asked) {
    const range = asked === "full" ? field.full : field.clipped;
    if (asked === "full" && field.kind === "signed") {
      const size = Math.max(Math.abs(range[0]), Math.abs(range[1]));
      return [-size, size];
    }
    return range;
  };

  // Far beyond an end is like a little beyond it, but infinities would spoil interpolation.
  function clampFar(t) {
    return Math.max(-1e6, Math.min(1e6, t));
  }

  // Where a value lies: 0 ... 1 from one end of the palette to the other, or an entry.
  page.paletteCoordinate = function (field, range) {
    if (field.kind === "category") {
      return (value) => value % page.kSize;
    }
    const low = range[0];
    const width = range[1] - low;
    return width > 0 ? (value) => clampFar((value - low) / width) : () => 0.5;
  };
})(window.meshPage = window.meshPage || {});
