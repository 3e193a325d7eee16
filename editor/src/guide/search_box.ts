/// Search box of the guide: results below the field while one types. The index is fetched when the field is used first.

import {guideWords} from "./guide_words.ts"
import {type SearchEntry, type SearchResult, search} from "./search.ts"

/// In the language of the page.
const words = guideWords(document.documentElement.lang)

export function openSearch(): void {
  const host = document.querySelector<HTMLElement>("search")
  const field = document.querySelector<HTMLInputElement>("#search")
  const found = document.querySelector<HTMLElement>(".found")
  if (host === null || field === null || found === null) return
  host.hidden = false
  const address = host.dataset.index ?? ""
  let index: Promise<readonly SearchEntry[]> | null = null
  const close = () => {
    found.hidden = true
  }
  const show = async () => {
    const query = field.value.trim()
    if (query === "") return close()
    index ??= fetchIndex(address)
    try {
      const entries = await index
      // The query may have changed meanwhile.
      if (query === field.value.trim()) showResults(found, search(entries, query), query)
    } catch {
      // The service is away; the next letter tries again.
      index = null
      found.replaceChildren(paragraph(words.away))
      found.hidden = false
    }
  }
  field.addEventListener("input", () => void show())
  field.addEventListener("focus", () => void show())
  host.addEventListener("keydown", event => moveFocus(event, field, found, close))
  document.addEventListener("pointerdown", event => {
    if (!host.contains(event.target as Node)) close()
  })
  host.addEventListener("focusout", event => {
    if (event.relatedTarget !== null && !host.contains(event.relatedTarget as Node)) close()
  })
  document.addEventListener("keydown", event => {
    if (event.key !== "/" || event.target instanceof HTMLInputElement) return
    event.preventDefault()
    field.focus()
  })
}

async function fetchIndex(address: string): Promise<readonly SearchEntry[]> {
  const answer = await fetch(address)
  if (!answer.ok) throw new Error(`expected the search index, got ${answer.status}`)
  return answer.json() as Promise<readonly SearchEntry[]>
}

/// Arrow keys go through the results, Escape closes them, Enter in the field opens the first.
function moveFocus(
  event: KeyboardEvent,
  field: HTMLInputElement,
  found: HTMLElement,
  close: () => void,
): void {
  const links = found.hidden ? [] : [...found.querySelectorAll("a")]
  const at = links.indexOf(document.activeElement as HTMLAnchorElement)
  if (event.key === "Escape") {
    close()
    field.focus()
  } else if (event.key === "ArrowDown") (links[at + 1] ?? links.at(-1))?.focus()
  else if (event.key === "ArrowUp") (at > 0 ? links[at - 1] : field)?.focus()
  else if (event.key === "Enter" && at === -1) links[0]?.click()
  else return
  event.preventDefault()
}

function showResults(found: HTMLElement, results: readonly SearchResult[], query: string): void {
  const count = results.length === 0 ? words.nothingAbout(query) : words.places(results.length)
  const status = paragraph(count)
  status.setAttribute("role", "status")
  const list = document.createElement("ul")
  list.append(...results.map(line))
  found.replaceChildren(status, list)
  found.hidden = false
}

function line({entry, excerpt}: SearchResult): HTMLLIElement {
  const link = document.createElement("a")
  link.className = "found-link"
  link.href = `${entry.page}#${entry.anchor}`
  const heading = document.createElement("b")
  heading.textContent = entry.heading
  const page = document.createElement("small")
  page.textContent = entry.heading === entry.title ? "" : entry.title
  const text = document.createElement("span")
  text.textContent = excerpt
  link.append(heading, " ", page, text)
  const item = document.createElement("li")
  item.append(link)
  return item
}

function paragraph(text: string): HTMLParagraphElement {
  const made = document.createElement("p")
  made.textContent = text
  return made
}
