// Stacks the two pictures of every slider; its range says how much of the left one is shown.
document.documentElement.classList.add("script");
for (const slider of document.querySelectorAll(".slider")) {
  const range = slider.querySelector("input");
  const show = () => slider.style.setProperty("--cut", range.value + "%");
  range.hidden = false;
  range.addEventListener("input", show);
  show();
}
