/// Synchronization of a pupil's programs with the class: saves changes, fetches what another device changed, and makes two programs of a conflict.
///
/// No text is lost: the browser's copy is replaced only when it is the unchanged text of an earlier version on the service; otherwise it gets a name of its own first.

import {hashOf} from "@rosy/codegen"
import type {ProgramStore} from "../../storage/program_store.ts"
import {
  maxSaveUnacknowledged,
  type ProgramName,
  type PupilAnswer,
  type PupilRequest,
  type Reason,
  type SaveFailed,
} from "../../wire/classroom/pupil_messages.generated.ts"
import type {Memberships} from "../messages/membership.ts"
import {LocalPrograms, type Naming} from "./local_programs.ts"

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

/// Why the class could not store a program: `full` when the pupil's share of the disk is.
export type SaveFault = SaveFailed["reason"]

/// `saving` while a request waits for its answer or a text could not be sent yet; else why the service could not store one.
export type SyncState = "saved" | "saving" | SaveFault

interface Request {
  readonly program: string
  readonly hash: string
}

/// What is on its way to the service and back, and what could not be sent or stored.
class PendingRequests {
  /// Requests to save, by their marks.
  readonly saves = new Map<string, Request>()
  /// Programs that were asked for.
  readonly reads = new Set<string>()
  /// Programs whose newest text is not on its way.
  readonly behind = new Set<string>()
  /// Programs that the service could not store, and why.
  readonly unstored = new Map<string, SaveFault>()

  isSaving(program: string): boolean {
    return [...this.saves.values()].some(request => request.program === program)
  }

  /// No answer comes any more.
  forgetRequests(): void {
    this.saves.clear()
    this.reads.clear()
  }

  state(): SyncState {
    const [fault] = this.unstored.values()
    if (fault !== undefined) return fault
    return this.saves.size > 0 || this.behind.size > 0 || this.reads.size > 0 ? "saving" : "saved"
  }
}

export const openClassSync = (
  memberships: Memberships,
  programStore: ProgramStore,
  open: OpenProgram,
  naming: Naming,
  send: (message: PupilRequest) => boolean,
  changed: () => void,
): ClassSync => new Synchronization(new LocalPrograms(memberships, programStore, naming), open, send, changed)

class Synchronization implements ClassSync {
  private readonly programs: LocalPrograms
  private readonly open: OpenProgram
  private readonly send: (message: PupilRequest) => boolean
  private readonly changed: () => void
  private readonly pending = new PendingRequests()
  /// A program that was read because the page opens it.
  private toOpen: string | null = null

  constructor(
    programs: LocalPrograms,
    open: OpenProgram,
    send: (message: PupilRequest) => boolean,
    changed: () => void,
  ) {
    this.programs = programs
    this.open = open
    this.send = send
    this.changed = changed
  }

  entered(programs: readonly ProgramName[], isNew: boolean): void {
    const {open} = this
    open.store()
    this.pending.forgetRequests()
    this.pending.unstored.clear()
    const newest = programs[0]
    this.toOpen = isNew && newest !== undefined ? newest.id : null
    const local = this.toOpen === null ? null : this.programs.textOf(this.toOpen)
    if (this.toOpen !== null && local !== null && open.id() !== this.toOpen) open.show(this.toOpen, local)
    this.compare(programs)
    this.changed()
  }

  heard(message: PupilAnswer & {readonly op: "program" | "saved" | "conflict" | "unsaved"}): void {
    const {saves, reads, behind, unstored} = this.pending
    const {program} = message
    if (message.op === "program") {
      reads.delete(program)
      this.received(program, message.version, message.name, message.text)
    } else {
      const request = saves.get(message.mark)
      saves.delete(message.mark)
      if (message.op === "unsaved") unstored.set(program, message.reason)
      else unstored.delete(program)
      if (message.op === "saved" && request !== undefined) {
        this.programs.setRecord(program, {version: message.version, hash: request.hash, marks: []})
        if (behind.has(program)) this.push(program, "change")
      } else if (message.op === "conflict")
        this.becomeTwo(program, message.version, message.name, message.text)
    }
    this.changed()
  }

  save(reason: Reason): void {
    this.saveOpen(reason, reason === "run")
  }

  saveOpened(reason: Reason): void {
    this.saveOpen(reason, true)
  }

  lost(): void {
    for (const {program} of this.pending.saves.values()) this.pending.behind.add(program)
    this.pending.forgetRequests()
    this.changed()
  }

