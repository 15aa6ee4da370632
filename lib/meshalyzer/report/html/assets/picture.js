// The view and its legend as one picture, for papers and mails.
(function (page) {
  "use strict";

  const kMargin = 20;
  const kLine = 22;

  function drawRamp(context, legend, width, top) {
    const bar = context.createLinearGradient(kMargin, 0, width - kMargin, 0);
    legend.stops.forEach((stop, i) => bar.addColorStop(i / (legend.stops.length - 1), stop));
    context.fillStyle = bar;
    context.fillRect(kMargin, top, width - 2 * kMargin, 12);
    context.fillStyle = page.styleColour("--ink");
    for (const tick of legend.ticks) {
      const x = kMargin + tick.at * (width - 2 * kMargin);
      const half = context.measureText(tick.text).width / 2;
      context.fillRect(x - 0.5, top + 12, 1, 4);
      context.fillText(tick.text, Math.max(2, Math.min(width - 2 * half - 2, x - half)), top + 30);
    }
    return top + 34;
  }

  function drawSwatches(context, legend, width, top) {
    let x = kMargin;
    let y = top;
    for (const swatch of legend.swatches) {
      const length = 20 + context.measureText(swatch.text).width + 18;
      if (x > kMargin && x + length > width - kMargin) {
        x = kMargin;
        y += kLine;
      }
      context.fillStyle = swatch.colour;
      context.fillRect(x, y, 13, 13);
      context.fillStyle = page.styleColour("--ink");
      context.fillText(swatch.text, x + 20, y + 12);
      x += length;
    }
    return y + kLine;
  }

  function drawLegend(context, legend, width, top) {
    context.font = "600 14px system-ui, sans-serif";
    context.fillStyle = page.styleColour("--ink");
    context.fillText(legend.title, kMargin, top + 14);
    context.font = "13px system-ui, sans-serif";
    const draw = legend.kind === "ramp" ? drawRamp : drawSwatches;
    return draw(context, legend, width, top + kLine);
  }

  function legendCanvas(legend, width, ratio) {
    const canvas = document.createElement("canvas");
    canvas.width = width * ratio;
    canvas.height = 400 * ratio;
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    const height = legend.kind === "plain" ? 0 : drawLegend(context, legend, width, 10) + 6;
    return { canvas: canvas, height: Math.min(canvas.height, Math.round(height * ratio)) };
  }

  // A canvas with the view above its legend.
  page.pictureOf = function (viewCanvas, legend) {
    const ratio = viewCanvas.width / viewCanvas.clientWidth;
    const below = legendCanvas(legend, viewCanvas.clientWidth, ratio);
    const whole = document.createElement("canvas");
    whole.width = viewCanvas.width;
    whole.height = viewCanvas.height + below.height;
    const context = whole.getContext("2d");
    context.fillStyle = page.styleColour("--view");
    context.fillRect(0, 0, whole.width, whole.height);
    context.drawImage(viewCanvas, 0, 0);
    if (below.height > 0) {
      context.drawImage(below.canvas, 0, 0, whole.width, below.height, 0, viewCanvas.height, whole.width, below.height);
    }
    return whole;
  };

  page.savePicture = function (canvas, name) {
    canvas.toBlob((blob) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }, "image/png");
  };
})(window.meshPage = window.meshPage || {});
