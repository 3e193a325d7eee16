/// A text that two edit together: whatever the order of their messages, both have the same text, nothing is lost, and undo takes back one's own changes only.

import {EditorState, Transaction, type TransactionSpec} from "@codemirror/state"
import fc from "fast-check"
import {expect, test} from "vitest"
import type {SharingMessage, SharingRequest} from "../../src/classroom/messages/shared_messages.ts"
import {openSharedSession, type SharedSession} from "../../src/classroom/sharing/shared_session.ts"
import {openSharedText, type SharedText, sharedText} from "../../src/views/source/shared_text.ts"
import type {Side} from "../../src/wire/classroom/shared_messages.generated.ts"

/// One of the two, with messages that are on their way in both directions.
class Author {
  readonly side: Side
  state: EditorState
  readonly text: SharedText
  readonly session: SharedSession
  readonly sent: SharingRequest[] = []
  readonly arriving: SharingMessage[] = []
  isBroken = false

  constructor(side: Side, doc: string) {
    this.side = side
    this.state = EditorState.create({doc, extensions: sharedText(side, "the other")})
    this.text = openSharedText(this)
    this.session = openSharedSession(
      this.text,
      message => this.sent.push(message),
      () => {
        this.isBroken = true
      },
      () => {},
    )
  }

  dispatch(change: Transaction | TransactionSpec): void {
    this.state = (change instanceof Transaction ? change : this.state.update(change)).state
  }

  edit(from: number, to: number, insert: string): void {
    const {length} = this.state.doc
    const [start, end] = [from % (length + 1), to % (length + 1)]
    this.dispatch({changes: {from: Math.min(start, end), to: Math.max(start, end), insert}})
    this.session.changed()
  }

  types(at: number, insert: string): void {
    this.edit(at, at, insert)
  }

  hears(): boolean {
    const message = this.arriving.shift()
    if (message !== undefined) this.session.heard(message)
    return message !== undefined
  }

  get doc(): string {
    return this.state.doc.toString()
  }
}

/// The service's rule (protocol §11.1), between two authors.
class Room {
  readonly teacher: Author
  readonly pupil: Author
  version = 0

  constructor(doc: string) {
    this.teacher = new Author("teacher", doc)
    this.pupil = new Author("pupil", doc)
  }

  get authors(): readonly Author[] {
    return [this.teacher, this.pupil]
  }

  serves(author: Author): boolean {
    const request = author.sent.shift()
    if (request?.op === "push" && request.version === this.version) {
      const updates = request.changes.map(changes => ({by: author.side, changes}))
      // As they arrive: from JSON.
      const message = JSON.parse(JSON.stringify({op: "updates", version: this.version, updates}))
      this.version += updates.length
      for (const each of this.authors) each.arriving.push(message as SharingMessage)
    } else if (request?.op === "cursor")
      (author === this.pupil ? this.teacher : this.pupil).arriving.push(request)
    return request !== undefined
  }

  settles(): void {
    let isGoing = true
    while (isGoing) {
      isGoing = false
      for (const author of this.authors) {
        while (this.serves(author)) isGoing = true
        while (author.hears()) isGoing = true
      }
    }
  }
}

const who = fc.constantFrom<"teacher" | "pupil">("teacher", "pupil")
const step = fc.oneof(
  fc.record({
    kind: fc.constant("edit" as const),
    who,
    from: fc.nat(60),
    to: fc.nat(60),
    insert: fc.constantFrom("", "x", "0.5", "\n", "f a = 1\n", "ä😀", "-- long comment"),
  }),
  fc.record({kind: fc.constantFrom("undo", "redo", "serve", "hear", "cursor"), who}),
)

test("both have the same text after any edits, undos and delays", () => {
  fc.assert(
    fc.property(
      fc.constantFrom("", "main = simulate f\n\nf = 0.5"),
      fc.array(step, {maxLength: 60}),
      (doc, steps) => {
        const room = new Room(doc)
        for (const one of steps) {
          const author = room[one.who]
          if (one.kind === "edit") author.edit(one.from, one.to, one.insert)
          else if (one.kind === "serve") room.serves(author)
          else if (one.kind === "hear") author.hears()
          else if (one.kind === "cursor") {
            const cursor = author.text.selection()
            if (cursor !== null) author.sent.push({op: "cursor", ...cursor})
          } else {
            author.text[one.kind]()
            author.session.changed()
          }
        }
        room.settles()
        expect(room.teacher.doc).toBe(room.pupil.doc)
        expect(room.authors.map(author => author.isBroken)).toEqual([false, false])
        expect(room.authors.map(author => author.text.pending())).toEqual([null, null])
      },
    ),
  )
})

test("nothing is lost when both type in the same line at the same time", () => {
  const room = new Room("main = ")
  const letters = {teacher: "abcdefgh", pupil: "12345678"}
  for (let i = 0; i < 8; i += 1) {
    for (const side of ["teacher", "pupil"] as const)
      room[side].types(room[side].doc.length, letters[side][i] ?? "")
    // The pupil's messages are slower.
    room.serves(room.teacher)
    room.teacher.hears()
    if (i % 3 === 0) room.pupil.hears()
    if (i % 2 === 0) room.serves(room.pupil)
  }
  room.settles()
  expect(room.teacher.doc).toBe(room.pupil.doc)
  const typed = room.teacher.doc.slice("main = ".length)
  expect(typed.replace(/\d/g, "")).toBe(letters.teacher)
  expect(typed.replace(/\D/g, "")).toBe(letters.pupil)
})

test("undo takes back one's own changes only, and redo makes them again", () => {
  const room = new Room("a")
  room.pupil.types(1, "P")
  room.settles()
  room.teacher.types(0, "T")
  room.settles()
  expect(room.pupil.doc).toBe("TaP")
  room.pupil.text.undo()
  room.pupil.session.changed()
  room.settles()
  expect(room.teacher.doc).toBe("Ta")
  // Nothing else is the pupil's.
  room.pupil.text.undo()
  room.pupil.session.changed()
  room.settles()
  expect(room.pupil.doc).toBe("Ta")
  room.pupil.text.redo()
  room.pupil.session.changed()
  room.settles()
  expect(room.teacher.doc).toBe("TaP")
})

test("the other's cursor stays at its letter while oneself writes before it", () => {
  const room = new Room("one\ntwo")
  room.pupil.types(0, "x")
  room.teacher.arriving.push({op: "cursor", version: 0, anchor: 4, head: 7})
  room.teacher.hears()
  expect(room.teacher.text.otherLine()).toBe(2)
  room.teacher.types(0, "zero\n")
  expect(room.teacher.text.otherLine()).toBe(3)
  // A position in a version that this side does not have is told again later.
  room.settles()
  room.teacher.text.showCursor({version: 0, anchor: 0, head: 0})
  expect(room.teacher.text.otherLine()).toBe(3)
})

test("updates that do not fit the text end the session instead of damaging it", () => {
  const bad: SharingMessage[] = [
    {op: "updates", version: 3, updates: []},
    {op: "updates", version: 0, updates: [{by: "pupil", changes: [99]}]},
    {op: "updates", version: 0, updates: [{by: "pupil", changes: [[1, 2]]}]},
  ]
  for (const message of bad) {
    const author = new Author("teacher", "main")
    author.session.heard(message)
    expect(author.isBroken).toBe(true)
    expect(author.doc).toBe("main")
  }
})
