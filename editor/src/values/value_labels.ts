/// Values of a program at the displayed moment, in place: what each function took last and gave, and what each memory holds. Pure.

import type {BlockId, Definition} from "../program/program.ts"
import type {ProgramPart} from "../program/program_graph.ts"
import type {Frame} from "../state/messages/messages.ts"
import {lookedBackFor, type Question} from "../state/messages/why_state.ts"
import type {PageState} from "../state/page_state.ts"
import {latestFirings} from "../state/runs/firing_log.ts"
import {shownFrame} from "../state/runs/room_state.ts"
import type {Given, Taken} from "../wire/firing.generated.ts"
import type {FiringShown} from "../wire/page/explanations.generated.ts"
import type {words as english} from "../words/index.ts"
import type {Measures} from "../words/number_formats.ts"
import {shortFractions, storedValue} from "./sentence_words.ts"

/// A label at a definition.
export interface ValueLabel {
  readonly definition: Definition
  /// At most `longestText` characters.
  readonly text: string
  readonly whole: string
  /// Whether the values are older than `fresh`, or there are none yet.
  readonly isOld: boolean
}

/// Characters of a label; what is longer is folded.
export const longestText = 56
/// Characters of what a function gave; what it took has the rest.
const longestOutput = 26

/// Values older than this are grey and have their time, s.
const fresh = 1

type Shown = Pick<PageState, "document" | "network" | "room" | "valuesShown">
export type LabelWords = Pick<(typeof english)["why"], "nothing" | "aCall" | "notYet">

export function valueLabels(state: Shown, words: LabelWords, measures: Measures): readonly ValueLabel[] {
  const {room, network, document} = state
  const frame = shownFrame(room)
  if (!state.valuesShown || room.run === null || frame === null) return []
  const time = room.lookedAt ?? frame.time
  const latest = latestFirings(room.firings, time)
  const ever = latestFirings(room.firings, Number.POSITIVE_INFINITY)
  const functions = new Set(network === null ? [] : functionNames(network.parts))
  const label = (definition: Definition): readonly ValueLabel[] => {
    const {name} = definition
    const firing = latest.get(name)
    if (firing !== undefined) return [{definition, ...firingText(firing, time, words, measures)}]
    const memory = memoryOf(definition, document.program.text, frame)
    if (memory !== undefined) return [{definition, ...foldedText(shortFractions(memory.value), "", false)}]
    if (!functions.has(name)) return []
    // Without a record of its firings it is not known what it took and gave.
    const isKnown = ever.has(name) ? room.firings.isWhole : room.fired[name] === undefined
    return isKnown ? [{definition, ...foldedText(words.notYet, "", true)}] : []
  }
  const seen = new Set<string>()
  return document.program.definitions.flatMap(label).filter(({definition: {block}}) => {
    const isFirst = !seen.has(block)
    seen.add(block)
    return isFirst
  })
}

type LabelText = Pick<ValueLabel, "text" | "whole" | "isOld">

/// What a firing took and gave.
export function firingText(
  firing: FiringShown,
  time: number,
  words: LabelWords,
  measures: Measures,
): LabelText {
  const took = firing.took.map(inputText).join(", ")
  const gave = firing.gave.map(one => outputText(one, words)).join(", ") || words.nothing
  const isOld = time - firing.time > fresh
  const when = isOld ? `  ${measures.seconds(firing.time, 2)}` : ""
  const arrow = (inputs: string, outputs: string) => `${inputs === "" ? "" : `${inputs} `}→ ${outputs}`
  const whole = arrow(took, gave)
  const most = longestText - when.length
  const result = folding(gave, longestOutput)
  const folded = arrow(folding(took, most - " → ".length - result.length), result)
  return foldedText(whole.length <= most ? whole : folded, when, isOld, whole)
}

function foldedText(text: string, when: string, isOld: boolean, whole = text): LabelText {
  return {
    text: folding(text, longestText - when.length) + when,
    whole: whole.replace(/\s+/g, " ") + when,
    isOld,
  }
}

/// What a definition of a type remembers.
function memoryOf(definition: Definition, text: string, {memory}: Frame) {
  return memory?.find(({type}) => typesOf(definition, text).has(type))
}

/// Why the values at a definition are as they are at the displayed moment, whether they are shown or not; `null` where there are none.
export function definitionQuestion(state: Omit<Shown, "valuesShown">, block: BlockId): Question | null {
  const {room, network, document} = state
  const frame = shownFrame(room)
  const definition = document.program.definitions.find(one => one.block === block)
  if (room.run === null || frame === null || definition === undefined) return null
  const {name} = definition
  const time = room.lookedAt ?? frame.time
  const memory = memoryOf(definition, document.program.text, frame)
  if (memory !== undefined) return {kind: "memory", type: memory.type, time}
  if (network === null || !functionNames(network.parts).includes(name)) return null
  // Without a record of its firings only the latest one is known.
  const isRecorded = room.firings.isWhole && room.firings.pieces.length > 0
  const hasRun = isRecorded ? latestFirings(room.firings, time).has(name) : room.fired[name] !== undefined
  if (hasRun) return {kind: "run", function: name, time}
  return {kind: "not", function: name, command: "", since: Math.max(0, time - lookedBackFor), until: time}
}

/// The types of the memory that a definition of a type may be about. The service writes types without synonyms.
function typesOf({name, start, end}: Definition, text: string): ReadonlySet<string> {
  const meaning = /^type\s+\S+\s*=\s*(.*\S)\s*$/s.exec(text.slice(start, end))?.[1]?.replace(/\s+/g, " ")
  return new Set(
    [name, ...(meaning === undefined ? [] : [meaning, `(${meaning})`])].map(one => `Memory ${one}`),
  )
}

/// A text on one line, cut at `longest` characters.
function folding(text: string, longest: number): string {
  const line = text.replace(/\s+/g, " ").trim()
  return line.length <= longest ? line : `${line.slice(0, longest - 1)}…`
}

/// The label of a value that cannot be shown is its type.
const inputText = ({value, type}: Taken): string =>
  value === "_" && type !== "" ? type : shortFractions(value)

function outputText({to, value, type}: Given, words: LabelWords): string {
  switch (to) {
    case "done":
      return "Done"
    case "call":
      return words.aCall
    case "memory":
    case "param":
      return value === "" || value === "_" ? type : storedValue(type, shortFractions(value))
    default:
      return value === "" || value === "_" ? type : shortFractions(value)
  }
}

/// The functions that a program runs, also those of its tasks.
export function functionNames(parts: readonly ProgramPart[]): readonly string[] {
  return parts.flatMap((part): readonly string[] => {
    switch (part.kind) {
      case "function":
        return [part.name]
      case "task":
        return functionNames([...part.start, ...part.parts])
      case "step":
        return []
      default:
        return functionNames(part.steps)
    }
  })
}
