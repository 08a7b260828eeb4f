// The button that copies the address of what is shown.

/** Returns the whole address of the program's state. */
function addressOf(program) {
  const link = program.link();
  return location.href.replace(/#.*$/, "") + (link ? `#${link}` : "");
}

/** Joins the Share button. Where the clipboard is refused, the address is shown, selected, to be copied. */
export function joinShareButton(program, notify) {
  const button = document.getElementById("share");
  let timer = 0;
  button.onclick = async () => {
    const address = addressOf(program);
    try {
      await navigator.clipboard.writeText(address);
      button.textContent = "Copied";
      clearTimeout(timer);
      timer = setTimeout(() => (button.textContent = "Share"), 1600);
      notify(null, "share");
    } catch {
      const notice = notify("The browser does not let the page copy. Copy this address:", "share");
      const field = document.createElement("input");
      field.readOnly = true;
      field.value = address;
      field.setAttribute("aria-label", "Address of what is shown");
      notice.querySelector("span").append(field);
      field.select();
    }
  };
}
