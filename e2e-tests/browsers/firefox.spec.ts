import {startFirefox} from "./firefox.ts"
import {shortForm} from "./short_form.ts"

const program = process.env["ROSY_FIREFOX"] ?? "/usr/bin/firefox-esr"

shortForm({
  name: "Firefox",
  programs: [program],
  packages: "firefox-esr",
  start: () => startFirefox(program),
})
