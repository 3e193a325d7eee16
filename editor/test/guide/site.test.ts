/// The guide's Markdown files: converted without a fault, with links that lead somewhere and programs that open.

import {readFileSync} from "node:fs"
import {dirname, join} from "node:path"
import {fileURLToPath} from "node:url"
import {describe, expect, test} from "vitest"
import {isTranslated, translatedFile, translations} from "../../plugins/guide/contents.ts"
import {convertMarkdown, type Resolver} from "../../plugins/guide/markdown.ts"
import {readSite} from "../../plugins/guide/site.ts"
import {programIn} from "../../src/browser/share_link.ts"
import {allGuideLinks} from "../../src/help/guide_links.ts"

const root = fileURLToPath(new URL("../../..", import.meta.url))
const site = await readSite(root)
const files = {
  styles: ["../assets/guide.css"],
  script: "../assets/guide.js",
  searchIndex: Object.fromEntries(
    ["en", ...translations(root)].map(language => [language, `../assets/guide-${language}.json`]),
  ),
}
const pages = site.html(files, path => `../assets/${path}`)

const targets = (html: string, attribute: "href" | "src") =>
  [...html.matchAll(new RegExp(`${attribute}="([^"]*)"`, "g"))].map(([, target = ""]) => target)

test("has no faults: each link, picture and anchor exists", () => {
  expect(site.faults).toEqual([])
  expect(pages.size).toBeGreaterThan(5)
})

const leavesGuide = (name: string, target: string) =>
  target.startsWith("data:") || join(dirname(name), target).startsWith("../")

test("every link inside the guide leads to a page and to an anchor of it", () => {
  const dead = [...pages].flatMap(([name, html]) =>
    targets(html, "href")
      .filter(target => !leavesGuide(name, target))
      .filter(target => {
        const [page = "", anchor = ""] = target.replace(/\?lang=\w+/, "").split("#")
        const led = page === "" ? html : pages.get(join(dirname(name), page).replace(/\.html$/, ""))
        return led === undefined || (anchor !== "" && !led.includes(`id="${anchor}"`))
      })
      .map(target => `${name}: ${target}`),
  )
  expect(dead).toEqual([])
})

test("every link has words", () => {
  const silent = [...pages]
    .filter(([, html]) => /<a [^>]*href="[^"]*"[^>]*><\/a>/.test(html))
    .map(([name]) => name)
  expect(silent).toEqual([])
})

