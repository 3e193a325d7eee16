/// What the page of all words says about a name: its first sentences, and where to read on. It is fetched once, when somebody first asks.

export interface Explanation {
  readonly words: string
  /// Where the whole of it stands.
  readonly address: string
}

export interface Explanations {
  about(name: string): Promise<Explanation | null>
}

const address = "api-docs/Rosy.html"

export function openExplanations(): Explanations {
  let page: Promise<Document | null> | undefined
  return {
    async about(name) {
      page ??= fetchPage()
      const found = await page
      const place = found?.getElementById(`v:${name}`) ?? found?.getElementById(`t:${name}`)
      if (place == null) return null
      const own = place.closest("tr")?.querySelector("td.doc:not(.empty)")
      const told = own ?? place.closest(".top")?.querySelector(":scope > .doc > p")
      return {words: (told?.textContent ?? "").replace(/\s+/g, " ").trim(), address: `${address}#${place.id}`}
    },
  }
}

async function fetchPage(): Promise<Document | null> {
  try {
    const answer = await fetch(address)
    return answer.ok ? new DOMParser().parseFromString(await answer.text(), "text/html") : null
  } catch (fault) {
    // `fetch` rejects with a TypeError when the service cannot be reached, and for nothing else.
    if (fault instanceof TypeError) return null
    throw fault
  }
}
