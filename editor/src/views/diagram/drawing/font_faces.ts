/// Fonts of texts as `@font-face` rules with the font in them, for a file that is to look the same without the page.

/// The rules for the families, weights and characters of these texts; a font that cannot be read is left out.
export async function fontFaces(texts: Iterable<SVGTextElement>): Promise<string> {
  const wanted = new Map<string, Set<number>>()
  for (const text of texts) {
    const {fontFamily, fontWeight} = getComputedStyle(text)
    const key = faceKey(fontFamily.split(",")[0] ?? "", fontWeight)
    const characters = wanted.get(key) ?? new Set()
    wanted.set(key, characters)
    for (const character of text.textContent ?? "") characters.add(character.codePointAt(0) ?? 0)
  }
  const rules = [...document.styleSheets].flatMap(rulesOf).filter(({style}) => {
    const family = style.getPropertyValue("font-family")
    const characters = wanted.get(faceKey(family, style.getPropertyValue("font-weight")))
    const isUpright = !style.getPropertyValue("font-style").includes("italic")
    return (
      isUpright && characters !== undefined && covers(style.getPropertyValue("unicode-range"), characters)
    )
  })
  return (await Promise.all(rules.map(embedded))).join("\n")
}

const faceKey = (family: string, weight: string) => `${family.replaceAll(/["']/g, "").trim()} ${weight}`

/// The fonts that a style sheet has; one of another server may not be read.
function rulesOf(sheet: CSSStyleSheet): readonly CSSFontFaceRule[] {
  try {
    return [...sheet.cssRules].filter(rule => rule instanceof CSSFontFaceRule)
  } catch {
    return []
  }
}

/// Whether a `unicode-range` has one of the characters; without one it has all.
export function covers(ranges: string, characters: ReadonlySet<number>): boolean {
  if (ranges === "") return characters.size > 0
  const parsed = [...ranges.matchAll(/U\+([\da-f?]+)(?:-([\da-f]+))?/gi)].map(([, from = "", to]) => [
    Number.parseInt(from.replaceAll("?", "0"), 16),
    Number.parseInt(to ?? from.replaceAll("?", "f"), 16),
  ])
  return [...characters].some(one => parsed.some(([from = 0, to = 0]) => from <= one && one <= to))
}

async function embedded(rule: CSSFontFaceRule): Promise<string> {
  const address = /url\("?([^")]+)"?\)/.exec(rule.style.getPropertyValue("src"))?.[1]
  if (address === undefined) return ""
  try {
    const base = rule.parentStyleSheet?.href ?? document.baseURI
    // The build puts small fonts into the style sheet, and the page may request nothing but files of its service.
    const font = address.startsWith("data:") ? address : await fetched(new URL(address, base))
    const family = rule.style.getPropertyValue("font-family")
    const weight = rule.style.getPropertyValue("font-weight")
    return `@font-face{font-family:${family};font-weight:${weight};src:url(${font})}`
  } catch {
    return ""
  }
}

async function fetched(address: URL): Promise<string> {
  return dataUrl(await (await fetch(address)).blob())
}

function dataUrl(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader()
    reader.onload = () => resolve(String(reader.result))
    reader.onerror = () => reject(reader.error ?? new Error("expected a font that can be read"))
    reader.readAsDataURL(blob)
  })
}
