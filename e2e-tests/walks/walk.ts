/// One walk: random steps in the blocks and in the text of one page. After each the page comes to rest, its views agree, and nothing is lost.

import {expect, type Page} from "@playwright/test"
import type {Reader} from "../../codegen/src/reader/index.ts"
import {commentWords} from "../../codegen/src/reader/printing/exact_texts.ts"
import {Dice} from "../../codegen/test/generate/random.ts"
import {Learner} from "../stories/learner.ts"
import {faultsOf, look, type SeenProgram} from "./seen_program.ts"
import {closes, type Done, pastes, reloads, type StepKind, steps} from "./steps.ts"
import {programs} from "./texts.ts"

const weights: readonly (readonly [number, StepKind | "reload"])[] = [
  [5, "drawer"],
  [5, "move"],
  [3, "delete"],
  [2, "copy"],
  [6, "entry"],
  [3, "menu"],
  [3, "name"],
  [4, "button"],
  [3, "rename"],
  [9, "type"],
  [3, "erase"],
  [5, "undo"],
  [3, "redo"],
  [2, "undoAndRedo"],
  [1, "paste"],
  [2, "views"],
  [3, "reload"],
]

export interface Walk {
  readonly page: Page
  readonly readers: readonly [Reader, Reader]
  /// What the page has complained about so far.
  readonly complaints: string[]
}

export function openWalk(page: Page, readers: readonly [Reader, Reader]): Walk {
  const complaints: string[] = []
  page.on("pageerror", error => complaints.push(error.stack ?? error.message))
  page.on("console", line => {
    if (line.type() === "error") complaints.push(line.text())
  })
  return {page, readers, complaints}
}

/// A walk that went wrong: its steps, and the program before the last one and after it.
export class WrongWalk extends Error {
  readonly before: SeenProgram | undefined
  readonly after: SeenProgram
  constructor(message: string, before: SeenProgram | undefined, after: SeenProgram) {
    super(message)
    this.before = before
    this.after = after
  }
}

/// Takes a walk; the result counts its steps by what they were.
export async function walk(
  walk: Walk,
  seed: number,
  length: number,
): Promise<Readonly<Record<string, number>>> {
  const {page, complaints} = walk
  const dice = new Dice(seed)
  const program = dice.pick(programs)
  const story = [`${program.name}`]
  const counts: Record<string, number> = {}
  let seen: SeenProgram | undefined
  try {
    await begins(page, program.text)
    seen = await agreed(walk)
    expect(seen.text).toBe(program.text)
    for (let i = 0; i < length; i++) {
      const kind = dice.weighed(weights)
      const left = kind === "reload"
      const done = await steps[left ? dice.weighed(weights.filter(isStep)) : kind](page, dice)
      story.push(left ? `${done.step}, and reload at once` : done.step)
      if (left) await reloads(page)
      else if (done.holds?.kind !== "insertion") await closes(page)
      const after = await agreed(walk)
      expect(complaints).toEqual([])
      const lost = lostBy(done, seen, after)
      if (lost !== undefined) throw new Error(lost)
      const kinds = seen.text === after.text ? `${kind}, no other text` : kind
      counts[kinds] = (counts[kinds] ?? 0) + 1
      seen = after
    }
  } catch (error) {
    const taken = story.map((step, i) => `${i}. ${step}`).join("\n")
    const after = await look(page)
    throw new WrongWalk(
      `seed ${seed}\n${taken}\n\n${error}\n\nbefore the last step:\n${seen?.text}\n\nafter it:\n${after.text}`,
      seen,
      after,
    )
  }
  return counts
}

function isStep(row: readonly [number, StepKind | "reload"]): row is readonly [number, StepKind] {
  return row[1] !== "reload"
}

/// An empty storage, and a program that was pasted.
async function begins(page: Page, text: string): Promise<void> {
  await page.goto("/?example=move")
  await page.evaluate(() => localStorage.clear())
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.entersHaskell()
  await page.keyboard.press("Control+a")
  await pastes(page, text)
}

/// The page when it has come to rest and its views agree.
async function agreed({page, readers}: Walk): Promise<SeenProgram> {
  let seen = await look(page)
  await expect
    .poll(
      async () => {
        seen = await look(page)
        return faultsOf(seen, readers)
      },
      {intervals: [50, 100, 200, 200, 400], message: "expected the views to agree"},
    )
    .toEqual([])
  return seen
}

/// What a step has taken that it may not take.
function lostBy({holds}: Done, seen: SeenProgram, now: SeenProgram): string | undefined {
  const [before, after] = [seen.text ?? "", now.text ?? ""]
  switch (holds?.kind) {
    case undefined:
      return undefined
    case "remarks":
      return commentWords(before) === commentWords(after) ? undefined : "comments have changed"
    case "same":
      return before === after ? undefined : "the text is not as before"
    case "insertion":
      return isInserted(before, after, holds.text)
        ? undefined
        : `the text is not the one before with ${JSON.stringify(holds.text)}`
  }
}

/// Whether `after` is `before` with `text` in place of nothing or of what was selected there.
function isInserted(before: string, after: string, text: string): boolean {
  for (let at = after.indexOf(text); at >= 0; at = after.indexOf(text, at + 1))
    if (before.startsWith(after.slice(0, at)) && before.endsWith(after.slice(at + text.length))) return true
  return false
}
