// Light, dark, or as the system has it: Debian's theme comes without the program of its button.
addEventListener("DOMContentLoaded", () => {
  document.documentElement.classList.remove("no-js");
  for (const button of document.getElementsByClassName("theme-toggle"))
    button.onclick = () => {
      const themes = ["auto", "light", "dark"], theme = document.body.dataset.theme;
      localStorage.setItem("theme", document.body.dataset.theme = themes[(themes.indexOf(theme) + 1) % 3]);
    };
});
