// Numbers for people, and round numbers for axes.
(function (page) {
  "use strict";

  function powerText(value, digits) {
    const parts = value.toExponential(digits - 1).split("e");
    const mantissa = String(Number(parts[0]));
    const superscript = String(Number(parts[1])).replace(/./g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
    return mantissa + "·10" + superscript;
  }

  // With so many significant digits; powers of ten where the plain number would be long.
  page.numberText = function (value, digits) {
    if (Number.isNaN(value)) {
      return "none";
    }
    if (!Number.isFinite(value)) {
      return value > 0 ? "infinite" : "−infinite";
    }
    const size = Math.abs(value);
    const isPlain = size === 0 || (size >= 1e-4 && size < 1e7);
    const text = isPlain ? String(Number(value.toPrecision(digits))) : powerText(value, digits);
    return text.replace(/^-/, "−");
  };

  page.countText = function (count) {
    return String(count).replace(/\B(?=(\d{3})+$)/g, ",");
  };

  function roundStep(rough) {
    const power = Math.pow(10, Math.floor(Math.log10(rough)));
    const leading = rough / power;
    return power * (leading <= 1 ? 1 : leading <= 2 ? 2 : leading <= 5 ? 5 : 10);
  }

  // Multiples of 1, 2 or 5 times a power of ten from low to high, about `about` of them. Both
  // ends where no such number lies between. least: the smallest step.
  page.roundTicks = function (low, high, about, least) {
    const step = Math.max(roundStep((high - low) / about), least);
    if (!(step > 0) || !Number.isFinite(step)) {
      return [low];
    }
    const ticks = [];
    const first = Math.ceil(low / step - 1e-9);
    const last = Math.floor(high / step + 1e-9);
    for (let i = first; i <= last && ticks.length < 20; ++i) {
      ticks.push(i * step);
    }
    return ticks.length > 1 ? ticks : [low, high];
  };
})(window.meshPage = window.meshPage || {});
