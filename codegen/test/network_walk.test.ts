/// Walks of edits now in the text, now in the blocks, now in the diagram: after each step the three agree, and an edit of the diagram changes no foreign character.

import {beforeAll, expect, test} from "vitest"
import {blockView} from "../src/blocks/block_registry.ts"
import {networkEdit, writtenNetwork} from "../src/network_edits/index.ts"
import type {Reader, View} from "../src/reader/index.ts"
import {openView, syncBlocks, syncText, workspaceOf} from "../src/reader/index.ts"
import {pieceText} from "../src/reader/view/view.ts"
import type {SavedWorkspace} from "../src/serialized_blocks.ts"
import {cases, rerun, seed} from "./extent.ts"
import {drawnAction, exampleTexts} from "./generate/network_actions.ts"
import {Dice} from "./generate/random.ts"
import {breathe} from "./process.ts"
import {disagreements} from "./reader/agreement.ts"
import {corpus, testReader} from "./reader/open.ts"
import {editPage, pageEdits} from "./reader/page_edits.ts"

const walks = cases(4)
const steps = 50
const foreign = corpus
  .filter(({text}) => text.split("\n").length < 60)
  .map(({name, text}) => [name, text] as const)

let reader: Reader
let other: Reader
beforeAll(async () => {
  reader = await testReader()
  other = await testReader()
})

/// The network as the diagram shows it, without the ids of blocks, and without blocks that belong to no definition.
function network(workspace: SavedWorkspace): string {
  const blocks = workspace.blocks.blocks.filter(({type}) => blockView(type)?.meaning.as === "definition")
  const written = writtenNetwork({...workspace, blocks: {...workspace.blocks, blocks}})
  return JSON.stringify(written, (key, value: unknown) => (key === "block" ? undefined : value))
}

/// A small change of the text as by typing: a number, a comment, or a letter that breaks it.
function typed(text: string, dice: Dice): string {
  const numbers = [...text.matchAll(/\b\d+\b/g)]
  if (dice.once(3)) return `${text.trimEnd()}\n-- note ${dice.below(100)}\n`
  if (numbers.length === 0 || dice.once(4)) {
    const at = dice.below(text.length)
    return `${text.slice(0, at)}(${text.slice(at)}`
  }
  const {index, 0: digits} = dice.pick(numbers)
  return `${text.slice(0, index)}${dice.below(90) + 1}${text.slice(index + digits.length)}`
}

/// What an edit of the diagram did wrong, and the program after it.
function inDiagram(view: View, dice: Dice): {after: View; step: string; wrong: readonly string[]} {
  const [action, meant] = drawnAction(view, dice)
  const step = JSON.stringify(action)
  const outcome = networkEdit(reader, view, action)
  if (!outcome.ok) return {after: view, step: `${step}: ${outcome.refusal.kind}`, wrong: []}
  const after = syncText(reader, view, outcome.text)
  const others = ({module}: View) =>
    module.pieces
      .filter(piece => piece.kind === "declaration" && !piece.names.some(name => meant.includes(name)))
      .map(pieceText)
  const isForeignSame = JSON.stringify(others(view)) === JSON.stringify(others(after))
  return {after, step, wrong: isForeignSame ? [] : ["foreign characters changed"]}
}

test("blocks, text and diagram agree after every step of a walk through all three", async () => {
  const found: string[] = []
  let inAll = 0
  for (let walk = 0; walk < walks; walk++) {
    const dice = new Dice(seed * 1000 + walk)
    const [name, text] = dice.pick(walk % 2 === 0 ? exampleTexts : foreign)
    let view = openView(reader, text)
    let whole = view.text
    const done = [name]
    for (let i = 0; i < steps; i++) {
      await breathe()
      const before = view.text
      const isBroken = view.declarations.some(({dimmed}) => dimmed)
      if (!isBroken) whole = view.text
      let wrong: readonly string[] = []
      const where = isBroken ? "mend" : dice.pick(["text", "blocks", "diagram", "diagram"] as const)
      if (where === "mend") {
        view = syncText(reader, view, whole)
        done.push("mended")
      } else if (where === "text") {
        view = syncText(reader, view, typed(view.text, dice))
        done.push("typed")
      } else if (where === "blocks") {
        const edit = editPage(workspaceOf(view), dice, dice.pick(pageEdits))
        if (edit !== undefined) view = syncBlocks(reader, view, edit.workspace)
        done.push(edit?.step ?? "nothing")
      } else {
        const made = inDiagram(view, dice)
        if (made.after !== view) inAll++
        view = made.after
        wrong = made.wrong
        done.push(made.step)
      }
      wrong = [...wrong, ...disagreements(view, other)]
      if (wrong.length === 0 && !view.declarations.some(({dimmed}) => dimmed)) {
        const [ofBlocks, ofText] = [workspaceOf(view), workspaceOf(openView(other, view.text))].map(network)
        if (ofBlocks !== ofText)
          wrong = [`the diagram of the blocks is ${ofBlocks}, that of the text ${ofText}`]
      }
      if (wrong.length === 0) continue
      found.push(`${done.slice(-3).join(" | ")}\n${before}\n=====>\n${view.text}\n${wrong.join("\n")}`)
      break
    }
  }
  expect(found, `${rerun}\n${found.join("\n\n")}`).toEqual([])
  expect(inAll).toBeGreaterThan(5 * walks)
}, 1_200_000)