test("every page of Rosy that leads into the guide leads to a page and to an anchor of it", () => {
  const dead = allGuideLinks.filter(address => {
    const [page = "", anchor = ""] = address.replace(/^guide\//, "").split("#")
    const led = pages.get(page.replace(/\.html$/, ""))
    return led === undefined || (anchor !== "" && !led.includes(`id="${anchor}"`))
  })
  expect(dead).toEqual([])
})

test("every page is reached by turning pages from the first one", () => {
  const order = site.chapters.flatMap(chapter => chapter.pages.map(page => page.name))
  expect(order[0]).toBe("index")
  for (const [i, name] of order.entries())
    if (i + 1 < order.length) expect(pages.get(name)).toContain(`rel="next" href="${order[i + 1]}.html"`)
})

test("a page loads nothing from elsewhere, and contains no script and no style of its own", () => {
  for (const [name, html] of pages) {
    expect(html, name).not.toMatch(/(?:src|href)="(?:https?:)?\/\//)
    expect(html, name).not.toMatch(/<style|style="|<script(?![^>]*src=)| on\w+="/)
  }
})

test("every link to a program contains the program that is shown", async () => {
  let count = 0
  for (const html of pages.values())
    for (const target of targets(html, "href").filter(one => /^(?:\.\.\/)+#program=/.test(one))) {
      const opened = await programIn(target.slice(target.indexOf("#")))
      if (opened.kind !== "program") throw new Error(`expected a program, got ${opened.kind}`)
      expect(JSON.parse(opened.text)).toMatchObject({rosy: 1, layout: {declarations: [], loose: []}})
      count += 1
    }
  expect(count).toBeGreaterThan(0)
})

test("the search knows every heading of the language reference", () => {
  const reference = readFileSync(`${root}/rosy-hs/LANGUAGE.md`, "utf8")
  const headings = reference.match(/^#+ /gm)?.length
  expect((site.searchIndex.get("en") ?? []).filter(entry => entry.page === "language.html")).toHaveLength(
    headings ?? 0,
  )
})

describe.each(translations(root))("in %s", language => {
  const translated = site.chapters
    .flatMap(chapter => chapter.pages)
    .filter(page => isTranslated(root, page.file, language))
  const {textOf} = site

  test.each(translated)("$name has the programs, pictures and anchors of the English page", ({file}) => {
    for (const pattern of [/^```haskell[\s\S]*?^```$/gm, /!\[[^\]]*\]\(([^)]*)\)/g, /<a id="[^"]*">/g]) {
      const found = (one: string) => [...textOf(one).matchAll(pattern)].map(match => match[1] ?? match[0])
      expect(found(translatedFile(file, language)).map(withoutFolder)).toEqual(found(file).map(withoutFolder))
    }
  })

  test("every page leads to the one in English, and back", () => {
    for (const {name} of translated) {
      expect(pages.get(`${language}/${name}`)).toContain(`href="../${name}.html?lang=en"`)
      expect(pages.get(name)).toContain(`hreflang="${language}" href="${language}/${name}.html"`)
    }
  })

  test("the contents name every page, and say which are in English", () => {
    const html = pages.get(`${language}/index`) ?? ""
    const all = site.chapters.flatMap(chapter => chapter.pages)
    // The page is there in English and in the other languages as well.
    expect(html.match(/<li><a/g)).toHaveLength(all.length + translations(root).length)
    expect(html.match(/<small>\(/g) ?? []).toHaveLength(all.length - translated.length)
  })
})

const withoutFolder = (text: string) => text.replace(/^(?:\.\.\/)+/, "")

const resolver: Resolver = {
  link: target => (target.startsWith("there") ? {kind: "page", address: "there.html"} : null),
  picture: path => (path === "run.svg" ? {address: path, still: "end.svg", width: 4, height: 3} : null),
  openAddress: (program, room) => `../#${room}:${program.trim()}`,
}

test("names what a page must not contain", () => {
  const text = "words\n\n[gone](gone) ![](gone.png) <b>bold</b>\n"
  expect(convertMarkdown(text, resolver).faults).toEqual([
    "has no title",
    "links to gone, which does not exist",
    "shows gone.png, which does not exist",
    "shows gone.png without words for those who do not see it",
    "contains HTML: <b>",
    "contains HTML: </b>",
  ])
})

test("a heading keeps its own anchor, else gets one from its words; equal ones are numbered", () => {
  const {anchors, html} = convertMarkdown('# A\n## <a id="R1"></a>R1 `b`\n## C d!\n## C d\n', resolver)
  expect([...anchors]).toEqual(["a", "R1", "c-d", "c-d-2"])
  expect(html).toContain('<h2 id="R1">R1 <code>b</code>')
})

test("a program is coloured, escaped and linked with its room; a fragment has no link", () => {
  const whole = convertMarkdown("# A\n```haskell room=table\nx = Velocity 0.5 0 -- <b>\n```\n", resolver).html
  expect(whole).toContain('<span class="type">Velocity</span> <span class="number">0.5</span>')
  expect(whole).toContain('<span class="comment">-- &lt;b&gt;</span>')
  expect(whole).toContain("../#table:x = Velocity 0.5 0 -- &lt;b&gt;")
  expect(convertMarkdown("# A\n```haskell fragment\nx = 1\n```\n", resolver).html).not.toContain(
    "Open in Rosy",
  )
})

test("an animation has a picture that stands, for reduced motion and for paper", () => {
  const {html} = convertMarkdown("# A\n![Runs](run.svg)\n", resolver)
  expect(html).toContain('<source media="print, (prefers-reduced-motion: reduce)" srcset="end.svg">')
  expect(html).toContain('<img src="run.svg" alt="Runs" width="4" height="3"')
})
