/// Clips: definitions taken out of a program with all that they need, as Haskell text with its comments, and put into another program. Pure.
///
/// A clip is text and nothing else, so comments and layout come back as they were. A name that the other program has for something else gets a
/// number behind it; what the other program has already, word for word, is left out.

import {namesBoundInside} from "../model/bound_names.ts"
import {everyNode} from "../model/child_nodes.ts"
import {uniqueName} from "../model/unique_name.ts"
import {importsIn} from "../source/imports.ts"
import {tokens} from "../source/lexer.ts"
import {type Item, lex} from "../source/top_level_items.ts"
import type {Module, Piece} from "./module/module_pieces.ts"
import type {Reader} from "./module/module_reader.ts"
import {placesToRename, renameContext} from "./symbol_rename.ts"

export interface Clip {
  /// The definition that was asked for.
  readonly name: string
  /// What it needs of its program, in the order of the text.
  readonly others: readonly string[]
  /// Imports and language pragmas, then the definitions.
  readonly text: string
}

export type ClipMerge =
  | {
      readonly ok: true
      readonly text: string
      /// The names of the definitions that were added, as they are called now.
      readonly added: readonly string[]
      readonly renamed: readonly {readonly from: string; readonly to: string}[]
      /// What the program had already.
      readonly present: readonly string[]
    }
  | {readonly ok: false; readonly why: string}

/// All names that a piece of a program defines: functions, types, constructors and fields.
function namesOf({names, declaration: d}: Piece): readonly string[] {
  if (d?.kind !== "data") return names
  return [
    ...names,
    ...d.constructors.flatMap(made => [made.name, ...made.fields.flatMap(field => field.name ?? [])]),
  ]
}

/// The text of a definition with the comment above it.
function textOf({slice, start, end, core, remark}: Piece): string {
  return slice.slice((remark ?? core).start - start, end - start).trimEnd()
}

/// The names that a piece says and does not bind itself.
function usedBy(piece: Piece): ReadonlySet<string> {
  const bound = piece.declaration === undefined ? new Set<string>() : namesBoundInside(piece.declaration)
  const code = piece.slice.slice(piece.core.start - piece.start, piece.core.end - piece.start)
  return new Set(
    tokens(code)
      .filter(({kind}) => kind !== "comment" && kind !== "string")
      .map(({start, end}) => code.slice(start, end))
      .filter(name => !bound.has(name)),
  )
}

/// The clip of a definition; undefined where the program has no such definition, or none that can be taken out: what runs the program, and broken text.
export function clipOf({text, pieces}: Module, name: string): Clip | undefined {
  const definitions = pieces.filter(piece => piece.kind === "declaration")
  const first = definitions.find(piece => piece.names.includes(name))
  if (first === undefined || name === "main" || first.broken) return undefined
  const taken = new Set<Piece>()
  const needed = new Set([name])
  for (let before = -1; before < taken.size; ) {
    before = taken.size
    for (const piece of definitions) {
      const isInstance = piece.declaration?.kind === "instance"
      const isNeeded = isInstance
        ? isInstanceOf(piece, needed, definitions)
        : namesOf(piece).some(own => needed.has(own))
      if (!isNeeded || taken.has(piece) || piece.names.includes("main")) continue
      taken.add(piece)
      for (const used of usedBy(piece)) needed.add(used)
    }
  }
  const inOrder = definitions.filter(piece => taken.has(piece))
  const names = inOrder.flatMap(({names: own, declaration: d}) => (d?.kind === "instance" ? [] : own))
  const parts = [neededHead(text, needed).join("\n"), ...inOrder.map(textOf)]
  return {
    name,
    others: names.filter(other => other !== name),
    text: `${parts.filter(part => part !== "").join("\n\n")}\n`,
  }
}

/// Whether an instance is one of a type or class of the program that is needed.
function isInstanceOf(piece: Piece, needed: ReadonlySet<string>, definitions: readonly Piece[]): boolean {
  if (piece.declaration?.kind !== "instance") return false
  const {head} = piece.declaration
  const own = new Set(definitions.flatMap(({names}) => names))
  const texts = tokens(head).map(({start, end}) => head.slice(start, end))
  return texts.some(name => own.has(name) && needed.has(name))
}

function headItems(text: string): readonly {readonly item: Item; readonly text: string}[] {
  return lex(text).items.map(item => ({item, text: text.slice(item.start, item.end)}))
}

