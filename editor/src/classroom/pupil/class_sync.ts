/// Synchronization of a pupil's programs with the class: saves changes, fetches what another device changed, and makes two programs of a conflict.
///
/// No text is lost: the browser's copy is replaced only when it is the unchanged text of an earlier version on the service; otherwise it gets a name of its own first.

import {hashOf} from "@rosy/codegen"
import type {ProgramStore} from "../../storage/program_store.ts"
import type {
  ProgramName,
  PupilAnswer,
  PupilRequest,
  Reason,
  SaveFailed,
} from "../../wire/classroom/pupil_messages.generated.ts"
import type {Membership, Memberships, SyncRecord} from "../messages/membership.ts"

/// The page's open program, as synchronization needs it.
export interface OpenProgram {
  /// Its entry in the program store; `null` when it has none.
  id(): string | null
  /// Stores it in the program store.
  store(): void
  /// Gives it an entry of its own although it is unchanged, as an example that runs.
  claim(): void
  /// Shows the text of an entry in its place.
  show(id: string, text: string): void
  /// Gives the program as it is on the page a new entry and a new name, because its entry has another text now.
  becomeTwo(): void
}

export interface ClassSync {
  /// The pupil is in the class: compare all programs. `isNew`, on a device that was not or that was in another class meanwhile: open what was changed last.
  entered(programs: readonly ProgramName[], isNew: boolean): void
  heard(message: PupilAnswer & {readonly op: "program" | "saved" | "conflict" | "unsaved"}): void
  /// Saves the open program if it differs from the version on the service; with a run also one that is unchanged, as an example.
  save(reason: Reason): void
  /// Saves the open program also if it is unchanged, as an example that is handed in: what the class has of a pupil's is among the pupil's programs.
  saveOpened(reason: Reason): void
  lost(): void
  /// The service runs another class now: the open program stays with the class in which it was made.
  left(): void
  /// Sends again what the service could not store or read.
  retry(): void
  state(): SyncState
}

/// `saving` while a request waits for its answer or a text could not be sent yet; else why the service could not store one.
/// Why the class could not store a program: `full` when the pupil's share of the disk is.
export type SaveFault = SaveFailed["reason"]

export type SyncState = "saved" | "saving" | SaveFault

/// A name for a copy, and an entry for it.
export interface Naming {
  name(of: string, others: readonly {readonly name: string}[]): string
  place(): string
  /// The project file with another name.
  renamed(text: string, name: string): string
}

interface Request {
  readonly program: string
  readonly hash: string
}

