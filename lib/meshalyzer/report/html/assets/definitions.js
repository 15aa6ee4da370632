// Definitions in the tables show while pointed at or focused; Esc puts them away, as it should
// with anything that comes up by itself.
(function () {
  "use strict";

  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      document.body.classList.add("no-definitions");
    }
  });
  for (const type of ["mouseover", "focusin"]) {
    document.addEventListener(type, (event) => {
      if (event.target.closest && event.target.closest(".term")) {
        document.body.classList.remove("no-definitions");
      }
    });
  }
})();
