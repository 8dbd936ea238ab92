(() => {
  "use strict";
  const root = document.documentElement;
  root.classList.add("live");

  for (const article of document.querySelectorAll("article")) {
    const one = (selector) => article.querySelector(selector);
    const points = [...article.querySelectorAll(".point")];
    // Ordered by time, from left to right.
    const order = [...article.querySelectorAll(".settings tbody tr")].map((row) => row.dataset.setting);
    points.sort((a, b) => order.indexOf(a.dataset.setting) - order.indexOf(b.dataset.setting));
    const details = new Map([...article.querySelectorAll(".detail")].map((d) => [d.id.split("-")[1], d]));

    const show = (setting) => {
      for (const e of article.querySelectorAll(".now")) e.classList.remove("now");
      details.get(setting).classList.add("now");
      for (const e of article.querySelectorAll(`.point[data-setting="${setting}"], tr[data-setting="${setting}"]`)) {
        e.classList.add("now");
      }
      for (const p of points) p.setAttribute("tabindex", p.dataset.setting === setting ? "0" : "-1");
    };

    for (const e of article.querySelectorAll("[data-setting]")) {
      e.addEventListener("mouseenter", () => show(e.dataset.setting));
      e.addEventListener("focusin", () => show(e.dataset.setting));
      e.addEventListener("click", (event) => {
        show(e.dataset.setting);
        // Makes an address for sharing, without a jump.
        history.replaceState(null, "", `#${details.get(e.dataset.setting).id}`);
        event.preventDefault();
      });
    }
    one(".scatter").addEventListener("keydown", (event) => {
      const at = points.indexOf(event.target.closest(".point"));
      const best = points.filter((p) => !p.classList.contains("beaten"));
      const near = (step) => {
        const next = points.filter((p, i) => best.includes(p) && (step > 0 ? i > at : i < at));
        return step > 0 ? next[0] : next[next.length - 1];
      };
      const next = {
        ArrowRight: () => points[at + 1],
        ArrowLeft: () => points[at - 1],
        ArrowDown: () => near(1),
        ArrowUp: () => near(-1),
        Home: () => points[0],
        End: () => points[points.length - 1],
      }[event.key];
      if (at < 0 || !next) return;
      event.preventDefault();
      const point = next();
      if (point) point.focus();
    });
    const asked = [...details].find(([, d]) => `#${d.id}` === location.hash);
    show((asked || [...details].find(([, d]) => d.classList.contains("first")))[0]);
  }

  document.getElementById("theme").addEventListener("click", () => {
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
  });
})();
