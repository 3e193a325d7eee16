/// The other way out of a conflict over the speed: one new function that adds up what both want.
///
/// Only for functions that are always asked (states and values to read): of an event and something that lasts there is no sum.

import type {ConflictNames} from "../../api.ts"
import {uniqueName} from "../../model/unique_name.ts"
import {states} from "../../robot/roles.ts"
import type {SavedWorkspace} from "../../serialized_blocks.ts"
import {asFunction, showType, spine, type Type} from "../../types/syntax/type.ts"
import {words} from "../../words/index.ts"
import type {ConflictFix} from "./conflict_resolutions.ts"
import {inferWorkspace} from "./workspace_inference.ts"

const samples = new Set(["Seconds", "Clock", "StdGen", "Memory", "Param"])

/// Most that a function takes.
const mostInputs = 9

/// The edits of the text that put the sum in the place of both. `main` is the place of its definition in the text.
export function conflictMerge(
  workspace: SavedWorkspace,
  {command, winner, loser}: ConflictNames,
  text: string,
  main: {readonly start: number; readonly end: number},
): {readonly title: string; readonly edits: readonly Omit<ConflictFix, "title">[]} | undefined {
  const {globals} = inferWorkspace(workspace)
  const [one, other] = [loser, winner].map(name => inputsOf(globals.get(name)?.type))
  if (command !== "Velocity" || one === undefined || other === undefined) return undefined
  const inputs = [...new Set([...one, ...other])]
  if (inputs.length > mostInputs) return undefined
  const argument = /\bsimulate\b/.exec(text.slice(main.start, main.end))
  if (argument === null) return undefined
  const run = main.start + argument.index
  const places = [loser, winner].map(name => placeOf(name, text, run, main.end))
  const [lost, won] = places
  if (lost === undefined || won === undefined) return undefined
  const taken = new Set([...globals.all()].map(([name]) => name))
  const sum = uniqueName("together", taken)
  const names = inputs.map((_, i) => `input${i + 1}`)
  const call = (name: string, takes: readonly string[]) =>
    [name, ...takes.map(type => names[inputs.indexOf(type)])].join(" ")
  const definition = [
    `${sum} :: ${[...inputs, "Velocity"].join(" -> ")}`,
    `${[sum, ...names].join(" ")} = Velocity (v1 + v2) (w1 + w2)`,
    "  where",
    `    Velocity v1 w1 = ${call(loser, one)}`,
    `    Velocity v2 w2 = ${call(winner, other)}`,
  ].join("\n")
  return {
    title: words.conflicts.addsUp(loser, winner),
    edits: [
      {start: main.start, end: main.start, text: `${definition}\n\n`},
      {...won, text: sum},
      withComma(text, lost),
    ],
  }
}

/// What a function takes that is always there and gives a velocity each time.
function inputsOf(type: Type | undefined): readonly string[] | undefined {
  if (type === undefined) return undefined
  const found: string[] = []
  let output = type
  for (let f = asFunction(output); f !== undefined; f = asFunction(output)) {
    const {head} = spine(f.from)
    if (head.kind !== "con" || !(states.has(head.name) || samples.has(head.name))) return undefined
    found.push(showType(f.from))
    output = f.to
  }
  const {head} = spine(output)
  return head.kind === "con" && head.name === "Velocity" ? found : undefined
}

/// Where `simulate` names a function as a part of its tuple, and nowhere else.
function placeOf(name: string, text: string, from: number, to: number) {
  const all = [...text.slice(from, to).matchAll(new RegExp(`(?<=[(,]\\s*)${name}(?=\\s*[,)])`, "g"))]
  const [only, ...others] = all
  if (only === undefined || others.length > 0) return undefined
  return {start: from + only.index, end: from + only.index + name.length}
}

/// The part of a tuple with the comma behind it, or the one before it.
function withComma(text: string, {start, end}: {readonly start: number; readonly end: number}) {
  const after = /^\s*,\s*/.exec(text.slice(end))
  if (after !== null) return {start, end: end + after[0].length, text: ""}
  const before = /\s*,\s*$/.exec(text.slice(0, start))
  return {start: start - (before?.[0].length ?? 0), end, text: ""}
}
