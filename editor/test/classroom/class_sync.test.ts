/// Synchronization of browsers with the class: a service in memory, two browsers, and a network that fails.

import {describe, expect, test} from "vitest"
import {openMemberships} from "../../src/classroom/messages/membership.ts"
import {type ClassSync, openClassSync, type SaveFault} from "../../src/classroom/pupil/class_sync.ts"
import {memoryStorage} from "../../src/storage/memory_storage.ts"
import {openProgramStore} from "../../src/storage/program_store.ts"
import type {
  ProgramName,
  PupilAnswer,
  PupilRequest,
} from "../../src/wire/classroom/pupil_messages.generated.ts"

interface Version {
  readonly version: number
  readonly name: string
  readonly text: string
  readonly mark: string
}

/// Stores versions as `class_store.py` does.
class Service {
  readonly programs = new Map<string, Version>()
  /// Every text that was ever stored.
  readonly history = new Set<string>()
  private version = 0
  /// Why it stores nothing now.
  fault: SaveFault | null = null
  marks: string[] = []

  serve(message: PupilRequest): PupilAnswer | null {
    if (message.op === "read") {
      const found = this.programs.get(message.program)
      return found === undefined ? null : {...found, op: "program", program: message.program}
    }
    if (message.op !== "save") return null
    const {program, name, text, base, mark, unacknowledged = []} = message
    this.marks.push(mark)
    if (this.fault !== null) return {op: "unsaved", program, mark, reason: this.fault}
    const latest = this.programs.get(program)
    if (latest !== undefined && latest.text === text)
      return {op: "saved", program, mark, version: latest.version}
    if (latest !== undefined && latest.version !== base && !unacknowledged.includes(latest.mark))
      return {...latest, op: "conflict", program, mark}
    this.version += 1
    this.history.add(text)
    this.programs.set(program, {version: this.version, name, text, mark})
    return {op: "saved", program, mark, version: this.version}
  }

  entries(): ProgramName[] {
    return [...this.programs]
      .map(([id, {name, version}]) => ({id, name, version, at: 0}))
      .sort((a, b) => b.version - a.version)
  }

  texts(): string[] {
    return [...this.programs.values()].map(({text}) => text).sort()
  }
}

/// A browser with one page. `online` lets requests out, `answered` lets answers in.
class Browser {
  readonly storage = memoryStorage()
  readonly memberships = openMemberships(this.storage)
  readonly programStore = openProgramStore(this.storage, memoryStorage())
  readonly sync: ClassSync
  readonly shown: string[] = []
  online = true
  answered = true
  open: string | null = null
  private count = 0
  private answers: (PupilAnswer | null)[] = []

  service: Service
  private readonly label: string

  constructor(service: Service, label: string) {
    this.service = service
    this.label = label
    this.memberships.setClass("7b")
    this.memberships.write({token: "t", nickname: "Ada", programs: {}})
    this.sync = openClassSync(
      this.memberships,
      this.programStore,
      {
        id: () => this.open,
        store: () => undefined,
        show: (id, text) => {
          this.open = id
          this.page = text
          this.shown.push(text)
        },
        claim: () => {
          this.open = this.place()
          this.programStore.insert(this.open, "walk", this.page, 1)
        },
        becomeTwo: () => {
          // As autosave does: the page keeps its text, under a new entry and name.
          const copy = this.place()
          this.programStore.insert(copy, "walk 2", this.page, 2)
          this.open = copy
        },
      },
      {name: () => "walk 2", place: () => this.place(), renamed: text => text},
      message => {
        if (!this.online) return false
        const answer = this.service.serve(message)
        if (this.answered) this.answers.push(answer)
        return true
      },
      () => undefined,
    )
  }

  /// The text that the page shows, and the one that was written on it last.
  page = ""
  written = ""

  private place(): string {
    this.count += 1
    return `${this.label}${this.count}`
  }

  /// The learner changes the open program; autosave stores it.
  write(text: string): void {
    this.open ??= "p"
    this.page = text
    this.written = text
    this.programStore.save(this.open, "walk", text, 1)
  }

  save(): void {
    this.sync.save("change")
    this.settle()
  }

  settle(): void {
    for (let next = this.answers.shift(); next !== undefined; next = this.answers.shift())
      if (next?.op === "program" || next?.op === "saved" || next?.op === "conflict" || next?.op === "unsaved")
        this.sync.heard(next)
  }

  enters(isNew = false): void {
    this.online = true
    this.answered = true
    this.sync.entered(this.service.entries(), isNew)
    this.settle()
  }

