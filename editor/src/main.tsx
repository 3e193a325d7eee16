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
import "./styles/workshop.css"
import "./styles/robots.css"
import "./styles/source.css"
import "./styles/small.css"
import "./styles/sight.css"
import {render} from "preact"
import {openDesk} from "./desk/desk.ts"
import {App} from "./page/app.tsx"
import {DeskContext} from "./page/pick.ts"
import {chosenLanguage} from "./run/liking.ts"
import {sessionAddress} from "./run/session.ts"
import {languageFor, use} from "./words/languages.ts"

const host = document.getElementById("page")
if (host === null) throw new Error("expected #page in index.html, found nothing")

const start = () => {
  // The sign of what is coming (index.html) has done its work.
  host.replaceChildren()
  const desk = openDesk(sessionAddress(window.location))
  render(
    <DeskContext.Provider value={desk}>
      <App />
    </DeskContext.Provider>,
    host,
  )
}
const fetched = use(languageFor(window.location.search, chosenLanguage(), navigator.languages))
if (fetched === undefined) start()
else void fetched.then(start)
