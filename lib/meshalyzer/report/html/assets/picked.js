// The panel that tells of a face that was clicked.
(function (page) {
  "use strict";

  function rowOf(head, cells) {
    const row = document.createElement("tr");
    const name = document.createElement("th");
    name.scope = "row";
    name.textContent = head;
    row.append(name);
    for (const text of cells) {
      const cell = document.createElement("td");
      cell.textContent = text;
      row.append(cell);
    }
    row.lastChild.colSpan = 4 - cells.length;
    return row;
  }

  function valueText(data, field, value) {
    const isNumber = field.kind !== "category" || Number.isNaN(value);
    return isNumber ? page.numberText(value, 5) : data.categoryText(field, value);
  }

  page.titleOfPick = function (pick) {
    const name = "Face " + pick.faceId;
    return pick.part === "context" ? name + " (of the decimated part: stands for its neighbours too)" : name;
  };

  page.showPick = function (data, pick) {
    document.getElementById("picked-title").textContent = page.titleOfPick(pick);
    const rows = document.getElementById("picked-rows");
    rows.textContent = "";
    pick.vertexIds.forEach((id, k) => {
      rows.append(rowOf("vertex " + id, pick.places[k].map((x) => page.numberText(x, 7))));
    });
    for (const entry of pick.values) {
      rows.append(rowOf(entry.field.label, entry.values.map((value) => valueText(data, entry.field, value))));
    }
    document.getElementById("picked").hidden = false;
  };

  page.hidePick = function () {
    document.getElementById("picked").hidden = true;
  };
})(window.meshPage = window.meshPage || {});