  disconnects(): void {
    this.online = false
    this.answers = []
    this.sync.lost()
  }

  texts(): string[] {
    return this.programStore
      .programs()
      .map(({id}) => this.programStore.read(id) ?? "")
      .sort()
  }
}

describe("a program in the class", () => {
  test("is stored, and the same text is not stored twice", () => {
    const service = new Service()
    const browser = new Browser(service, "a")
    browser.enters()
    browser.write("one")
    browser.save()
    browser.save()
    expect(service.texts()).toEqual(["one"])
    expect(browser.memberships.read()?.programs["p"]?.version).toBe(1)
    expect(browser.sync.state()).toBe("saved")
  })

  test("opens on a new device, the one that was changed last", () => {
    const service = new Service()
    const first = new Browser(service, "a")
    first.enters()
    first.write("one")
    first.save()
    const second = new Browser(service, "b")
    second.enters(true)
    expect(second.shown).toEqual(["one"])
    expect(second.texts()).toEqual(["one"])
  })

  test("that was changed without a connection is stored when it is back", () => {
    const service = new Service()
    const browser = new Browser(service, "a")
    browser.enters()
    browser.write("one")
    browser.save()
    browser.disconnects()
    browser.write("two")
    browser.save()
    expect(browser.sync.state()).toBe("saving")
    browser.enters()
    expect(service.texts()).toEqual(["two"])
    expect(browser.sync.state()).toBe("saved")
  })

  test.each(["database", "disk"] as const)(
    "that meets a fault of the %s is sent until it is stored",
    fault => {
      const service = new Service()
      const browser = new Browser(service, "a")
      browser.enters()
      service.fault = fault
      browser.write("one")
      browser.save()
      expect(browser.sync.state()).toBe(fault)
      for (let i = 0; i < 30; i++) {
        browser.sync.retry()
        browser.settle()
      }
      // It is not shown as saved, and all requests are one.
      expect(browser.sync.state()).toBe(fault)
      expect(service.marks.length).toBe(31)
      expect(new Set(service.marks).size).toBe(1)
      service.fault = null
      browser.write("two")
      browser.sync.retry()
      browser.settle()
      expect(browser.sync.state()).toBe("saved")
      expect(service.texts()).toEqual(["two"])
      browser.sync.retry()
      expect(service.marks.length).toBe(32)
    },
  )

  test("that finds the pupil's share of the disk full is sent again when it has changed", () => {
    const service = new Service()
    const browser = new Browser(service, "a")
    browser.enters()
    service.fault = "full"
    browser.write("one")
    browser.save()
    browser.sync.retry()
    expect(service.marks.length).toBe(1)
    expect(browser.sync.state()).toBe("full")
    service.fault = null
    browser.write("two")
    browser.save()
    expect(browser.sync.state()).toBe("saved")
  })

  test("whose answer was lost is no conflict with itself", () => {
    const service = new Service()
    const browser = new Browser(service, "a")
    browser.enters()
    browser.answered = false
    browser.write("one")
    browser.save()
    browser.disconnects()
    browser.write("two")
    browser.enters()
    expect(service.texts()).toEqual(["two"])
    expect(browser.texts()).toEqual(["two"])
  })

  test("that another device changed replaces an unchanged copy", () => {
    const service = new Service()
    const first = new Browser(service, "a")
    first.enters()
    first.write("one")
    first.save()
    const second = new Browser(service, "b")
    second.enters(true)
    second.write("two")
    second.save()
    first.disconnects()
    first.enters()
    expect(first.texts()).toEqual(["two"])
    expect(first.shown).toEqual(["two"])
  })

  test("that two devices changed becomes two programs on both, whichever comes first", () => {
    const service = new Service()
    const first = new Browser(service, "a")
    first.enters()
    first.write("one")
    first.save()
    const second = new Browser(service, "b")
    second.enters(true)
    first.disconnects()
    first.write("of the first")
    second.write("of the second")
    second.save()
    first.enters()
    expect(service.texts()).toEqual(["of the first", "of the second"])
    expect(first.texts()).toEqual(["of the first", "of the second"])
    // The page still shows what was written on it.
    expect(first.programStore.read(first.open ?? "")).toBe("of the first")
    second.disconnects()
    second.enters()
    expect(second.texts()).toEqual(["of the first", "of the second"])
  })

  test("that is not open and was changed on two devices becomes two programs as well", () => {
    const service = new Service()
    const first = new Browser(service, "a")
    first.enters()
    first.write("one")
    first.save()
    const second = new Browser(service, "b")
    second.enters(true)
    second.write("of the second")
    second.save()
    first.disconnects()
    first.write("of the first")
    first.open = null
    first.enters()
    expect(service.texts()).toEqual(["of the first", "of the second"])
    expect(first.texts()).toEqual(["of the first", "of the second"])
  })

  test("that was deleted here does not come back", () => {
    const service = new Service()
    const browser = new Browser(service, "a")
    browser.enters()
    browser.write("one")
    browser.save()
    browser.open = null
    browser.programStore.remove("p", 3)
    browser.disconnects()
    browser.enters()
    expect(browser.texts()).toEqual([])
  })

  test("keeps every text through random changes, losses and returns of two devices", () => {
    for (let seed = 1; seed <= 40; seed++) {
      let state = seed
      const chance = (n: number) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0
        return Math.floor((state / 2 ** 32) * n)
      }
      const service = new Service()
      const browsers = [new Browser(service, "a"), new Browser(service, "b")]
      for (const browser of browsers) browser.enters(true)
      let written = 0
      for (let step = 0; step < 30; step++) {
        const browser = browsers[chance(2)] as Browser
        const act = chance(5)
        if (act === 0) browser.disconnects()
        else if (act === 1) browser.enters()
        else if (act === 2) browser.answered = chance(2) === 0
        else {
          written += 1
          browser.write(`${browser === browsers[0] ? "a" : "b"} ${written}`)
          browser.save()
        }
      }
      for (let round = 0; round < 3; round++)
        for (const browser of browsers) {
          browser.disconnects()
          browser.enters()
        }
      // What a device wrote last was stored: it is the newest version of a program, or another version was made from it.
      for (const browser of browsers) {
        expect(browser.sync.state(), `seed ${seed}`).toBe("saved")
        expect(browser.texts(), `seed ${seed}`).toEqual(service.texts())
        if (browser.written !== "") expect([...service.history], `seed ${seed}`).toContain(browser.written)
      }
    }
  })
})

