// The programs of the graphics processor.
(function (page) {
  "use strict";

  const surfaceVertex = `
    attribute vec3 corner;
    attribute vec2 value;
    varying vec3 vCorner;
    varying vec2 vValue;
    varying vec3 vNormal;
    void main() {
      vCorner = corner;
      vValue = value;
      vNormal = normalMatrix * normal;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`;

  // `value` is (coordinate * weight, weight): where only some corners of a face have a value,
  // those are interpolated and the part of the face that is nearer to the others is grey.
  const surfaceFragment = `
    uniform sampler2D palette;
    uniform vec3 plain;
    uniform vec3 none;
    uniform vec3 edgeColour;
    uniform float mode;
    uniform float edges;
    uniform float opacity;
    varying vec3 vCorner;
    varying vec2 vValue;
    varying vec3 vNormal;

    vec3 fieldColour() {
      if (vValue.y < 0.5) return none;
      float t = vValue.x / vValue.y;
      float entry = mode > 1.5 ? floor(t + 0.5) : clamp(t, 0.0, 1.0) * 255.0;
      return texture2D(palette, vec2((entry + 0.5) / 256.0, 0.5)).rgb;
    }

    // Lines a pixel wide along the sides; paler where faces are only a few pixels high, for else
    // they would cover all.
    float edgeShare() {
      vec3 step = fwidth(vCorner);
      vec3 away = smoothstep(vec3(0.0), step * 1.3, vCorner);
      float largest = max(step.x, max(step.y, step.z));
      float strength = mix(0.8, 0.22, smoothstep(0.08, 0.45, largest));
      return (1.0 - min(away.x, min(away.y, away.z))) * strength;
    }

    void main() {
      vec3 colour = mode < 0.5 ? plain : fieldColour();
      float side = gl_FrontFacing ? 1.0 : -1.0;
      float light = max(0.0, dot(normalize(vNormal) * side, normalize(vec3(-0.25, 0.35, 1.0))));
      if (!gl_FrontFacing) colour = mix(colour * 0.5, vec3(0.22, 0.28, 0.42), 0.5);
      colour *= min(1.0, 0.42 + 0.63 * light);
      if (edges > 0.5) colour = mix(colour, edgeColour, edgeShare());
      gl_FragColor = vec4(colour, opacity);
    }`;

  // Each instance is a segment, drawn as a band of constant width on screen with round ends; a
  // segment of length 0 becomes a disc. Bands are drawn a little nearer to the eye than they are,
  // so that they lie over the surface.
  const strokeVertex = `
    attribute vec3 from;
    attribute vec3 to;
    uniform vec2 resolution;
    uniform float width;
    uniform float lift;
    uniform float nearest;
    varying vec3 vPlace;
    varying float vW;

    vec4 inFront(vec4 point, vec4 other) {
      if (point.z <= -nearest || other.z >= -nearest) return point;
      return mix(point, other, (point.z + nearest) / (point.z - other.z));
    }

    void main() {
      vec4 a = modelViewMatrix * vec4(from, 1.0);
      vec4 b = modelViewMatrix * vec4(to, 1.0);
      vec4 p = inFront(a, b);
      vec4 q = inFront(b, a);
      p.xyz *= 1.0 - lift;
      q.xyz *= 1.0 - lift;
      vec4 clipP = projectionMatrix * p;
      vec4 clipQ = projectionMatrix * q;
      vec2 atP = clipP.xy / clipP.w * resolution * 0.5;
      vec2 atQ = clipQ.xy / clipQ.w * resolution * 0.5;
      float along = distance(atP, atQ);
      vec2 way = along > 1e-3 ? (atQ - atP) / along : vec2(1.0, 0.0);
      float reach = width * 0.5 + 1.0;
      bool isEnd = position.x > 0.5;
      vec4 clip = isEnd ? clipQ : clipP;
      vec2 at = isEnd ? atQ + way * reach : atP - way * reach;
      at += vec2(-way.y, way.x) * position.y * reach;
      gl_Position = vec4(at / (resolution * 0.5) * clip.w, clip.z, clip.w);
      // Times w and divided by it later: interpolated evenly on screen, not in depth.
      vW = clip.w;
      vPlace = vec3(isEnd ? along + reach : -reach, position.y * reach, along) * vW;
    }`;

  const strokeFragment = `
    uniform vec3 colour;
    uniform float opacity;
    uniform float width;
    varying vec3 vPlace;
    varying float vW;
    void main() {
      vec3 place = vPlace / vW;
      float x = place.x - clamp(place.x, 0.0, place.z);
      float away = length(vec2(x, place.y));
      float share = 1.0 - smoothstep(width * 0.5 - 0.5, width * 0.5 + 0.5, away);
      if (share < 0.02) discard;
      gl_FragColor = vec4(colour, opacity * share);
    }`;

  const litVertex = `
    uniform float lift;
    void main() {
      vec4 p = modelViewMatrix * vec4(position, 1.0);
      p.xyz *= 1.0 - lift;
      gl_Position = projectionMatrix * p;
    }`;

  const litFragment = `
    uniform vec3 colour;
    uniform float opacity;
    void main() { gl_FragColor = vec4(colour, opacity); }`;

  page.shaders = {
    surface: { vertexShader: surfaceVertex, fragmentShader: surfaceFragment },
    stroke: { vertexShader: strokeVertex, fragmentShader: strokeFragment },
    lit: { vertexShader: litVertex, fragmentShader: litFragment },
  };
})(window.meshPage = window.meshPage || {});
