/// Exact printing: an edit of blocks changes only the characters of what was edited.

import {beforeAll, expect, test} from "vitest"
import type {Reader, View} from "../../src/reader/index.ts"
import {openView, syncBlocks, workspaceOf} from "../../src/reader/index.ts"
import type {SavedBlock} from "../../src/serialized_blocks.ts"
import {infix, num, ref} from "../../src/workspace/toolbox/block_builders.ts"
import {everyBlock} from "./agreement.ts"
import {testReader} from "./open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The view after a change of the blocks of one definition.
function changed(text: string, change: (blocks: readonly SavedBlock[]) => void): string {
  const view: View = openView(reader, text)
  const workspace = structuredClone(workspaceOf(view))
  change(workspace.blocks.blocks.flatMap(everyBlock))
  return syncBlocks(reader, view, workspace).text
}

function setNumber(blocks: readonly SavedBlock[], from: string, to: string): void {
  for (const b of blocks) if (b.type === "number" && b.extraState?.value === from) b.extraState = {value: to}
}

test.each([
  ["layout and comments by hand", "f   x=(  1 )+ x -- tail\n  where  {- inner -} y  =   2   ; z=3\n"],
  ["brackets that are not needed", "f x = ((1)) + (2 * (3))\n"],
  ["a list over lines", "xs =\n  [ 1 -- first\n  , 2 -- second\n  ]\n"],
  ["steps without $", "main = do\n  when b do\n    say 1\n    wait 2\n  f x   \\y -> do\n    g y\n"],
  ["steps after $", "main = do\n  when  b  $  do\n    say 1\n    wait 2\n  stop\n"],
  ["one step after $", 'main = do\n\twhen b $ do\n\t\tsay "a"\n\twait 1\n'],
  ["equations beside each other", "f 0 = 1 ; f n = n - 2\n"],
  ["a main without a type", "main  =  simulate (go 1)\n"],
])("a number keeps %s", (_, text) => {
  expect(changed(text, blocks => setNumber(blocks, "1", "42"))).toBe(text.replace("1", "42"))
})

/// Compares values of the type `T` for the first time, in `same`.
function compares(blocks: readonly SavedBlock[]): void {
  const same = blocks.find(b => b.type === "number")
  if (same === undefined) throw new Error("expected a number")
  Object.assign(same, infix("==", ref("a"), ref("b")))
}

test.each([
  ["on one line", "data T = A | B", "data T = A | B deriving (Eq)"],
  ["over lines", "data T\n  = A -- first\n  | B", "data T\n  = A -- first\n  | B\n  deriving (Eq)"],
  [
    "over lines with a comment behind",
    "data T = A\n       | B -- b",
    "data T = A\n       | B deriving (Eq) -- b",
  ],
  ["with a comment behind", "data T  = A  | B -- b", "data T  = A  | B deriving (Eq) -- b"],
  ["with classes", "data T =  A | B\n  deriving ( Show )", "data T =  A | B\n  deriving ( Show , Eq)"],
  ["with one class", "data T =  A | B  deriving Show", "data T =  A | B  deriving (Show, Eq)"],
])("a class that an edit needs is added to a type %s", (_, type, derived) => {
  const rest = "\n\nsame :: T -> T -> Bool\nsame a b = "
  const text = `${type}${rest}1\n`
  expect(changed(text, compares)).toBe(`${derived}${rest}a == b\n`)
})

test("what has to stand in brackets in its new place leaves the rest of the definition as it is", () => {
  const text =
    "bind :: Monad m => m a   -> (a -> m b) -> m b\nbind x f   = Tagged $ un x >>= \\y -> f y -- tail\n"
  const after = changed(text, blocks => {
    const call = blocks.find(b => b.type === "infix" && b.extraState?.op === "$")
    if (call?.inputs === undefined) throw new Error("expected $")
    const {L, R} = call.inputs
    call.inputs = {...(R && {L: R}), ...(L && {R: L})}
  })
  expect(after).toBe(
    "bind :: Monad m => m a   -> (a -> m b) -> m b\nbind x f   = un x >>= (\\y -> f y) $ Tagged -- tail\n",
  )
})

