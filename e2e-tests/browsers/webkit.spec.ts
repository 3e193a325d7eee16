import {shortForm} from "./short_form.ts"
import {startWebKit} from "./webkit.ts"

const driver = "/usr/bin/WebKitWebDriver"

shortForm({
  name: "WebKit",
  programs: [driver, "/usr/bin/Xvfb"],
  packages: "webkit2gtk-driver xvfb",
  start: () => startWebKit(driver),
})
