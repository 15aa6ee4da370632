// Printing: everything open, the view on white; afterwards all as it was.
(function (page) {
  "use strict";

  // stage: null where there is no view.
  page.startPaper = function (stage) {
    let opened = [];
    window.addEventListener("beforeprint", () => {
      opened = Array.from(document.querySelectorAll("details:not([open]):not(.keys)"));
      opened.forEach((details) => { details.open = true; });
      if (stage) {
        stage.setGround("#ffffff");
        stage.render();
      }
    });
    window.addEventListener("afterprint", () => {
      opened.forEach((details) => { details.open = false; });
      if (stage) {
        stage.setGround(null);
      }
    });
  };
})(window.meshPage = window.meshPage || {});