export function openClassSync(
  memberships: Memberships,
  shelf: ProgramStore,
  open: OpenProgram,
  naming: Naming,
  send: (message: PupilRequest) => boolean,
  changed: () => void,
): ClassSync {
  const waiting = new Map<string, Request>()
  /// Programs that were read because the page opens them.
  let toOpen: string | null = null
  /// Programs that were asked for.
  const reading = new Set<string>()
  /// Programs whose newest text is not on its way.
  const behind = new Set<string>()
  /// Programs that the service could not store, and why.
  const unstored = new Map<string, SaveFault>()

  const update = (change: (now: Membership) => Membership) => {
    const now = memberships.read()
    if (now !== null) memberships.write(change(now))
  }
  const recordOf = (id: string): SyncRecord | undefined => memberships.read()?.programs[id]
  const setRecord = (id: string, record: SyncRecord) =>
    update(now => ({...now, programs: {...now.programs, [id]: record}}))
  const read = (program: string) => {
    if (send({op: "read", program})) reading.add(program)
  }
  /// The text of a program that is in the list.
  const listed = (id: string) => shelf.programs().find(program => program.id === id)
  const textOf = (id: string) => (listed(id) === undefined ? null : shelf.read(id))

  const push = (id: string, reason: Reason) => {
    const text = textOf(id)
    if (text === null) return
    const record = recordOf(id) ?? {version: 0, hash: "", marks: []}
    const hash = hashOf(text)
    if (record.hash === hash && record.marks.length === 0) {
      behind.delete(id)
      unstored.delete(id)
      return
    }
    if ([...waiting.values()].some(request => request.program === id)) {
      behind.add(id)
      return
    }
    // A request that is repeated keeps its mark, so that repetitions do not displace the marks of others.
    const mark = (unstored.has(id) ? record.marks.at(-1) : undefined) ?? naming.place()
    const name = listed(id)?.name ?? ""
    const {version: base, marks: unacknowledged} = record
    behind.delete(id)
    // Before it is sent: a page that ends now must know later what the service may have stored.
    setRecord(id, {...record, marks: [...new Set([...unacknowledged, mark])].slice(-mostMarks)})
    const sent = send({op: "save", program: id, name, text, reason, base, mark, unacknowledged})
    if (sent) waiting.set(mark, {program: id, hash})
    else {
      setRecord(id, record)
      behind.add(id)
    }
  }
  const copyApart = (id: string): string | null => {
    const text = textOf(id)
    if (text === null) return null
    const name = naming.name(listed(id)?.name ?? "", shelf.programs())
    const copy = naming.place()
    return shelf.insert(copy, name, naming.renamed(text, name), Date.now()) ? copy : null
  }
  /// The service's version takes the entry; what the browser has instead becomes a program of its own.
  const becomeTwo = (id: string, version: number, name: string, text: string) => {
    if (open.id() === id) {
      open.store()
      if (!shelf.insert(id, name, text, Date.now())) return
      setRecord(id, {version, hash: hashOf(text), marks: []})
      open.becomeTwo()
      const copy = open.id()
      if (copy !== null) push(copy, "change")
      return
    }
    const copy = copyApart(id)
    if (copy === null) return
    if (shelf.insert(id, name, text, Date.now())) setRecord(id, {version, hash: hashOf(text), marks: []})
    push(copy, "change")
  }
  const received = (id: string, version: number, name: string, text: string) => {
    if (open.id() === id) open.store()
    const local = textOf(id)
    const record = recordOf(id)
    const hash = hashOf(text)
    const isUnchanged = local === null || local === text || hashOf(local) === record?.hash
    if (!isUnchanged) {
      // The service decides whether it is a conflict: it may have stored what was never answered.
      push(id, "change")
      return
    }
    if (local !== text && !shelf.insert(id, name, text, Date.now())) return
    setRecord(id, {version, hash, marks: []})
    if (local !== text && (open.id() === id || toOpen === id)) open.show(id, text)
    else if (toOpen === id && open.id() !== id) open.show(id, text)
  }
  const save = (reason: Reason, claims: boolean) => {
    open.store()
    if (open.id() === null && claims) open.claim()
    const id = open.id()
    if (id !== null) push(id, reason)
    changed()
  }
  return {
    entered(programs, isNew) {
      open.store()
      waiting.clear()
      reading.clear()
      unstored.clear()
      const newest = programs[0]
      toOpen = isNew && newest !== undefined ? newest.id : null
      const local = toOpen === null ? null : textOf(toOpen)
      if (toOpen !== null && local !== null && open.id() !== toOpen) open.show(toOpen, local)
      const known = memberships.read()?.programs ?? {}
      for (const {id, version} of programs) {
        const record = known[id]
        if (textOf(id) === null) {
          // A program with a record was here and is deleted.
          if (record === undefined || toOpen === id) read(id)
        } else if (record?.version === version) push(id, "change")
        else read(id)
      }
      const there = new Set(programs.map(program => program.id))
      const current = open.id()
      for (const id of new Set([...Object.keys(known), ...(current === null ? [] : [current])]))
        if (!there.has(id)) push(id, "change")
      changed()
    },
    heard(message) {
      const {program} = message
      if (message.op === "program") {
        reading.delete(program)
        received(program, message.version, message.name, message.text)
      } else {
        const request = waiting.get(message.mark)
        waiting.delete(message.mark)
        if (message.op === "unsaved") unstored.set(program, message.reason)
        else unstored.delete(program)
        if (message.op === "saved" && request !== undefined) {
          setRecord(program, {version: message.version, hash: request.hash, marks: []})
          if (behind.has(program)) push(program, "change")
        } else if (message.op === "conflict") becomeTwo(program, message.version, message.name, message.text)
      }
      changed()
    },
    save: reason => save(reason, reason === "run"),
    saveOpened: reason => save(reason, true),
    lost() {
      for (const {program} of waiting.values()) behind.add(program)
      waiting.clear()
      reading.clear()
      changed()
    },
    left() {
      open.store()
      const id = open.id()
      if (id !== null && recordOf(id) === undefined) setRecord(id, {version: 0, hash: "", marks: []})
      waiting.clear()
      reading.clear()
      behind.clear()
      unstored.clear()
      toOpen = null
    },
    retry() {
      for (const [id, fault] of [...unstored]) if (fault !== "full") push(id, "change")
      for (const id of [...reading]) read(id)
      changed()
    },
    state() {
      const [fault] = unstored.values()
      if (fault !== undefined) return fault
      return waiting.size > 0 || behind.size > 0 || reading.size > 0 ? "saving" : "saved"
    },
  }
}

/// Marks that the service accepts in a request (protocol §11).
const mostMarks = 20