  left(): void {
    this.open.store()
    const id = this.open.id()
    if (id !== null && this.programs.recordOf(id) === undefined)
      this.programs.setRecord(id, {version: 0, hash: "", marks: []})
    this.pending.forgetRequests()
    this.pending.behind.clear()
    this.pending.unstored.clear()
    this.toOpen = null
  }

  retry(): void {
    for (const [id, fault] of [...this.pending.unstored]) if (fault !== "full") this.push(id, "change")
    for (const id of [...this.pending.reads]) this.read(id)
    this.changed()
  }

  state(): SyncState {
    return this.pending.state()
  }

  private read(program: string): void {
    if (this.send({op: "read", program})) this.pending.reads.add(program)
  }

  /// Compares all programs of the browser with those of the service.
  private compare(programs: readonly ProgramName[]): void {
    const known = this.programs.records()
    for (const {id, version} of programs) {
      const record = known[id]
      if (this.programs.textOf(id) === null) {
        // A program with a record was here and is deleted.
        if (record === undefined || this.toOpen === id) this.read(id)
      } else if (record?.version === version) this.push(id, "change")
      else this.read(id)
    }
    const there = new Set(programs.map(program => program.id))
    const current = this.open.id()
    for (const id of new Set([...Object.keys(known), ...(current === null ? [] : [current])]))
      if (!there.has(id)) this.push(id, "change")
  }

  private saveOpen(reason: Reason, claims: boolean): void {
    const {open} = this
    open.store()
    if (open.id() === null && claims) open.claim()
    const id = open.id()
    if (id !== null) this.push(id, reason)
    this.changed()
  }

  private push(id: string, reason: Reason): void {
    const {saves, behind, unstored} = this.pending
    const text = this.programs.textOf(id)
    if (text === null) return
    const record = this.programs.recordOf(id) ?? {version: 0, hash: "", marks: []}
    const hash = hashOf(text)
    if (record.hash === hash && record.marks.length === 0) {
      behind.delete(id)
      unstored.delete(id)
      return
    }
    if (this.pending.isSaving(id)) {
      behind.add(id)
      return
    }
    // A request that is repeated keeps its mark, so that repetitions do not displace the marks of others.
    const mark = (unstored.has(id) ? record.marks.at(-1) : undefined) ?? this.programs.newPlace()
    const name = this.programs.nameOf(id)
    const {version: base, marks: unacknowledged} = record
    behind.delete(id)
    // Before it is sent: a page that ends now must know later what the service may have stored.
    this.programs.setRecord(id, {
      ...record,
      marks: [...new Set([...unacknowledged, mark])].slice(-maxSaveUnacknowledged),
    })
    const sent = this.send({op: "save", program: id, name, text, reason, base, mark, unacknowledged})
    if (sent) saves.set(mark, {program: id, hash})
    else {
      this.programs.setRecord(id, record)
      behind.add(id)
    }
  }

  private received(id: string, version: number, name: string, text: string): void {
    const {open, toOpen} = this
    if (open.id() === id) open.store()
    const local = this.programs.textOf(id)
    const record = this.programs.recordOf(id)
    const hash = hashOf(text)
    const isUnchanged = local === null || local === text || hashOf(local) === record?.hash
    if (!isUnchanged) {
      // The service decides whether it is a conflict: it may have stored what was never answered.
      this.push(id, "change")
      return
    }
    if (local !== text && !this.programs.insert(id, name, text)) return
    this.programs.setRecord(id, {version, hash, marks: []})
    if (local !== text && (open.id() === id || toOpen === id)) open.show(id, text)
    else if (toOpen === id && open.id() !== id) open.show(id, text)
  }

  /// The service's version takes the entry; what the browser has instead becomes a program of its own.
  private becomeTwo(id: string, version: number, name: string, text: string): void {
    const {open, programs} = this
    if (open.id() === id) {
      open.store()
      if (!programs.insert(id, name, text)) return
      programs.setRecord(id, {version, hash: hashOf(text), marks: []})
      open.becomeTwo()
      const copy = open.id()
      if (copy !== null) this.push(copy, "change")
      return
    }
    const copy = programs.copyApart(id)
    if (copy === null) return
    if (programs.insert(id, name, text)) programs.setRecord(id, {version, hash: hashOf(text), marks: []})
    this.push(copy, "change")
  }
}
