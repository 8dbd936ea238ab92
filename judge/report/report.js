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
