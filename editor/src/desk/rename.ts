/// Renaming in the text: codegen says what else is meant by a name, and only the name's own letters are replaced. Types, their variables and
/// constructors are told by the syntax tree: each of the three has one meaning in all of the program, or in all of a definition. Pure.

import {isConstructorName, isVariableName, knownNames, renameNamed, reservedWords} from "@rosy/codegen"
import type {Piece, Word, WordRole} from "@rosy/codegen/reader"
import {words as sentences} from "@rosy/codegen/words"
import {tokens} from "../source/lexer.ts"
import type {Document} from "../state/history.ts"
import {innermostBlock} from "../state/program.ts"
import {words} from "../words/index.ts"

export type Renamed = {readonly ok: true; readonly text: string} | {readonly ok: false; readonly why: string}

/// The text after the name `old` at an offset has become `name`, wherever it means the same.
export function renamed(document: Document, offset: number, old: string, name: string): Renamed {
  const {text, spans} = document.program
  const block = innermostBlock(spans, {start: offset, end: offset + old.length})
  if (block === null) return {ok: false, why: words.blocks.broken}
  if (document.dimmed.length > 0)
    return {
      ok: false,
      why: words.blocks.unfinished,
    }
  const byRole = renamedByRole(document, offset, old, name)
  if (byRole !== null) return byRole
  const answer = renameNamed(document.workspace, block, old, name)
  if (!answer.ok) return answer
  const meant = new Set(answer.changes.map(change => change.block))
  let now = ""
  let at = 0
  for (const token of tokens(text)) {
    if ((token.kind !== "name" && token.kind !== "type") || text.slice(token.start, token.end) !== old)
      continue
    const owner = innermostBlock(spans, token)
    if (owner === null || !meant.has(owner)) continue
    now += text.slice(at, token.start) + name
    at = token.end
  }
  return {ok: true, text: now + text.slice(at)}
}

interface Place extends Word {
  readonly piece: Piece
}

/// Renames a type, a variable of types or a constructor; `null` when the place has none of them.
function renamedByRole({view, program}: Document, offset: number, old: string, name: string): Renamed | null {
  const places = (view?.module.pieces ?? []).flatMap(piece =>
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
  if (here === undefined || !byRoles.includes(here.role)) return null
  // The variables of one definition's types have nothing to do with those of another.
  const near = places.filter(
    place => place.role === here.role && (here.role !== "variable" || place.piece === here.piece),
  )
  const saying = (wanted: string) => near.filter(({start, end}) => program.text.slice(start, end) === wanted)
  // What is kept as text without a tree may say the name too.
  const unread = (view?.module.pieces ?? []).some(
    ({kind, words: read, slice}) =>
      kind === "declaration" &&
      read.length === 0 &&
      tokens(slice).some(token => slice.slice(token.start, token.end) === old),
  )
  if (unread) return {ok: false, why: words.blocks.unfinished}
  const why = refusal(here.role, old, name, view?.module.pieces ?? [], saying(name).length > 0)
  if (why !== null) return {ok: false, why}
  let now = ""
  let at = 0
  for (const {start, end} of saying(old)) {
    now += program.text.slice(at, start) + name
    at = end
  }
  return {ok: true, text: now + program.text.slice(at)}
}

const byRoles: readonly WordRole[] = ["type", "variable", "constructor"]

/// Why a name of this kind cannot become another; `null` when it can.
function refusal(
  role: WordRole,
  old: string,
  name: string,
  pieces: readonly Piece[],
  taken: boolean,
): string | null {
  const say = sentences.renaming
  if (role === "variable") {
    if (reservedWords.has(name)) return say.isOneOfHaskellsOwnWords(name)
    if (!isVariableName(name)) return say.aNameIsOneWordThatStarts
    return taken ? say.thereIsAnotherAlready(name) : null
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
  return taken ? say.thereIsAnotherAlready(name) : null
}
