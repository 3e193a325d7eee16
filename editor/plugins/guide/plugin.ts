/// Vite plugin that builds the guide into `guide/` beside the page, from the Markdown files that `docs/contents.json` lists.
///
/// The script and the style sheet are an entry of the build, `src/guide/guide.ts`; pages name the built files.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import type {Plugin, Rollup} from "vite"
import {contentsFile} from "./contents.ts"
import {pageAddress} from "./page_layout.ts"
import {pictureName, readSite} from "./site.ts"

export const guideEntry = "guide"

export function guide(root: string): Plugin {
  return {
    name: "rosy-guide",
    apply: "build",
    async generateBundle(_, bundle) {
      const site = await readSite(root)
      if (site.faults.length > 0)
        this.error([`the guide (${contentsFile}) has faults:`, ...site.faults].join("\n  "))
      const entry = Object.values(bundle).find(
        one => one.type === "chunk" && one.name === guideEntry && one.isEntry,
      )
      if (entry?.type !== "chunk") return this.error(`expected an entry called ${guideEntry}, found none`)
      const asset = (name: string, source: string | Uint8Array) =>
        `../${this.getFileName(this.emitFile({type: "asset", name, source}))}`
      const pictures = new Map(
        site.pictures.map(path => [path, asset(pictureName(path), readFileSync(join(root, path)))]),
      )
      const files = {
        styles: stylesOf(entry, bundle).map(name => `../${name}`),
        script: `../${entry.fileName}`,
        searchIndex: Object.fromEntries(
          [...site.searchIndex].map(([language, entries]) => [
            language,
            asset(`guide-search-${language}.json`, JSON.stringify(entries)),
          ]),
        ),
      }
      for (const [name, source] of site.html(files, path => pictures.get(path) ?? ""))
        this.emitFile({type: "asset", fileName: `guide/${pageAddress(name)}`, source})
    },
  }
}

/// The style sheets of a chunk and of those that it shares with other pages; shared ones come first.
function stylesOf(chunk: Rollup.OutputChunk, bundle: Rollup.OutputBundle): readonly string[] {
  const shared = chunk.imports.flatMap(name => {
    const imported = bundle[name]
    return imported?.type === "chunk" ? stylesOf(imported, bundle) : []
  })
  return [...new Set([...shared, ...(chunk.viteMetadata?.importedCss ?? [])])]
}
