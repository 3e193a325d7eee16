/// Questions about runs of the examples and their answers, from `sim-service/tests/system/questions.md`; and the page's connection under the
/// control of a story that repeats exactly these runs: with their seed, their hands, and to the step at which they end.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import {expect, type Page} from "@playwright/test"
import {root} from "./service.ts"

export interface AskedQuestion {
  readonly text: string
  /// Its sentences, with functions in `**` and code in backquotes.
  readonly answer: readonly string[]
}

/// A run of an example, with questions about it.
export interface QuestionedRun {
  readonly title: string
  readonly example: string
  readonly seconds: number
  readonly hands: readonly Hand[]
  readonly questions: readonly AskedQuestion[]
}

/// What a hand does to the robot at a time, s; fields of `input` in protocol §4.
interface Hand {
  readonly at: number
  readonly does: object
}

export function questionedRuns(): readonly QuestionedRun[] {
  const table = readFileSync(join(root, "sim-service/tests/system/questions.md"), "utf8")
  return table
    .split(/^## /m)
    .slice(1)
    .map(section => {
      const [title = "", ...lines] = section.trim().split("\n")
      const found = /^(\w+), ([\d.]+) s(?:, hands: (.*))?$/.exec(title)
      if (found === null) throw new Error(`expected the title of a run, found: ${title}`)
      const [, example = "", seconds = "", hands] = found
      const questions: {text: string; answer: string[]}[] = []
      for (const line of lines)
        if (line.startsWith("- ")) questions.at(-1)?.answer.push(line.slice(2))
        else if (line !== "") questions.push({text: line, answer: []})
      return {
        title,
        example,
        seconds: Number(seconds),
        hands: hands?.split(", ").map(handOf) ?? [],
        questions,
      }
    })
}

/// Names that an example defines: at the first column, and within a definition.
export interface DefinedNames {
  readonly global: ReadonlySet<string>
  readonly local: ReadonlySet<string>
}

export function definedIn(example: string): DefinedNames {
  const program = readFileSync(join(root, "examples", example, "Main.hs"), "utf8")
  const names = (form: RegExp) => new Set([...program.matchAll(form)].map(found => found[1] ?? ""))
  return {global: names(/^(\w+) ::/gm), local: names(/^ +(\w+)[^|=\n]* = /gm)}
}

function handOf(text: string): Hand {
  const [, at = "", what = ""] = /^([\d.]+) s (.*)$/.exec(text) ?? []
  const [verb, ...numbers] = what.split(" ").filter(word => word !== "at")
  const [first = 0, second = 0] = numbers.map(Number)
  switch (verb) {
    case "press":
    case "release":
      return {at: Number(at), does: {[verb]: `Button${first}`}}
    case "lift":
    case "lower":
      return {at: Number(at), does: {[verb]: "both"}}
    case "put":
      return {at: Number(at), does: {teleport: {x: first, y: second, theta: 0}}}
    default:
      throw new Error(`expected a hand, found: ${text}`)
  }
}

/// Steps of a run in a second.
const stepsPerSecond = 50

/// Single steps that are requested ahead; the service keeps at most 1,000.
const stepsAhead = 200

/// Times of a question as the page sends them, s.
export type QuestionTimes =
  | {readonly time: number}
  | {readonly since: number; readonly until: number}
  | Record<string, never>

/// Something that a hand does after a step, or with nothing to do: the page gets a frame of that step.
interface Stop {
  readonly step: number
  readonly input?: object
}

/// What is changed on the page's connection, in the page: passed on through the test process, thousands of frames take more processor time
/// than all that the page does with them.
interface RunControl {
  /// The next run stops at each of these steps; the last one is its end. `null` before a story asked for one.
  stops: Stop[] | null
  /// The number of the run; `null` before it was pressed.
  run: number | null
  step: number
  isDone: boolean
  /// Whether the program ended by itself, before the time of the run.
  hasEnded: boolean
  times: QuestionTimes
  /// Farthest that a time which the page sent was from the one that was wanted, s.
  offset: number
}

type ControlledWindow = Window & {rosyControl?: RunControl}

/// In the page: takes over its connection to the service.
function controlConnection(stepsAhead: number): void {
  const control: RunControl = {
    stops: null,
    run: null,
    step: 0,
    isDone: false,
    hasEnded: false,
    times: {},
    offset: 0,
  }
  ;(window as ControlledWindow).rosyControl = control
  let requested = 0
  /// Single steps that are requested before are lost; the room is shown before as well.
  let isRunning = false

  const goOn = (send: (message: object) => void): void => {
    const stop = control.stops?.[0]
    if (stop === undefined || control.step < requested) return
    if (control.step >= stop.step) {
      control.stops?.shift()
      if (stop.input !== undefined) send({op: "input", ...stop.input})
      if (control.stops?.length === 0) control.isDone = true
      goOn(send)
      return
    }
    const upTo = Math.min(stop.step, control.step + stepsAhead)
    for (let step = control.step; step < upTo; step++) send({op: "forward"})
    requested = upTo
  }

  const fromPage = (text: string): string => {
    const message = JSON.parse(text)
    if (message.op === "why" || message.op === "whyNot") {
      const last = "until" in control.times ? "until" : "time"
      const wanted = (control.times as Record<string, number>)[last]
      if (wanted !== undefined && message[last] !== undefined)
        control.offset = Math.max(control.offset, Math.abs(message[last] - wanted))
      return JSON.stringify({...message, ...control.times})
    }
    if (message.op !== "run" || control.stops === null) return text
    control.run = message.run
    control.step = 0
    requested = 0
    isRunning = false
    // A message that stops the clock could come after the first step.
    return JSON.stringify({...message, seed: 1, paused: true})
  }

  const fromService = (text: string, send: (message: object) => void): void => {
    const message = JSON.parse(text)
    if (control.run === null || message.run !== control.run || control.isDone) return
    if (message.op === "state" && message.state === "ended") {
      control.hasEnded = true
      control.isDone = true
    } else if (message.op === "state" && message.state === "running") {
      isRunning = true
      goOn(send)
    } else if (message.op === "frame" && isRunning) {
      control.step = message.step
      goOn(send)
    }
  }

  window.WebSocket = class extends WebSocket {
    constructor(address: string | URL, protocols?: string | string[]) {
      super(address, protocols)
      if (!String(address).includes("/api/session")) return
      const send = this.send.bind(this)
      this.send = text => send(fromPage(String(text)))
      this.addEventListener("message", ({data}) =>
        fromService(String(data), message => send(JSON.stringify(message))),
      )
    }
  }
}

export class ControlledRuns {
  readonly #page: Page

  private constructor(page: Page) {
    this.#page = page
  }

  /// Before the page is opened.
  static async of(page: Page): Promise<ControlledRuns> {
    await page.addInitScript(controlConnection, stepsAhead)
    return new ControlledRuns(page)
  }

  /// The next run is this one. The page gets a frame of each of these moments (s): between two of them the service leaves out frames that the
  /// page has not read before the next.
  repeats(run: QuestionedRun, moments: readonly number[]): Promise<void> {
    const stepAt = (seconds: number) => Math.round(seconds * stepsPerSecond)
    const last = stepAt(run.seconds)
    const hands: Stop[] = run.hands.map(({at, does}) => ({step: stepAt(at), input: does}))
    const asked: Stop[] = moments.map(moment => ({step: stepAt(moment)})).filter(({step}) => step < last)
    const stops = [...[...hands, ...asked].sort((a, b) => a.step - b.step), {step: last}]
    return this.#set({stops, run: null, isDone: false, hasEnded: false})
  }

  /// Waits for the end of the run; answers whether the program ended by itself before. A busy machine makes ten single steps a second, and a run has
  /// up to 1,500: each step is waited for.
  async isOver(): Promise<boolean> {
    for (let now = await this.#now(); !now.isDone; now = await this.#now()) {
      const before = now.step
      await expect
        .poll(
          async () => {
            const {isDone, step} = await this.#now()
            return isDone || step !== before
          },
          {intervals: [200]},
        )
        .toBe(true)
    }
    return (await this.#now()).hasEnded
  }

  /// The next question is about exactly these times. The page sends those of the frame that it shows.
  asksAbout(times: QuestionTimes): Promise<void> {
    return this.#set({times, offset: 0})
  }

  async offset(): Promise<number> {
    return (await this.#now()).offset
  }

  #now(): Promise<RunControl> {
    return this.#page.evaluate(() => (window as ControlledWindow).rosyControl!)
  }

  #set(changes: Partial<RunControl>): Promise<void> {
    return this.#page.evaluate(given => {
      Object.assign((window as ControlledWindow).rosyControl!, given)
    }, changes)
  }
}
