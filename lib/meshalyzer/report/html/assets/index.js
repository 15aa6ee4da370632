// Starts a page without a view: the index of a set.
(function (page) {
  "use strict";

  document.addEventListener("DOMContentLoaded", () => {
    page.startTheme();
    page.startPaper(null);
  });
})(window.meshPage = window.meshPage || {});
