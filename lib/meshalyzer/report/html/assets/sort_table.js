// Tables of class `sortable`: their titles become buttons that order the rows, numbers by size and
// all else by letter; a second press turns the order round. What has no value stands last.
(function () {
  "use strict";

  const order = new Intl.Collator("en", { numeric: true, sensitivity: "base" });

  function textOf(row, column) {
    return row.cells[column].textContent.trim();
  }

  // Counts have their digits in groups: 1,012.
  function numberOf(text) {
    return Number(/^\d{1,3}(,\d{3})+$/.test(text) ? text.replace(/,/g, "") : text);
  }

  function compare(a, b) {
    const x = numberOf(a);
    const y = numberOf(b);
    return Number.isNaN(x) || Number.isNaN(y) ? order.compare(a, b) : x - y;
  }

  function sort(table, column, direction) {
    const body = table.tBodies[0];
    const rows = Array.from(body.rows);
    const isEmpty = (text) => text === "" || text === "-";
    rows.sort((a, b) => {
      const x = textOf(a, column);
      const y = textOf(b, column);
      if (isEmpty(x) || isEmpty(y)) {
        return Number(isEmpty(x)) - Number(isEmpty(y));
      }
      return direction * compare(x, y);
    });
    body.append(...rows);
  }

  function makeSortable(table) {
    const titles = Array.from(table.tHead.rows[0].cells);
    titles.forEach((title, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "sort";
      button.append(...title.childNodes);
      title.append(button);
      button.addEventListener("click", () => {
        const isAscending = title.getAttribute("aria-sort") === "ascending";
        titles.forEach((other) => other.removeAttribute("aria-sort"));
        title.setAttribute("aria-sort", isAscending ? "descending" : "ascending");
        sort(table, column, isAscending ? -1 : 1);
      });
    });
  }

  document.querySelectorAll("table.sortable").forEach(makeSortable);
})();
