/// Every block of the toolbox at every place of every other: what is said when it does not fit, read as a whole.
///
/// `refusals/<language>.txt` is the catalogue. Read the difference before it is committed: a learner will.
/// To write all anew: `npx vitest run --root codegen test/refusals.test.ts -u`.

import {setImmediate} from "node:timers/promises"
import {expect, test} from "vitest"
import {table as de} from "../../languages/de/blocks/index.ts"
import {en} from "../../languages/en/blocks/index.ts"
import {table as es} from "../../languages/es/blocks/index.ts"
import {table as fr} from "../../languages/fr/blocks/index.ts"
import {table as pt} from "../../languages/pt/blocks/index.ts"
import type {SavedBlock, SavedWorkspace} from "../src/index.ts"
import {blockView, checker, infer, newWorkspace, toolbox} from "../src/index.ts"
import {speak} from "../src/words/index.ts"
import {everyBlockIn} from "../src/workspace/inference/workspace_inference.ts"

let ids = 0
function numbered(block: SavedBlock): SavedBlock {
  const copy = structuredClone(block)
  for (const b of everyBlockIn(copy)) b.id = `t${ids++}`
  return copy
}

function workspaceOf(block: SavedBlock): SavedWorkspace {
  const more = block.type === "main" ? [] : newWorkspace().blocks.blocks
  return {blocks: {languageVersion: 0, blocks: [block, ...more]}}
}

/// One block of the toolbox for each sort and type.
const dragged = new Map<string, SavedBlock>()
const hosts = toolbox("haskell").flatMap(c => c.items.map(i => numbered(i.block)))
for (const block of hosts) {
  const type = infer(workspaceOf(block)).blocks.get(block.id ?? "")?.type
  const key = `${blockView(block.type)?.meaning.as} ${type}`
  if (!dragged.has(key)) dragged.set(key, numbered(block))
}

async function* refusals(asked: readonly SavedBlock[]): AsyncGenerator<string> {
  for (const host of asked) {
    // Between them the test runner hears that the test is alive.
    await setImmediate()
    const check = checker(workspaceOf(host))
    for (const b of everyBlockIn(host))
      for (const item of (blockView(b.type)?.shape(b.extraState ?? {}).rows ?? []).flat()) {
        if (item.kind !== "socket" && item.kind !== "stack") continue
        for (const block of dragged.values()) {
          const verdict = check.fits({block: b.id ?? "", input: item.name}, block)
          if (!verdict.fits) yield verdict.why
        }
      }
  }
}

/// All sentences, with what a socket wants and what a block is listed by themselves: each may stand beside each.
async function catalogue(frame: RegExp, asked: readonly SavedBlock[]): Promise<string> {
  const wanted = new Set<string>()
  const found = new Set<string>()
  const others = new Set<string>()
  for await (const why of refusals(asked)) {
    const plain = why.replace(/`[^`]*`/, "`…`")
    const [, w, f] = frame.exec(plain) ?? []
    if (w === undefined || f === undefined) others.add(plain)
    else {
      wanted.add(w)
      found.add(f)
    }
  }
  const list = (title: string, lines: Iterable<string>) => `${title}\n${[...lines].sort().join("\n")}\n`
  return [
    list("# This socket wants …", wanted),
    list("# … and this block is …", found),
    list("# All others", others),
  ].join("\n")
}

const english = ["en", en, /^This socket wants (.*), and (?:`…`|this block) is (.*?)\.$/] as const

const others = [
  ["de", de, /^Hierher gehört (.*), und (?:`…`|dieser Block) ist (.*?)\.$/],
  ["pt", pt, /^Este encaixe pede (.*), e (?:`…`|este bloco) é (.*?)\.$/],
  ["es", es, /^Aquí va (.*), pero (?:`…`|este bloque) es (.*?)\.$/],
  ["fr", fr, /^Ici, il faut (.*), et (?:`…`|ce bloc) est (.*?)\.$/],
] as const

test.each([english, ...others])(
  "what is said of blocks that do not fit, in %s",
  {timeout: 1_800_000},
  async (language, words, frame) => {
    speak(words)
    try {
      await expect(await catalogue(frame, hosts)).toMatchFileSnapshot(`refusals/${language}.txt`)
    } finally {
      speak(en)
    }
  },
)
