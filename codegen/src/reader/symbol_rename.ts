/// Rename of a symbol in the text: all references of a name are found, and only these words are replaced. Types, type variables and constructors are found through
/// the syntax tree: a type or constructor has one meaning in the whole program, a type variable in one definition. Pure.

import {isConstructorName, isVariableName, reservedWords} from "../haskell/lexemes.ts"
import {everyNode} from "../model/child_nodes.ts"
import type {BlockId, SavedWorkspace} from "../serialized_blocks.ts"
import {tokens} from "../source/lexer.ts"
import {words} from "../words/index.ts"
import {knownNames} from "../workspace/inference/name_catalog.ts"
import {renameNamed} from "../workspace/renaming/renaming.ts"
import type {Module, Piece} from "./module/module_pieces.ts"
import type {Reader} from "./module/module_reader.ts"
import type {Word, WordRole} from "./module/semantic_tokens.ts"
import {openView} from "./view/text_synchronization.ts"
import {spansOf, workspaceOf} from "./view/view.ts"

/// Offsets in UTF-16 units; `end` is exclusive.
interface Span {
  readonly start: number
  readonly end: number
}

/// A program in which a symbol is renamed: its text, the text range of each block, and its syntax trees.
export interface RenameContext {
  readonly text: string
  readonly spans: readonly (Span & {readonly block: BlockId | undefined})[]
  readonly workspace: SavedWorkspace
  readonly module: Module | undefined
  /// Whether some definition's text is broken, so that places in it are not found.
  readonly isUnfinished: boolean
}

export type RenameOutcome =
  /// The places of the old name.
  {readonly ok: true; readonly places: readonly Span[]} | {readonly ok: false; readonly why: string}

/// The context of a text that no page shows.
export function renameContext(reader: Reader, text: string): RenameContext {
  const view = openView(reader, text)
  return {
    text,
    spans: spansOf(view).spans,
    workspace: workspaceOf(view),
    module: view.module,
    isUnfinished: view.module.pieces.some(piece => piece.broken),
  }
}

/// Where `old`, which stands at an offset, has to become `name`: wherever it means the same.
export function placesToRename(
  context: RenameContext,
  offset: number,
  old: string,
  name: string,
): RenameOutcome {
  const {text, spans} = context
  const block = innermostBlock(spans, {start: offset, end: offset + old.length})
  if (block === undefined) return {ok: false, why: words.renaming.thisDefinitionIsBroken}
  if (context.isUnfinished) return {ok: false, why: words.renaming.somethingIsUnfinished}
  const byRole = renamedByRole(context, offset, old, name)
  if (byRole !== undefined) return byRole
  if (isPun(context.module, old)) return {ok: false, why: words.renaming.isAlsoTheNameOfAPart(old)}
  const answer = renameNamed(context.workspace, block, old, name)
  if (!answer.ok) return answer
  const meant = new Set(answer.changes.map(change => change.block))
  const places = tokens(text).filter(token => {
    if ((token.kind !== "name" && token.kind !== "type") || text.slice(token.start, token.end) !== old)
      return false
    const owner = innermostBlock(spans, token)
    return owner !== undefined && meant.has(owner)
  })
  return {ok: true, places}
}

/// Whether a record is written with a field's name alone, `C {name}`: there one word names a field and a variable.
function isPun(module: Module | undefined, name: string): boolean {
  return (module?.pieces ?? []).some(({declaration: d}) =>
    d === undefined
      ? false
      : [...everyNode(d)].some(
          node =>
            (node.kind === "record" || node.kind === "update" || node.kind === "record-pattern") &&
            node.fields.some(field => field.pun === true && field.name === name),
        ),
  )
}

/// The block of the smallest span that covers a range.
function innermostBlock(spans: RenameContext["spans"], range: Span): BlockId | undefined {
  let best: RenameContext["spans"][number] | undefined
  for (const span of spans) {
    if (span.block === undefined || span.start > range.start || span.end < range.end) continue
    if (best === undefined || span.end - span.start <= best.end - best.start) best = span
  }
  return best?.block
}

interface Place extends Word {
  readonly piece: Piece
}

/// Renames a type, a variable of types or a constructor; undefined when the place has none of them.
function renamedByRole(
  {module, text}: RenameContext,
  offset: number,
  old: string,
  name: string,
): RenameOutcome | undefined {
  const pieces = module?.pieces ?? []
  const places = pieces.flatMap(piece =>
    piece.words.map(
      (word): Place => ({
        role: word.role,
        start: piece.core.start + word.start,
        end: piece.core.start + word.end,
        piece,
      }),
    ),
  )
  const here = places.find(place => place.start === offset)
  if (here === undefined || !byRoles.includes(here.role)) return undefined
  // The variables of one definition's types have nothing to do with those of another.
  const near = places.filter(
    place => place.role === here.role && (here.role !== "variable" || place.piece === here.piece),
  )
  const saying = (wanted: string) => near.filter(({start, end}) => text.slice(start, end) === wanted)
  // What is kept as text without a tree may say the name too.
  const unread = pieces.some(
    ({kind, words: read, slice}) =>
      kind === "declaration" &&
      read.length === 0 &&
      tokens(slice).some(token => slice.slice(token.start, token.end) === old),
  )
  if (unread) return {ok: false, why: words.renaming.somethingIsUnfinished}
  const why = refusal(here.role, old, name, pieces, saying(name).length > 0)
  if (why !== undefined) return {ok: false, why}
  return {ok: true, places: saying(old)}
}

const byRoles: readonly WordRole[] = ["type", "variable", "constructor"]

/// Why a name of this kind cannot become another; undefined when it can.
function refusal(
  role: WordRole,
  old: string,
  name: string,
  pieces: readonly Piece[],
  taken: boolean,
): string | undefined {
  const say = words.renaming
  if (role === "variable") {
    if (reservedWords.has(name)) return say.isOneOfHaskellsOwnWords(name)
    if (!isVariableName(name)) return say.aNameIsOneWordThatStarts
    return taken ? say.thereIsAnotherAlready(name) : undefined
  }
  if (!isConstructorName(name)) return say.thisNameIsOneWordThatStarts
  const own = pieces.some(({declaration: d}) =>
    role === "type"
      ? (d?.kind === "data" || d?.kind === "synonym") && d.name === old
      : d?.kind === "data" && d.constructors.some(made => made.name === old),
  )
  if (!own) return say.isNotOfThisProgramSo(old)
  const kind = role === "type" ? "type" : "constructor"
  if (knownNames().some(known => known.name === name && known.kind === kind))
    return say.haskellItselfHasAAlready(name)
  return taken ? say.thereIsAnotherAlready(name) : undefined
}
