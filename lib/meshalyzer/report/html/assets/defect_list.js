// The list of defects: which button is which highlight, which is chosen, what comes next.
(function (page) {
  "use strict";

  // Which highlight of which scene a button shows.
  function placeOf(button) {
    return { sceneIndex: Number(button.dataset.scene), highlightIndex: Number(button.dataset.highlight) };
  }

  class DefectList {
    // chosen(sceneIndex, highlightIndex) is called when a button is pressed.
    constructor(chosen) {
      this.buttons = Array.from(document.querySelectorAll("button.defect"));
      this.pressed = null;
      this.buttons.forEach((button) => button.setAttribute("aria-pressed", "false"));
      document.addEventListener("click", (event) => {
        const button = event.target.closest ? event.target.closest("button.defect") : null;
        if (button) {
          const place = placeOf(button);
          chosen(place.sceneIndex, place.highlightIndex);
        }
      });
    }

    disable() {
      this.buttons.forEach((button) => { button.disabled = true; });
      document.querySelectorAll(".hint").forEach((hint) => { hint.hidden = true; });
    }

    buttonOf(sceneIndex, highlightIndex) {
      return this.buttons.find((button) => {
        const place = placeOf(button);
        return place.sceneIndex === sceneIndex && place.highlightIndex === highlightIndex;
      }) || null;
    }

    // Null, null: none. The focus follows where it was in the list.
    mark(sceneIndex, highlightIndex) {
      const hadFocus = this.buttons.includes(document.activeElement);
      if (this.pressed) {
        this.pressed.setAttribute("aria-pressed", "false");
      }
      this.pressed = sceneIndex === null ? null : this.buttonOf(sceneIndex, highlightIndex);
      if (this.pressed) {
        this.show(this.pressed, hadFocus);
      }
    }

    show(button, takesFocus) {
      button.setAttribute("aria-pressed", "true");
      const details = button.closest("details");
      if (details) {
        details.open = true;
      }
      scrollInList(button);
      if (takesFocus) {
        button.focus({ preventScroll: true });
      }
    }

    // {sceneIndex, highlightIndex} of the button so many places on from the pressed one, round
    // the ends; null where there are no buttons.
    next(step) {
      const count = this.buttons.length;
      if (count === 0) {
        return null;
      }
      const from = this.pressed ? this.buttons.indexOf(this.pressed) : (step > 0 ? -1 : 0);
      return placeOf(this.buttons[(from + step + count) % count]);
    }
  }

  // Only the list itself is scrolled: the view stays where the reader has it.
  function scrollInList(button) {
    const list = button.closest("ol, ul");
    if (!list || list.scrollHeight <= list.clientHeight) {
      return;
    }
    const place = button.getBoundingClientRect();
    const frame = list.getBoundingClientRect();
    if (place.top < frame.top || place.bottom > frame.bottom) {
      list.scrollTop += place.top - frame.top - (frame.height - place.height) / 2;
    }
  }

  page.DefectList = DefectList;
})(window.meshPage = window.meshPage || {});
