/// A pupil's programs in this browser, with what is known of their versions on the service.

import type {ProgramStore} from "../../storage/program_store.ts"
import type {StoredProgram} from "../../storage/stored_values.ts"
import type {Memberships, SyncRecord} from "../messages/membership.ts"

/// A name for a copy, and an entry for it.
export interface Naming {
  name(of: string, others: readonly {readonly name: string}[]): string
  place(): string
  /// The project file with another name.
  renamed(text: string, name: string): string
}

export class LocalPrograms {
  private readonly memberships: Memberships
  private readonly programStore: ProgramStore
  private readonly naming: Naming

  constructor(memberships: Memberships, programStore: ProgramStore, naming: Naming) {
    this.memberships = memberships
    this.programStore = programStore
    this.naming = naming
  }

  /// By the entries of the programs.
  records(): {readonly [id: string]: SyncRecord} {
    return this.memberships.read()?.programs ?? {}
  }

  recordOf(id: string): SyncRecord | undefined {
    return this.records()[id]
  }

  setRecord(id: string, record: SyncRecord): void {
    const now = this.memberships.read()
    if (now !== null) this.memberships.write({...now, programs: {...now.programs, [id]: record}})
  }

  /// The text of a program that is in the list.
  textOf(id: string): string | null {
    return this.listed(id) === undefined ? null : this.programStore.read(id)
  }

  nameOf(id: string): string {
    return this.listed(id)?.name ?? ""
  }

  newPlace(): string {
    return this.naming.place()
  }

  /// Whether it was stored.
  insert(id: string, name: string, text: string): boolean {
    return this.programStore.insert(id, name, text, Date.now())
  }

  /// Copies a program to an entry with another name; `null` if there is none, or the storage is full.
  copyApart(id: string): string | null {
    const text = this.textOf(id)
    if (text === null) return null
    const name = this.naming.name(this.nameOf(id), this.programStore.programs())
    const copy = this.newPlace()
    return this.insert(copy, name, this.naming.renamed(text, name)) ? copy : null
  }

  private listed(id: string): StoredProgram | undefined {
    return this.programStore.programs().find(program => program.id === id)
  }
}
