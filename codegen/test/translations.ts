/// Tag and words on blocks of every language, for what holds in each of them.

import {en} from "../../languages/en/blocks/index.ts"
import type {Words} from "../src/words/index.ts"

const others = import.meta.glob<Words>(["../../languages/*/blocks/index.ts", "!../../languages/en/**"], {
  import: "table",
  eager: true,
})

export const wordsByLanguage: readonly (readonly [tag: string, words: Words])[] = [
  ["en", en],
  ...Object.entries(others).map(([path, words]) => [path.split("/").at(-3) ?? "", words] as const),
]
