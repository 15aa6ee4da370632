// The legend: what the colours mean, as values and sentences, and as elements of the page.
(function (page) {
  "use strict";

  const kSwatches = 12;

  function countsOf(field, parts, range) {
    const counts = { below: 0, above: 0, none: 0, all: 0 };
    for (const part of parts) {
      const values = field.values(part);
      counts.all += values.length;
      for (let i = 0; i < values.length; ++i) {
        const value = values[i];
        if (Number.isNaN(value)) {
          ++counts.none;
        } else if (value < range[0]) {
          ++counts.below;
        } else if (value > range[1]) {
          ++counts.above;
        }
      }
    }
    return counts;
  }

  function rampNotes(field, range, counts) {
    const text = (value) => page.numberText(value, 5);
    const elements = field.isOfFaces ? "faces" : "vertices";
    const notes = ["Colours from " + text(range[0]) + " to " + text(range[1]) + "; values from " + text(field.full[0]) + " to " + text(field.full[1]) + "."];
    const beyond = [];
    if (counts.below > 0) {
      beyond.push(page.countText(counts.below) + " below");
    }
    if (counts.above > 0) {
      beyond.push(page.countText(counts.above) + " above");
    }
    if (beyond.length > 0) {
      notes.push("Beyond the ends: " + beyond.join(", ") + " of " + page.countText(counts.all) + " " + elements + ".");
    }
    if (counts.none > 0) {
      notes.push("Grey: no value (" + page.countText(counts.none) + " " + elements + ").");
    }
    return notes;
  }

  function gradient(bytes) {
    const stops = [];
    for (let i = 0; i < page.kSize; i += 15) {
      stops.push(page.cssColour(bytes, i));
    }
    return stops;
  }

  function rampLegend(field, parts, range, bytes) {
    const width = range[1] - range[0];
    const counts = countsOf(field, parts, range);
    const ticks = width > 0 ? page.roundTicks(range[0], range[1], 5, field.name === "valence" ? 1 : 0) : [range[0]];
    return {
      kind: "ramp",
      title: field.label,
      stops: gradient(bytes),
      ticks: ticks.map((value) => ({ at: width > 0 ? (value - range[0]) / width : 0.5, text: page.numberText(value, 6) })),
      isBelow: counts.below > 0,
      isAbove: counts.above > 0,
      notes: rampNotes(field, range, counts),
    };
  }

  function namesIn(field, parts) {
    const names = new Set();
    for (const part of parts) {
      field.values(part).forEach((value) => {
        if (!Number.isNaN(value)) {
          names.add(value);
        }
      });
    }
    return Array.from(names).sort((a, b) => a - b);
  }

  function categoryLegend(field, parts, data, bytes) {
    const names = namesIn(field, parts);
    const isDefect = field.name === "defect";
    return {
      kind: "category",
      title: field.label,
      swatches: names.slice(0, isDefect ? names.length : kSwatches).map((value) => ({
        colour: page.cssColour(bytes, value % page.kSize), text: data.categoryText(field, value),
      })),
      notes: !isDefect && names.length > kSwatches ? ["and " + page.countText(names.length - kSwatches) + " more."] : [],
    };
  }

  // field: null for a plain surface.
  page.legendOf = function (data, scene, field, range, bytes) {
    if (!field) {
      return { kind: "plain", title: "", notes: [] };
    }
    const parts = ["detail", "context"].filter((part) => scene[part]);
    return field.kind === "category" ? categoryLegend(field, parts, data, bytes) : rampLegend(field, parts, range, bytes);
  };

  function element(name, className, text) {
    const made = document.createElement(name);
    made.className = className;
    if (text !== undefined) {
      made.textContent = text;
    }
    return made;
  }

  function scaleElement(legend) {
    const scale = element("div", "legend-scale");
    const bar = element("div", "legend-bar");
    bar.style.background = "linear-gradient(to right, " + legend.stops.join(", ") + ")";
    scale.append(bar);
    const ends = [[legend.isBelow, "low", legend.stops[0]], [legend.isAbove, "high", legend.stops[legend.stops.length - 1]]];
    for (const [isThere, side, colour] of ends) {
      if (isThere) {
        const beyond = element("div", "legend-beyond " + side);
        beyond.style.background = colour;
        scale.append(beyond);
      }
    }
    for (const tick of legend.ticks) {
      const mark = element("span", "legend-tick", tick.text);
      mark.style.left = 100 * tick.at + "%";
      scale.append(mark);
    }
    return scale;
  }

  function swatchesElement(legend) {
    const list = element("ul", "legend-swatches");
    for (const swatch of legend.swatches) {
      const item = document.createElement("li");
      const square = element("span", "swatch");
      square.style.background = swatch.colour;
      item.append(square, swatch.text);
      list.append(item);
    }
    return list;
  }

  page.showLegend = function (holder, legend) {
    holder.textContent = "";
    if (legend.kind === "plain") {
      return;
    }
    holder.append(element("p", "legend-title", legend.title));
    holder.append(legend.kind === "ramp" ? scaleElement(legend) : swatchesElement(legend));
    if (legend.notes.length > 0) {
      holder.append(element("p", "legend-notes", legend.notes.join(" ")));
    }
  };
})(window.meshPage = window.meshPage || {});