test("a field that stood for the variable of its name gets its own value, and the others stay", () => {
  const text = "{-# LANGUAGE NamedFieldPuns #-}\nf x y = R\n  { x\n  , y -- why\n  }\n"
  const replaced = changed(text, blocks => {
    const record = blocks.find(b => Array.isArray(b.extraState?.puns))
    const socket = Object.values(record?.inputs ?? {})[0]
    if (socket?.block === undefined) throw new Error("expected a field")
    socket.block = {...num("7"), id: "seven"}
  })
  expect(replaced).toBe(text.replace("{ x\n", "{ x = 7\n"))
})

test("items below the place of an edit keep their column", () => {
  const text = "f b = g 1 $ case b of True -> 2 -- yes\n                      False -> 3\n"
  expect(changed(text, blocks => setNumber(blocks, "1", "4711"))).toBe(
    "f b = g 4711 $ case b of True -> 2 -- yes\n                         False -> 3\n",
  )
})

test("brackets are written where the new part needs them, and go with the part that needed them", () => {
  const wrap = (blocks: readonly SavedBlock[]): void => {
    const sum = blocks.find(b => b.type === "infix" && b.extraState?.op === "+")
    const number = sum?.inputs?.L
    const times = blocks.find(b => b.type === "infix" && b.extraState?.op === "*")
    if (times?.inputs !== undefined && number !== undefined) times.inputs.L = number
  }
  expect(changed("f x = (1   +   x) * 2 {- two -}\n", wrap)).toBe("f x = 1 * 2 {- two -}\n")
})

test("a new type that is too long for its line begins on a line of its own", () => {
  const type = "Seconds -> Memory M -> Either (M1 Velocity) (M2 Velocity) -> Maybe (Velocity, Memory M)"
  const after = changed("muxVelocity :: Int -- later\nmuxVelocity   = mux\n", ([block]) => {
    if (block === undefined) throw new Error("expected the definition")
    block.extraState = {...block.extraState, signature: type}
  })
  expect(after).toBe(
    [
      "muxVelocity ::",
      "  Seconds ->",
      "  Memory M ->",
      "  Either (M1 Velocity) (M2 Velocity) ->",
      "  Maybe (Velocity, Memory M) -- later",
      "muxVelocity   = mux",
      "",
    ].join("\n"),
  )
})

test("a step that moves takes its comment and its own layout along", () => {
  const text = [
    "main = do",
    "  -- first",
    "  say   (show 1)",
    "  wait   2 -- seconds",
    '  say "end"',
    "",
  ].join("\n")
  const after = changed(text, blocks => {
    const stack = blocks.find(b =>
      Object.values(b.inputs ?? {}).some(i => i.block?.next?.block !== undefined),
    )
    const slot = Object.values(stack?.inputs ?? {}).find(i => i.block?.next !== undefined)
    const [a, b] = [slot?.block, slot?.block?.next?.block]
    if (slot === undefined || a === undefined || b === undefined) throw new Error("no steps")
    const rest = b.next
    slot.block = b
    b.next = {block: a}
    if (rest !== undefined) a.next = rest
  })
  expect(after).toBe(
    ["main = do", "  wait   2 -- seconds", "  -- first", "  say   (show 1)", '  say "end"', ""].join("\n"),
  )
})

test("a step with a block argument keeps its form when a number in it or beside it changes", () => {
  const text = `steps :: Task ()\nsteps = do\n  when True do\n    say "a"\n    wait 1\n  wait 2\n\nmain = simulate steps\n`
  expect(changed(text, blocks => setNumber(blocks, "1", "7"))).toBe(text.replace("wait 1", "wait 7"))
  expect(changed(text, blocks => setNumber(blocks, "2", "7"))).toBe(text.replace("wait 2", "wait 7"))
})

