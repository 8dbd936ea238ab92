"use strict";
(() => {
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const cards = all("article");
  const rows = new Map(all("#overview tbody tr").map((row) => [row.dataset.for, row]));
  const search = document.getElementById("search");
  const sort = document.getElementById("sort");
  const shown = document.getElementById("shown");
  let verdict = "all";

  // ---- One viewer: side by side, slider, blink
  const set_mode = (card, mode) => {
    const viewer = card.querySelector(".viewer");
    if (!viewer || !viewer.querySelector(".right img")) return;
    viewer.dataset.mode = mode;
    for (const button of all("[data-set]", card)) {
      button.setAttribute("aria-pressed", String(button.dataset.set === mode));
    }
  };
  const set_split = (card, percent) => {
    const value = Math.min(100, Math.max(0, percent));
    card.querySelector(".viewer").style.setProperty("--split", value + "%");
    card.querySelector(".split").value = value;
  };
  for (const card of cards) {
    for (const button of all("[data-set]", card)) {
      button.addEventListener("click", () => set_mode(card, button.dataset.set));
    }
    const split = card.querySelector(".split");
    if (split) split.addEventListener("input", () => set_split(card, Number(split.value)));
    for (const frame of all(".stack", card)) {
      const drag = (event) => {
        if (card.querySelector(".viewer").dataset.mode !== "slider") return;
        if (event.type === "pointermove" && event.buttons === 0) return;
        const box = frame.getBoundingClientRect();
        set_split(card, ((event.clientX - box.left) / box.width) * 100);
        event.preventDefault();
      };
      frame.addEventListener("pointerdown", drag);
      frame.addEventListener("pointermove", drag);
    }
  }

  // ---- Rings
  const set_rings = (card, on) => {
    const viewer = card.querySelector(".viewer");
    if (!viewer) return;
    viewer.classList.toggle("no-rings", !on);
    for (const box of all(".rings input", card)) box.checked = on;
  };
  for (const card of cards) {
    for (const box of all(".rings input", card)) {
      box.addEventListener("change", () => set_rings(card, box.checked));
    }
  }

  // ---- Loupe: both pictures around a place, and their values there
  const reach = 5;  // pixels to each side
  const bytes_of = (image) => {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height);
  };
  const linear = (byte) => {
    const v = byte / 255;
    return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
  };
  const reader_of = (card, side, width, height) => {
    const high = card.querySelector(`.${side}-high`);
    const shown = bytes_of(card.querySelector(`.${side} .frame img`));
    const exact = high && [bytes_of(high), bytes_of(card.querySelector(`.${side}-low`))];
    return (x, y) => {
      if (exact) {
        const at = 4 * (y * width + x);
        return [0, 1, 2].map((c) => (256 * exact[0].data[at + c] + exact[1].data[at + c]) / 65535);
      }
      const px = Math.min(shown.width - 1, Math.floor((x + 0.5) * shown.width / width));
      const py = Math.min(shown.height - 1, Math.floor((y + 0.5) * shown.height / height));
      return [0, 1, 2].map((c) => linear(shown.data[4 * (py * shown.width + px) + c]));
    };
  };
  for (const card of cards) {
    const loupe = card.querySelector(".loupe");
    if (!loupe || !card.querySelector(".right .frame img") || !card.querySelector(".left .frame img")) continue;
    const width = Number(loupe.dataset.width);
    const height = Number(loupe.dataset.height);
    const exact = Boolean(card.querySelector(".left-high"));
    let readers = null;
    let held = false;
    const show = (x, y) => {
      readers = readers || { left: reader_of(card, "left", width, height), right: reader_of(card, "right", width, height) };
      const values = {};
      for (const side of ["left", "right"]) {
        const glass = loupe.querySelector("." + side);
        glass.hidden = false;
        const canvas = glass.querySelector("canvas");
        const size = canvas.width / (2 * reach + 1);
        const context = canvas.getContext("2d");
        context.fillStyle = "#000";
        context.fillRect(0, 0, canvas.width, canvas.height);
        for (let j = -reach; j <= reach; ++j) {
          for (let i = -reach; i <= reach; ++i) {
            if (x + i < 0 || y + j < 0 || x + i >= width || y + j >= height) continue;
            const encoded = readers[side](x + i, y + j).map((v) =>
              Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055)));
            context.fillStyle = `rgb(${encoded})`;
            context.fillRect((i + reach) * size, (j + reach) * size, size, size);
          }
        }
        for (const [style, inset] of [["#000", 0], ["#fff", 1]]) {
          context.strokeStyle = style;
          context.strokeRect(reach * size - 0.5 - inset, reach * size - 0.5 - inset, size + 1 + 2 * inset, size + 1 + 2 * inset);
        }
        values[side] = readers[side](x, y);
        glass.querySelector("output").textContent = values[side].map((v) => v.toFixed(exact ? 6 : 3)).join("\n");
      }
      const change = loupe.querySelector(".change");
      change.hidden = false;
      change.querySelector("output").textContent = values.left.map((v, c) => {
        const d = values.right[c] - v;
        return (d < 0 ? "\u2212" : "+") + Math.abs(d).toFixed(exact ? 6 : 3);
      }).join("\n");
      loupe.querySelector(".at").textContent = `Pixel ${x}, ${y}${held ? ", held; click it again to go on" : ""}. ` +
        (exact ? "Linear light, in steps of 1/65535." : "Linear light, of the 8 bits that this page shows.");
    };
    const place = (event, frame) => {
      const box = frame.getBoundingClientRect();
      const at = (share, size) => Math.min(size - 1, Math.max(0, Math.floor(share * size)));
      return [at((event.clientX - box.left) / box.width, width), at((event.clientY - box.top) / box.height, height)];
    };
    for (const frame of all(".frame", card)) {
      frame.addEventListener("pointermove", (event) => { if (!held) show(...place(event, frame)); });
      frame.addEventListener("click", (event) => { held = !held; show(...place(event, frame)); });
    }
    for (const link of all("a[data-pixel]", card)) {
      link.addEventListener("click", (event) => {
        held = true;
        show(...link.dataset.pixel.split(",").map(Number));
        card.querySelector(".viewer").scrollIntoView({ block: "start" });
        event.preventDefault();
      });
    }
  }

  // ---- Filter and order
  const apply = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const card of cards) {
      const text = card.dataset.text;
      const visible = (verdict === "all" || card.dataset.verdict === verdict) &&
        words.every((word) => text.includes(word));
      card.hidden = !visible;
      const row = rows.get(card.id);
      if (row) row.hidden = !visible;
      if (visible) ++count;
    }
    shown.textContent = count === cards.length ? `${count} shown` : `${count} of ${cards.length} shown`;
  };
  const order = () => {
    const number = (key) => (a, b) => Number(b.dataset[key]) - Number(a.dataset[key]);
    const by = {
      urgency: (a, b) => Number(a.dataset.rank) - Number(b.dataset.rank),
      name: (a, b) => a.dataset.name.localeCompare(b.dataset.name),
      largest: number("largest"),
      seconds: number("seconds"),
    }[sort.value];
    const body = document.querySelector("#overview tbody");
    for (const card of [...cards].sort(by)) {
      card.parentNode.appendChild(card);
      if (rows.has(card.id)) body.appendChild(rows.get(card.id));
    }
  };
  search.addEventListener("input", apply);
  sort.addEventListener("change", order);
  for (const button of all("[data-verdict-filter]")) {
    button.addEventListener("click", () => {
      verdict = button.dataset.verdictFilter;
      for (const other of all("[data-verdict-filter]")) {
        other.setAttribute("aria-pressed", String(other === button));
      }
      apply();
    });
  }

  // ---- Light and dark
  document.getElementById("theme").addEventListener("click", () => {
    const root = document.documentElement;
    const dark = root.dataset.theme
      ? root.dataset.theme === "dark"
      : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });

  // ---- Keyboard
  const current = () => {
    const focused = document.activeElement && document.activeElement.closest("article");
    if (focused && !focused.hidden) return focused;
    const middle = innerHeight * 0.4;
    return cards.filter((card) => !card.hidden).find((card) => card.getBoundingClientRect().bottom > middle);
  };
  const go = (step) => {
    const visible = all("article").filter((card) => !card.hidden);
    if (visible.length === 0) return;
    const focused = document.activeElement && document.activeElement.closest("article");
    const at = visible.indexOf(focused);
    const next = visible[Math.min(visible.length - 1, Math.max(0, at < 0 ? 0 : at + step))];
    next.focus({ preventScroll: true });
    next.scrollIntoView({ block: "start" });
  };
  addEventListener("keydown", (event) => {
    const typing = event.target.matches("input[type=search], select");
    if (event.key === "Escape" && typing) { search.value = ""; apply(); event.target.blur(); return; }
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const card = current();
    const split = card && card.querySelector(".split");
    const keys = {
      "/": () => search.focus(),
      "j": () => go(1),
      "k": () => go(-1),
      "1": () => card && set_mode(card, "side"),
      "2": () => card && set_mode(card, "slider"),
      "3": () => card && set_mode(card, "blink"),
      "r": () => card && card.querySelector(".rings input") && set_rings(card, !card.querySelector(".rings input").checked),
    };
    if (split && card.querySelector(".viewer").dataset.mode === "slider" && event.target !== split) {
      keys.ArrowLeft = () => set_split(card, Number(split.value) - 2);
      keys.ArrowRight = () => set_split(card, Number(split.value) + 2);
    }
    if (keys[event.key]) { keys[event.key](); event.preventDefault(); }
  });

  document.documentElement.classList.add("live");
  apply();
})();