test("a program is saved when it runs unchanged, not when it is only open", () => {
  const service = new Service()
  const browser = new Browser(service, "a")
  browser.enters()
  browser.page = "example"
  browser.save()
  expect(service.texts()).toEqual([])
  browser.sync.save("run")
  browser.settle()
  expect(service.texts()).toEqual(["example"])
  expect(browser.sync.state()).toBe("saved")
  // The next run is of the same program.
  browser.sync.save("run")
  browser.settle()
  expect(service.texts()).toEqual(["example"])
})

test("a browser keeps its membership of each class, and each class gets its own programs only", () => {
  const services = {"7a": new Service(), "7c": new Service()}
  const browser = new Browser(services["7a"], "a")
  browser.programStore.hide(browser.memberships.isForeign)
  const meets = (id: "7a" | "7c") => {
    browser.disconnects()
    browser.sync.left()
    browser.memberships.setClass(id)
    browser.service = services[id]
    browser.open = null
    if (browser.memberships.read() === null)
      browser.memberships.write({token: id, nickname: "Ada", programs: {}})
    browser.enters(true)
  }
  meets("7a")
  browser.write("of 7a")
  browser.save()
  // Written when the class has ended: it belongs to that class all the same.
  browser.disconnects()
  browser.open = "late"
  browser.write("late in 7a")
  meets("7c")
  expect(browser.programStore.programs()).toEqual([])
  browser.open = "other"
  browser.write("of 7c")
  browser.save()
  expect(services["7c"].texts()).toEqual(["of 7c"])
  meets("7a")
  expect(browser.memberships.read()?.token).toBe("7a")
  expect(browser.texts()).toEqual(["late in 7a", "of 7a"])
  expect(services["7a"].texts()).toEqual(["late in 7a", "of 7a"])
  meets("7c")
  expect(browser.memberships.read()?.token).toBe("7c")
  expect(browser.texts()).toEqual(["of 7c"])
  // The page opens the pupil's newest program of the class, which is in this browser already.
  expect([browser.open, browser.page]).toEqual(["other", "of 7c"])
})

test("an example that is handed in without a change is among the pupil's programs; one that is only open is not", () => {
  const service = new Service()
  const tablet = new Browser(service, "tablet")
  tablet.enters()
  tablet.page = "main = simulate (Velocity 1 0)"
  tablet.save()
  expect(service.texts()).toEqual([])
  tablet.sync.saveOpened("change")
  tablet.settle()
  expect(service.texts()).toEqual(["main = simulate (Velocity 1 0)"])
  expect(tablet.sync.state()).toBe("saved")
})
