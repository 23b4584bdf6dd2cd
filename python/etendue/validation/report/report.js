for (const split of document.querySelectorAll("input.split")) {
  const slider = document.getElementById(split.getAttribute("aria-controls"));
  const show = () => {
    slider.style.setProperty("--at", split.value + "%");
    split.setAttribute("aria-valuetext", split.value + " % right, the rest wrong");
  };
  const follow = (event) => {
    const box = slider.getBoundingClientRect();
    split.value = Math.round((100 * (event.clientX - box.left)) / box.width);
    show();
  };
  split.addEventListener("input", show);
  slider.addEventListener("pointerdown", (event) => {
    slider.setPointerCapture(event.pointerId);
    follow(event);
  });
  slider.addEventListener("pointermove", (event) => {
    if (slider.hasPointerCapture(event.pointerId)) follow(event);
  });
  // A browser that reloads a page may have kept the place of the slider.
  show();
}
