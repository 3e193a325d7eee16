/// Script of the guide's pages: the colours that were chosen on Rosy's page, the search, the buttons of animations, and the way to the reader's language. The pages can be read without it.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "@fontsource/jetbrains-mono/400.css"
import "../styles/tokens.css"
import "../styles/guide.css"
import {applyColourScheme} from "../browser/colour_scheme.ts"
import {chosenLanguage} from "../browser/preferences.ts"
import {addAnimationButtons} from "./animation_buttons.ts"
import {guideWords} from "./guide_words.ts"
import {openSearch} from "./search_box.ts"

/// A page that a tab opens first is shown in the reader's language if it is translated. Readers of an English page that is not
/// translated are told so in their language. A language in the address (`?lang=en`) is kept.
async function showReadersLanguage(): Promise<void> {
  const {languageFor, loadLanguage} = await import("../words/language_choice.ts")
  const {search, hash} = window.location
  const language = languageFor(search, chosenLanguage(), navigator.languages)
  if (language === document.documentElement.lang) return
  const translated = document.querySelector<HTMLLinkElement>(`link[rel="alternate"][hreflang="${language}"]`)
  if (translated !== null && isFirstOfTab() && search === "") {
    window.location.replace(translated.href + hash)
    return
  }
  const note = document.getElementById("language")
  if (note === null || language === "en" || document.documentElement.lang !== "en") return
  await loadLanguage(language)
  // The page itself stays English.
  document.documentElement.lang = "en"
  document.documentElement.dir = "ltr"
  const {words} = await import("../words/index.ts")
  note.lang = language
  if (translated === null) note.textContent = words.guide.isEnglish
  else {
    const link = document.createElement("a")
    link.href = translated.href
    link.textContent = guideWords(language).readHere
    note.append(link)
  }
  note.hidden = false
}

/// Whether no page of the guide was open in this tab before. Without storage each one counts as a later one, so that no page sends its reader elsewhere twice.
function isFirstOfTab(): boolean {
  try {
    const isFirst = window.sessionStorage.getItem("rosy-guide") === null
    window.sessionStorage.setItem("rosy-guide", "open")
    return isFirst
  } catch {
    return false
  }
}

/// Where there is little room, the contents are folded.
function foldContents(): void {
  const details = document.querySelector<HTMLDetailsElement>(".contents > details")
  if (details !== null && window.matchMedia("(max-width: 56rem)").matches) details.open = false
}

applyColourScheme()
foldContents()
addAnimationButtons()
openSearch()
void showReadersLanguage()
