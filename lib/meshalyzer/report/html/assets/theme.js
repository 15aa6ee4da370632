// Light and dark: as the system wishes, or as the switch says.
(function (page) {
  "use strict";

  const kKey = "meshalyzer-theme";
  const darkWish = window.matchMedia("(prefers-color-scheme: dark)");
  const listeners = [];

  // A page opened from a disk may be refused storage; then the switch holds until it is closed.
  function remembered() {
    try {
      return window.localStorage.getItem(kKey);
    } catch (error) {
      return null;
    }
  }

  function remember(theme) {
    try {
      window.localStorage.setItem(kKey, theme);
    } catch (error) {
      return;
    }
  }

  function isDark() {
    const theme = document.documentElement.dataset.theme;
    return theme ? theme === "dark" : darkWish.matches;
  }

  function showState(button) {
    button.setAttribute("aria-pressed", String(isDark()));
    listeners.forEach((listener) => listener());
  }

  page.onTheme = function (listener) {
    listeners.push(listener);
  };

  page.startTheme = function () {
    const theme = remembered();
    if (theme === "dark" || theme === "light") {
      document.documentElement.dataset.theme = theme;
    }
    const header = document.querySelector("header");
    if (!header) {
      return;
    }
    const button = document.createElement("button");
    button.type = "button";
    button.className = "tool theme";
    button.textContent = "Dark";
    button.title = "Dark or light page";
    header.append(button);
    button.addEventListener("click", () => {
      document.documentElement.dataset.theme = isDark() ? "light" : "dark";
      remember(document.documentElement.dataset.theme);
      showState(button);
    });
    darkWish.addEventListener("change", () => showState(button));
    showState(button);
  };
})(window.meshPage = window.meshPage || {});
