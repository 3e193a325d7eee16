/// Text and blocks of one program: an edit of one side reaches the other, and nothing else changes.

import {beforeAll, describe, expect, test} from "vitest"
import {blockAt} from "../../src/index.ts"
import type {Reader, View} from "../../src/reader/index.ts"
import {
  guessSize,
  layoutOf,
  openView,
  spansOf,
  syncBlocks,
  syncText,
  workspaceOf,
} from "../../src/reader/index.ts"
import type {SavedBlock, SavedWorkspace} from "../../src/serialized_blocks.ts"
import {corpus, testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

function everyBlock(block: SavedBlock): SavedBlock[] {
  return [
    block,
    ...Object.values(block.inputs ?? {}).flatMap(i => (i.block === undefined ? [] : everyBlock(i.block))),
    ...(block.next?.block === undefined ? [] : everyBlock(block.next.block)),
  ]
}

function blocksOf(view: View, name: string): SavedBlock[] {
  const shown = view.declarations.find(s => s.name === name)
  return shown === undefined ? [] : everyBlock(shown.block)
}

const ids = (blocks: readonly SavedBlock[]) => blocks.map(b => b.id)

/// A copy of the workspace with one block changed.
function changed(
  workspace: SavedWorkspace,
  id: string | undefined,
  change: (b: SavedBlock) => void,
): SavedWorkspace {
  const copy = structuredClone(workspace)
  for (const b of copy.blocks.blocks.flatMap(everyBlock)) if (b.id === id) change(b)
  return copy
}

test("an empty place for a pattern has no block in the text, also after it was saved and opened", () => {
  const view = openView(reader, "slug x = x\n")
  const definition = blocksOf(view, "slug").find(b => b.type === "define")
  const emptied = syncBlocks(
    reader,
    view,
    changed(workspaceOf(view), definition?.id, b => {
      delete b.inputs?.P0_0
    }),
  )
  expect(emptied.text).toBe("slug _ = x\n")
  const again = openView(reader, emptied.text, layoutOf(emptied))
  expect(spansOf(again).spans).toEqual(spansOf(emptied).spans)
})

describe("a call with steps that is no step itself", () => {
  const text =
    "square = replicateM_ 4 $ do\n  forward -- on\n  turn 90\n\nmain = f (forever do\n  wait 1\n  stop)\n"
  const types = (view: View, name: string) => blocksOf(view, name).map(b => b.type)

  test("is the only step of a stack", () => {
    const view = openView(reader, text)
    expect(types(view, "square").slice(0, 4)).toEqual(["define", "do", "step_repeat", "number"])
    expect(types(view, "main").slice(0, 4)).toEqual(["define", "name", "do", "step_forever"])
    expect(syncBlocks(reader, view, workspaceOf(view)).text).toBe(text)
  })

  test("is written as before when a part of it changes, and below `do` when it gets a neighbour", () => {
    const view = openView(reader, text)
    const number = blocksOf(view, "square").find(b => b.type === "number")
    const edited = changed(workspaceOf(view), number?.id, b => {
      b.extraState = {value: "5"}
    })
    expect(syncBlocks(reader, view, edited).text).toBe(text.replace("4", "5"))
    const plain = openView(reader, text.replace(" -- on", ""))
    const repeat = blocksOf(plain, "square").find(b => b.type === "step_repeat")
    const longer = changed(workspaceOf(plain), repeat?.id, b => {
      b.next = {
        block: {
          type: "step_wait",
          id: "added",
          inputs: {X: {block: {type: "number", id: "n", extraState: {value: "2"}}}},
        },
      }
    })
    expect(syncBlocks(reader, plain, longer).text).toMatch(
      /^square = do\n {2}replicateM_ 4 \$ do\n {4}forward\n {4}turn 90\n {2}wait \S+\n/,
    )
  })

  test("stays a call where the program has a function of that name", () => {
    const view = openView(reader, `replicateM_ n steps = steps\n\n${text}`)
    expect(types(view, "square").slice(0, 3)).toEqual(["define", "infix", "name"])
  })
})

describe.each(corpus.map(p => [p.name, p.text] as const))("%s", (_, text) => {
  test("as blocks and back is the same text, and the layout opens as it was", () => {
    const view = openView(reader, text)
    expect(syncBlocks(reader, view, workspaceOf(view)).text).toBe(text)
    const all = workspaceOf(view).blocks.blocks.flatMap(everyBlock)
    expect(new Set(ids(all)).size).toBe(all.length)
    const again = openView(reader, text, structuredClone(layoutOf(view)))
    expect(workspaceOf(again)).toEqual(workspaceOf(view))
    expect(spansOf(again).spans).toEqual(spansOf(view).spans)
  })

  test("blocks do not overlap", () => {
    const boxes = workspaceOf(openView(reader, text)).blocks.blocks.map(b => ({
      x: b.x ?? 0,
      y: b.y ?? 0,
      ...guessSize(b),
    }))
    for (const [i, a] of boxes.entries())
      for (const b of boxes.slice(i + 1))
        expect(
          a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height,
        ).toBe(false)
  })
})

// One edit of each definition; random edits are in `edit_law.test.ts`.
describe.each(corpus.map(p => [p.name, p.text] as const))("%s", (_, text) => {
  test("an edit of one definition leaves every other character", () => {
    const view = openView(reader, text)
    for (const shown of view.declarations) {
      const piece = view.module.pieces[shown.piece]
      if (piece === undefined || shown.block.type === "raw_definition") continue
      const number = everyBlock(shown.block).find(b => b.type === "number")
      const edited = changed(workspaceOf(view), (number ?? shown.block).id, b => {
        if (number !== undefined) b.extraState = {value: "4711"}
        else b.icons = {comment: {text: "new words"}}
      })
      const after = syncBlocks(reader, view, edited)
      const start = (piece.remark ?? piece.core).start
      expect(after.text.slice(0, start)).toBe(text.slice(0, start))
      expect(after.text.slice(after.text.length - (text.length - piece.core.end))).toBe(
        text.slice(piece.core.end),
      )
      expect(after.text).toContain(number === undefined ? "-- new words" : "4711")
      expect(workspaceOf(after)).toEqual(edited)
      expect(after.declarations.some(s => s.dimmed)).toBe(false)
    }
  })

  test("every comment survives an edit of its definition", () => {
    const words = text.match(/(?<=--+ ).*$/gm) ?? []
    let view = openView(reader, text)
    for (const shown of view.declarations.filter(s => s.block.type !== "raw_definition"))
      view = syncBlocks(
        reader,
        view,
        changed(workspaceOf(view), shown.block.id, b => {
          const comment = b.icons?.comment?.text
          b.icons = {comment: {text: comment === undefined ? "mine" : `${comment}\nmine`}}
        }),
      )
    for (const word of words) expect(view.text).toContain(word.trim())
  })
})

const square = `-- how far
side :: Double
side = 0.5

drive :: Bumper -> Velocity
drive (Bumper _ Pressed) = Velocity 0 0
drive _ = Velocity side 1

main :: IO ()
main = simulate drive
`

describe("typing text", () => {
  test("a changed number keeps every block", () => {
    const view = openView(reader, square)
    const after = syncText(reader, view, square.replace("0.5", "0.75"))
    expect(ids(workspaceOf(after).blocks.blocks.flatMap(everyBlock))).toEqual(
      ids(workspaceOf(view).blocks.blocks.flatMap(everyBlock)),
    )
    expect(blocksOf(after, "side").find(b => b.type === "number")?.extraState).toEqual({value: "0.75"})
  })

  test("blocks stay where they were put, folded as they were", () => {
    const view = openView(reader, square)
    const [root] = blocksOf(view, "drive")
    const moved = changed(workspaceOf(view), root?.id, b =>
      Object.assign(b, {x: 900, y: -40, collapsed: true}),
    )
    const put = syncBlocks(reader, view, moved)
    expect(put.text).toBe(square)
    const after = syncText(reader, put, square.replace("Velocity 0 0", "Velocity 0 (side + 1)"))
    expect(blocksOf(after, "drive")[0]).toMatchObject({id: root?.id, x: 900, y: -40, collapsed: true})
  })

  test("a new name keeps the blocks", () => {
    const view = openView(reader, square)
    const after = syncText(reader, view, square.replaceAll("drive", "steer"))
    expect(ids(blocksOf(after, "steer"))).toEqual(ids(blocksOf(view, "drive")))
  })

  test("an expression that is wrapped in another keeps its blocks", () => {
    const view = openView(reader, square)
    const after = syncText(
      reader,
      view,
      square.replace("Velocity side 1", "if True then Velocity side 1 else Velocity 0 0"),
    )
    const before = blocksOf(view, "drive")
      .filter(b => b.type === "construct")
      .map(b => b.id)
    expect(blocksOf(after, "drive").map(b => b.id)).toEqual(expect.arrayContaining(before))
  })

  test("an item put in front of a list moves no block", () => {
    const view = openView(reader, "xs = [f 1, f 2, f 3]\n")
    const after = syncText(reader, view, "xs = [f 0, f 1, f 2, f 3]\n")
    const calls = (v: View) =>
      blocksOf(v, "xs")
        .filter(b => b.extraState?.name === "f")
        .map(b => b.id)
    expect(calls(after).slice(1)).toEqual(calls(view))
  })

  test("a broken definition keeps its last good blocks, dimmed, until it is mended", () => {
    let view = openView(reader, square)
    const good = workspaceOf(view)
    for (const text of [
      square.replace("Velocity side 1", "Velocity (side 1"),
      square.replace("Velocity side 1", "Velocity ("),
    ]) {
      view = syncText(reader, view, text)
      expect(workspaceOf(view)).toEqual(good)
      expect(view.declarations.filter(s => s.dimmed).map(s => s.name)).toEqual(["drive"])
    }
    view = syncText(reader, view, square)
    expect(workspaceOf(view)).toEqual(good)
    expect(view.declarations.some(s => s.dimmed)).toBe(false)
  })

  test("is open again as it was, also when another has the same broken text", () => {
    const broken = "side = {\n"
    const whole = `one = 1\n\nside = 2\n\ntwo = 2\n`
    // The one above had blocks before it broke, the one below never had.
    const saved = syncText(reader, openView(reader, whole), `one = 1\n\n${broken}\ntwo = 2\n\n${broken}`)
    const opened = openView(reader, saved.text, layoutOf(saved))
    expect(layoutOf(opened)).toEqual(layoutOf(saved))
  })

  test("a definition that comes back finds its blocks", () => {
    const view = openView(reader, square)
    const without = syncText(reader, view, square.replace(/drive ::[\s\S]*side 1\n\n/, ""))
    expect(without.declarations.map(s => s.name)).toEqual(["side", "main"])
    const back = syncText(reader, without, square)
    expect(workspaceOf(back)).toEqual(workspaceOf(view))
  })

  test("typing a program letter by letter never moves a block and ends with the blocks of the whole", () => {
    let view = openView(reader, "")
    let places = new Map<string, string>()
    for (let i = 1; i <= square.length; i++) {
      view = syncText(reader, view, square.slice(0, i))
      const now = new Map(view.declarations.map(s => [s.block.id ?? "", `${s.block.x},${s.block.y}`]))
      for (const [id, at] of now) if (places.has(id)) expect(at).toBe(places.get(id))
      places = new Map([...places, ...now])
    }
    expect(view.declarations.map(s => [s.name, s.dimmed])).toEqual([
      ["side", false],
      ["drive", false],
      ["main", false],
    ])
    const types = (v: View) =>
      workspaceOf(v)
        .blocks.blocks.flatMap(everyBlock)
        .map(b => b.type)
    expect(types(view)).toEqual(types(openView(reader, square)))
  })
})

describe("editing blocks", () => {
  test("an edited fixity regroups the operators of definitions whose text stays", () => {
    const text = "infixl 6 |+|\ninfixl 7 *|\n\nhome = 1 |+| 2 *| 3\n"
    const view = openView(reader, text)
    const fixity = view.declarations[0]?.block
    const edited = syncBlocks(
      reader,
      view,
      changed(workspaceOf(view), fixity?.id, b => {
        b.extraState = {...b.extraState, operators: "<+>"}
      }),
    )
    expect(edited.text).toBe(text.replace("|+|", "<+>"))
    const sums = blocksOf(edited, "home").filter(b => b.type === "infix")
    expect(sums.map(b => b.extraState?.op)).toEqual(["*|", "|+|"])
    expect(ids(blocksOf(openView(reader, edited.text, layoutOf(edited)), "home"))).toEqual(
      ids(blocksOf(edited, "home")),
    )
  })

  test("a new definition goes before main, with its type", () => {
    const view = openView(reader, square)
    const workspace = workspaceOf(view)
    const added: SavedBlock = {
      type: "define",
      id: "new",
      x: 0,
      y: 2000,
      extraState: {name: "fast", arity: 0, equations: [{}]},
      inputs: {E0_0: {block: {type: "choice", id: "new2", extraState: {of: "Bool", value: "True"}}}},
    }
    const after = syncBlocks(reader, view, {
      blocks: {...workspace.blocks, blocks: [...workspace.blocks.blocks, added]},
    })
    expect(after.text).toBe(square.replace("main ::", "fast :: Bool\nfast = True\n\nmain ::"))
    expect(after.declarations.map(s => s.name)).toEqual(["side", "drive", "fast", "main"])
  })

  test("a deleted definition takes its comment along, and nothing else", () => {
    const text = `-- about this file\n\n${square}`
    const view = openView(reader, text)
    const blocks = workspaceOf(view).blocks.blocks.filter(b => b.id !== blocksOf(view, "side")[0]?.id)
    const after = syncBlocks(reader, view, {blocks: {languageVersion: 0, blocks}})
    expect(after.text).toBe(
      text.replace("-- how far\nside :: Double\nside = 0.5\n", "").replace("\n\n\n", "\n\n"),
    )
  })

  test("text without types stays without, also when it is printed anew", () => {
    const view = openView(reader, "a = 1\nmain = simulate a\n")
    const number = blocksOf(view, "a").find(b => b.type === "number")
    const after = syncBlocks(
      reader,
      view,
      changed(workspaceOf(view), number?.id, b => Object.assign(b, {extraState: {value: "2"}})),
    )
    expect(after.text).toBe("a = 2\nmain = simulate a\n")
  })

  test("a comment that is not changed keeps its looks", () => {
    const view = openView(reader, "{- a\n   box -}\na = 1 -- tail\n")
    const number = blocksOf(view, "a").find(b => b.type === "number")
    const after = syncBlocks(
      reader,
      view,
      changed(workspaceOf(view), number?.id, b => Object.assign(b, {extraState: {value: "2"}})),
    )
    expect(after.text).toBe("{- a\n   box -}\na = 2 -- tail\n")
  })

  test("a loose block is kept beside the text", () => {
    const view = openView(reader, square)
    const loose: SavedBlock = {type: "number", id: "loose", x: 0, y: 3000, extraState: {value: "3"}}
    const workspace = {blocks: {languageVersion: 0, blocks: [...workspaceOf(view).blocks.blocks, loose]}}
    const after = syncText(reader, syncBlocks(reader, view, workspace), `${square}\n`)
    expect(after.loose).toEqual([loose])
    expect(layoutOf(after).loose).toEqual([loose])
  })
})

describe("a place in the text", () => {
  test("has its block, in text that was not printed", () => {
    const text = "go   =Velocity   (1  +  2 )   _ -- odd\n"
    const view = openView(reader, text)
    const type = (at: string) => {
      const id = blockAt(spansOf(view), text.indexOf(at))
      return blocksOf(view, "go").find(b => b.id === id)?.type
    }
    expect([type("1"), type("+"), type("Vel"), type("go")]).toEqual([
      "number",
      "infix",
      "construct",
      "define",
    ])
    const hole = spansOf(view).spans.find(s => s.input !== undefined)
    expect(hole).toMatchObject({start: text.indexOf("_"), end: text.indexOf("_") + 1, input: "A1"})
  })
})
