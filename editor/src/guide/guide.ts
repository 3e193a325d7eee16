/// Script of the guide's pages: the colours that were chosen on Rosy's page, the search, and a sentence for readers of other languages. The pages can be read without it.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "@fontsource/jetbrains-mono/400.css"
import "../styles/tokens.css"
import "../styles/guide.css"
import {openBrowserStorage} from "../browser/browser_storage.ts"
import {chosenLanguage} from "../browser/preferences.ts"
import {openProgramStore} from "../browser/program_store.ts"
import {openSearch} from "./search_box.ts"

/// The scheme that was chosen on Rosy's page, else that of the system.
function applyColourScheme(): void {
  const system = window.matchMedia("(prefers-color-scheme: dark)")
  const {shared, tab} = openBrowserStorage(window)
  const chosen = openProgramStore(shared, tab).preferences().theme
  const apply = () => {
    const dark = chosen === "dark" || (chosen !== "light" && system.matches)
    document.documentElement.dataset.theme = dark ? "dark" : "light"
  }
  system.addEventListener("change", apply)
  apply()
}

/// The guide is written in English; readers of another language are told so in theirs.
async function showLanguageNote(): Promise<void> {
  const {languageFor, loadLanguage} = await import("../words/language_choice.ts")
  const language = languageFor(window.location.search, chosenLanguage(), navigator.languages)
  if (language === "en") return
  await loadLanguage(language)
  const {words} = await import("../words/index.ts")
  const note = document.getElementById("language")
  if (note === null) return
  note.lang = language
  note.textContent = words.guide.isEnglish
  note.hidden = false
}

/// Where there is little room, the contents are folded.
function foldContents(): void {
  const details = document.querySelector<HTMLDetailsElement>(".contents > details")
  if (details !== null && window.matchMedia("(max-width: 56rem)").matches) details.open = false
}

applyColourScheme()
foldContents()
openSearch()
void showLanguageNote()