const isLanguage = (text: string) => /^\{-#\s*LANGUAGE\b/i.test(text)

/// The language pragmas, and the imports of which a name is used, or which may bring any name.
function neededHead(text: string, needed: ReadonlySet<string>): readonly string[] {
  const qualifiers = new Set([...needed].map(name => name.slice(0, Math.max(0, name.lastIndexOf(".")))))
  return headItems(text).flatMap(({item, text: itemText}) => {
    if (item.kind === "pragma") return isLanguage(itemText) ? [itemText] : []
    if (item.kind !== "import") return []
    const [found] = importsIn(itemText)
    if (found === undefined || found.module === "Rosy") return []
    const isUsed =
      qualifiers.has(found.as) ||
      (!found.qualified && (found.only === undefined || [...found.only].some(name => needed.has(name))))
    return isUsed ? [itemText] : []
  })
}

/// The program with the clip before its `main`, or at its end.
export function mergeClip(reader: Reader, text: string, clipText: string): ClipMerge {
  const own = reader.read(text).pieces.filter(piece => piece.kind === "declaration")
  const texts = new Set(own.map(textOfCore))
  const names = new Set(own.flatMap(namesOf))
  const renamed: {from: string; to: string}[] = []
  let clip = clipText
  for (;;) {
    const pieces = reader.read(clip).pieces.filter(piece => piece.kind === "declaration")
    const clash = pieces
      .filter(piece => !texts.has(textOfCore(piece)))
      .flatMap(piece => namesOf(piece).map(name => ({piece, name})))
      .find(({name}) => names.has(name))
    if (clash === undefined) {
      const isPresent = (piece: Piece) => texts.has(textOfCore(piece))
      const added = pieces.filter(piece => !isPresent(piece))
      return {
        ok: true,
        text: inserted(text, clip, added.map(textOf), own),
        added: added.flatMap(({names: all, declaration: d}) => (d?.kind === "instance" ? [] : all)),
        renamed,
        present: pieces.filter(isPresent).flatMap(piece => piece.names),
      }
    }
    const {piece, name} = clash
    const taken = new Set([...names, ...pieces.flatMap(namesOf), ...pieces.flatMap(boundInside)])
    const to = uniqueName(name, taken)
    const word = piece.words.find(
      ({start, end}) => clip.slice(piece.core.start + start, piece.core.start + end) === name,
    )
    const offset = word === undefined ? clip.indexOf(name, piece.core.start) : piece.core.start + word.start
    const outcome = placesToRename(renameContext(reader, clip), offset, name, to)
    if (!outcome.ok) return outcome
    clip = [...outcome.places]
      .sort((a, b) => b.start - a.start)
      .reduce((changed, {start, end}) => changed.slice(0, start) + to + changed.slice(end), clip)
    renamed.push({from: name, to})
  }
}

const textOfCore = (piece: Piece): string =>
  piece.slice.slice(piece.core.start - piece.start, piece.core.end - piece.start).trimEnd()

/// Names that something inside a definition has: a renamed definition must not be hidden by one of them.
function boundInside({declaration: d}: Piece): readonly string[] {
  return d === undefined ? [] : [...everyNode(d)].flatMap(node => ("name" in node ? (node.name ?? []) : []))
}

/// `text` with definitions before its `main`, and with the head of the clip as far as it lacks that.
function inserted(text: string, clip: string, definitions: readonly string[], own: readonly Piece[]): string {
  if (definitions.length === 0) return text
  const main = own.find(({names}) => names.includes("main"))
  const at = main === undefined ? text.trimEnd().length : (main.remark ?? main.core).start
  const added = definitions.join("\n\n")
  const before = text.slice(0, at)
  const body =
    main === undefined
      ? `${before === "" ? "" : `${before}\n\n`}${added}\n`
      : `${before}${before === "" || before.endsWith("\n\n") ? "" : "\n"}${added}\n\n${text.slice(at)}`
  const items = headItems(text)
  const lacking = headItems(clip)
    .filter(
      ({item, text: itemText}) => item.kind === "import" || (item.kind === "pragma" && isLanguage(itemText)),
    )
    .filter(({text: itemText}) => !items.some(other => other.text === itemText))
  const pragmas = lacking
    .filter(({item}) => item.kind === "pragma")
    .map(({text: itemText}) => `${itemText}\n`)
  const imports = lacking
    .filter(({item}) => item.kind === "import")
    .map(({text: itemText}) => `${itemText}\n`)
  const lastImport = items.findLast(({item}) => item.kind === "import" || item.kind === "module")?.item
  if (imports.length === 0) return pragmas.join("") + body
  const firstDefinition = items.find(({item}) => item.kind === "declaration")?.item.start ?? at
  const place =
    lastImport !== undefined
      ? lastImport.end + 1
      : Math.min(at, (own[0]?.remark ?? own[0]?.core)?.start ?? firstDefinition)
  const gap = lastImport === undefined ? "\n" : ""
  return pragmas.join("") + body.slice(0, place) + imports.join("") + gap + body.slice(place)
}
