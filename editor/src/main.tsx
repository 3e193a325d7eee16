/// Starts the page.

import "@fontsource/inter/400.css"
import "@fontsource/inter/500.css"
import "@fontsource/inter/600.css"
import "@fontsource/inter/700.css"
import "@fontsource/jetbrains-mono/400.css"
import "@fontsource/jetbrains-mono/400-italic.css"
import "@fontsource/jetbrains-mono/500.css"
import "./styles/tokens.css"
import "./styles/page.css"
import "./styles/controls.css"
import "./styles/topbar.css"
import "./styles/regions.css"
import "./styles/room.css"
import "./styles/time.css"
import "./styles/tabs.css"
import "./styles/gallery.css"
import "./styles/lessons.css"
import "./styles/lesson_editor.css"
import "./styles/programs.css"
import "./styles/workshop.css"
import "./styles/robots.css"
import "./styles/haskell_colours.css"
import "./styles/source.css"
import "./styles/share.css"
import "./styles/diagram.css"
import "./styles/room_tests.css"
import "./styles/runs.css"
import "./styles/small.css"
import "./styles/sight.css"
import "./styles/why.css"
import {render} from "preact"
import {App} from "./app/app.tsx"
import {openController} from "./app/app_controller.ts"
import {chosenLanguage} from "./browser/preferences.ts"
import {ControllerContext} from "./ui/app_context.ts"
import {languageFor, loadLanguage} from "./words/language_choice.ts"

const host = document.getElementById("page")
if (host === null) throw new Error("expected #page in index.html, found nothing")

const start = () => {
  // The sign of what is coming (index.html) has done its work.
  host.replaceChildren()
  const controller = openController()
  render(
    <ControllerContext.Provider value={controller}>
      <App />
    </ControllerContext.Provider>,
    host,
  )
}
const fetched = loadLanguage(languageFor(window.location.search, chosenLanguage(), navigator.languages))
if (fetched === undefined) start()
else void fetched.then(start)
