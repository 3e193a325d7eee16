/// Page of the Prelude's names: each with its type and an example. Help links lead to its anchors.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "@fontsource/jetbrains-mono/400.css"
import "../styles/tokens.css"
import "../styles/help.css"
import {blockView, type KnownName, preludeNames} from "@rosy/codegen"
import {chosenLanguage} from "../browser/preferences.ts"
import {words} from "../words/index.ts"
import {languageFor, loadLanguage} from "../words/language_choice.ts"
import {guidePage, placeOf} from "./help_links.ts"

/// What the block that says a name says about it.
function told({name, kind, type}: KnownName): string {
  const inputs = type.split("=>").at(-1)?.split(" -> ").length ?? 1
  const [block, extra] =
    kind === "constructor"
      ? ["construct", {con: name}]
      : /^[\p{L}_]/u.test(name)
        ? ["name", {name, args: inputs - 1}]
        : ["infix", {op: name}]
  return kind === "type"
    ? ""
    : (blockView(block as string)?.shape(extra as Record<string, string>).tooltip ?? "")
}

function entry(known: KnownName): HTMLElement {
  const section = document.createElement("section")
  section.id = placeOf(`${known.kind === "type" ? "t" : "v"}:${known.name}`)
  const name = document.createElement("h2")
  name.textContent = known.name
  const type = document.createElement("code")
  type.dir = "ltr"
  type.textContent = known.kind === "type" ? known.type : `${known.name} :: ${known.type}`
  const says = document.createElement("p")
  says.textContent = told(known)
  section.append(name, type, says)
  return section
}

function show(): void {
  document.title = words.help.title
  const title = document.createElement("h1")
  title.textContent = words.help.title
  const lead = document.createElement("p")
  lead.textContent = words.help.lead
  const more = document.createElement("a")
  more.href = guidePage
  more.textContent = words.guide.more
  document.getElementById("names")?.append(title, lead, more, ...preludeNames().map(entry))
  // What the address names was not there yet when the page was opened.
  document.getElementById(decodeURIComponent(window.location.hash.slice(1)))?.scrollIntoView()
}

const fetched = loadLanguage(languageFor(window.location.search, chosenLanguage(), navigator.languages))
if (fetched === undefined) show()
else void fetched.then(show)
