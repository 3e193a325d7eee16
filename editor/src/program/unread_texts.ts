/// Texts of definitions that edits of blocks have written and the compiler has not read yet. Pure.
///
/// In: the edits of the program. Out: the texts that the next answer of the compiler is compared with, however many edits, Undo and Redo came before it.

import type {ChangeOrigin, Document} from "./history.ts"
import type {Definition} from "./program.ts"

export interface UnreadText {
  /// Of the definition.
  readonly name: string
  readonly text: string
  /// The text of the program was edited since, in the Haskell or by a command.
  readonly isFollowedByText: boolean
}

/// Texts that are remembered. One that was taken back by Undo is read only after Redo.
const maxTexts = 200

/// The unread texts after an edit that led from `before` to `after`.
export function withEdit(
  unread: readonly UnreadText[],
  before: Document,
  after: Document,
  by: ChangeOrigin,
): readonly UnreadText[] {
  if (by !== "blocks" && unread.length === 0) return unread
  const known = new Set(unread.map(u => u.text))
  // A definition that is edited as text before the compiler has read it is still the one of the blocks.
  const namesOfUnread = new Set(unreadDefinitions(before, unread).map(d => d.name))
  const isWritten = (d: Definition) => by === "blocks" || namesOfUnread.has(d.name)
  const isFollowedByText = by !== "blocks"
  const written = changedDefinitions(after, before)
    .filter(isWritten)
    .map(d => ({name: d.name, text: textOf(after, d), isFollowedByText}))
  return [
    ...unread.map(u => (isFollowedByText ? {...u, isFollowedByText} : u)),
    ...written.filter(u => !known.has(u.text)),
  ].slice(-maxTexts)
}

/// The unread texts after the compiler has read the document.
export function withoutRead(unread: readonly UnreadText[], document: Document): readonly UnreadText[] {
  const read = new Set(unreadDefinitions(document, unread).map(d => textOf(document, d)))
  return read.size === 0 ? unread : unread.filter(u => !read.has(u.text))
}

/// The definitions of a document whose text the compiler has not read.
export function unreadDefinitions(document: Document, unread: readonly UnreadText[]): readonly Definition[] {
  if (unread.length === 0) return []
  const texts = new Set(unread.map(u => u.text))
  return document.program.definitions.filter(d => texts.has(textOf(document, d)))
}

/// The newest document of `past` from before the unread edits of these definitions, and its place there; `null` when there is none.
export function newestBefore(
  past: readonly Document[],
  unread: readonly UnreadText[],
  definitions: readonly Definition[],
): {readonly at: number; readonly document: Document} | null {
  const names = new Set(definitions.map(d => d.name))
  const texts = new Set(unread.filter(u => names.has(u.name)).map(u => u.text))
  for (const [at, document] of [...past.entries()].reverse()) {
    if (!document.program.definitions.some(d => texts.has(textOf(document, d)))) return {at, document}
  }
  return null
}

function textOf({program}: Document, {start, end}: Definition): string {
  return program.text.slice(start, end)
}

function changedDefinitions(document: Document, before: Document): readonly Definition[] {
  const known = new Set(before.program.definitions.map(d => textOf(before, d)))
  return document.program.definitions.filter(d => !known.has(textOf(document, d)))
}
