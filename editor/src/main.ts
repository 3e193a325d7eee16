/// Starts the page.

const host = document.getElementById("page")
if (host !== null) host.textContent = "Rosy"