/// Puts the block that `isWanted` finds first on the left of `* 7`.
function wrap(blocks: readonly SavedBlock[], isWanted: (block: SavedBlock) => boolean): void {
  for (const holder of blocks)
    for (const [input, {block}] of Object.entries(holder.inputs ?? {}))
      if (block !== undefined && isWanted(block)) {
        const seven: SavedBlock = {type: "number", id: "x2", extraState: {value: "7"}}
        const inputs = {L: {block}, R: {block: seven}}
        ;(holder.inputs ?? {})[input] = {block: {type: "infix", id: "x1", extraState: {op: "*"}, inputs}}
        return
      }
}

test("a string that is wrapped keeps its spelling", () => {
  expect(
    changed('f = g "\\SOH" "\\1"\n', blocks => wrap(blocks, b => b.extraState?.value === "\u0001")),
  ).toBe('f = g ("\\SOH" * 7) "\\1"\n')
})

test("arguments that change places leave the comments between them where they are", () => {
  const swapped = changed("go = v 1 {- between -} 2\n", blocks => {
    const numbers = blocks.filter(b => b.type === "number")
    for (const b of numbers) b.extraState = {value: b.extraState?.value === "1" ? "2" : "1"}
  })
  expect(swapped).toBe("go = v 2 {- between -} 1\n")
})

test("a negative number that becomes a positive one loses its brackets", () => {
  expect(changed("v = f (-1) (-2)\n", blocks => setNumber(blocks, "-1", "3"))).toBe("v = f 3 (-2)\n")
})

test("steps behind $ keep their layout and comments when they are wrapped", () => {
  const text = "main = simulate $ do -- here\n   d  <- measure\n   say d\n"
  expect(changed(text, blocks => wrap(blocks, b => b.type === "do"))).toBe(
    "main = simulate ((do -- here\n   d  <- measure\n   say d)\n                   * 7)\n",
  )
})

test("steps behind $ that are wrapped stay behind it where the call does", () => {
  const text = "fresh :: Int   -> T\nfresh x   = Supply $ do -- here\n    n <- get\n    put n\n"
  expect(changed(text, blocks => wrap(blocks, b => b.type === "do"))).toBe(
    [
      "fresh :: Int   -> T",
      "fresh x   = Supply $",
      "              (do -- here",
      "                  n <- get",
      "                  put n)",
      "                * 7",
      "",
    ].join("\n"),
  )
})

test("lines that hang on the beginning of their line stay below it when their part is wrapped", () => {
  const text = "f x = g $ \\y -> case y of -- both\n  1 -> x\n  _ -> y\n"
  expect(changed(text, blocks => wrap(blocks, b => b.type === "case"))).toBe(
    "f x = g $ \\y ->\n            (case y of -- both\n              1 -> x\n              _ -> y)\n              * 7\n",
  )
})

test.each([
  ["a name", "main = simulate wander", "main = simulate $ do\n  a 1\n  b 2\n"],
  ["a call in brackets", "main = simulate (wander 1)", "main = simulate (do\n"],
])("steps in the place of %s have a $ or brackets before them, as Haskell wants it", (_, text, after) => {
  const program = `${text}\n\nwander = do\n  a 1\n  b 2\n`
  const result = changed(program, blocks => {
    const call = blocks.find(b => b.type === "main")
    const steps = blocks.find(b => b.type === "define" && b.extraState?.name === "wander")
    const moved = steps?.inputs?.E0_0
    if (call?.inputs === undefined || steps?.inputs === undefined || moved === undefined)
      throw new Error("expected a call and its steps")
    delete steps.inputs.E0_0
    call.inputs.R0 = moved
  })
  expect(result.slice(0, after.length)).toBe(after)
})
