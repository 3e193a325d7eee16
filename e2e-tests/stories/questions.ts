/// Questions about runs of the examples and their answers, from `sim-service/tests/system/questions.md`; and the page's connection under the
/// control of a story that repeats exactly these runs: with their seed, their hands, and to the step at which they end.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import {expect, type Page, type WebSocketRoute} from "@playwright/test"
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

export class ControlledRuns {
  #server: WebSocketRoute | null = null
  #run: QuestionedRun | null = null
  /// The number of the run; `null` before it was pressed.
  #number: number | null = null
  #step = 0
  /// Steps at which something is to be done, and what.
  #stops: {readonly step: number; readonly act: () => void}[] = []
  #requested = 0
  /// Single steps that are requested before are lost; the room is shown before as well.
  #isRunning = false
  #isDone = false
  #hasEnded = false
  #times: QuestionTimes = {}
  /// Farthest that a time which the page sent was from the one that was wanted, s.
  #offset = 0

  static async of(page: Page): Promise<ControlledRuns> {
    const runs = new ControlledRuns()
    await page.routeWebSocket(/\/api\/session/, socket => {
      const server = socket.connectToServer()
      runs.#server = server
      socket.onMessage(text => server.send(runs.#fromPage(String(text))))
      server.onMessage(text => {
        socket.send(text)
        runs.#fromService(String(text))
      })
    })
    return runs
  }

  /// The next run is this one. The page gets a frame of each of these moments (s): between two of them the service leaves out frames that the
  /// page has not read before the next.
  repeats(run: QuestionedRun, moments: readonly number[]): void {
    const hands = run.hands.map(({at, does}) => ({
      step: Math.round(at * stepsPerSecond),
      act: () => this.#send({op: "input", ...does}),
    }))
    this.#run = run
    this.#number = null
    this.#isDone = false
    this.#hasEnded = false
    const last = Math.round(run.seconds * stepsPerSecond)
    const asked = moments
      .map(moment => ({step: Math.round(moment * stepsPerSecond), act: () => {}}))
      .filter(({step}) => step < last)
    const end = {
      step: last,
      act: () => {
        this.#isDone = true
      },
    }
    this.#stops = [...[...hands, ...asked].sort((a, b) => a.step - b.step), end]
  }

  /// Whether the program ended by itself, before the time of the run.
  get hasEnded(): boolean {
    return this.#hasEnded
  }

  /// A busy machine makes ten single steps a second, and a run has up to 1,500: each step is waited for.
  async isOver(): Promise<void> {
    while (!this.#isDone) {
      const before = this.#step
      await expect.poll(() => this.#isDone || this.#step !== before).toBe(true)
    }
  }

  /// The next question is about exactly these times. The page sends those of the frame that it shows.
  asksAbout(times: QuestionTimes): void {
    this.#times = times
    this.#offset = 0
  }

  get offset(): number {
    return this.#offset
  }

  #send(message: object): void {
    this.#server?.send(JSON.stringify(message))
  }

  #fromPage(text: string): string {
    const message = JSON.parse(text)
    if (message.op === "why" || message.op === "whyNot") {
      const last = "until" in this.#times ? "until" : "time"
      const wanted = (this.#times as Record<string, number>)[last]
      if (wanted !== undefined && message[last] !== undefined)
        this.#offset = Math.max(this.#offset, Math.abs(message[last] - wanted))
      return JSON.stringify({...message, ...this.#times})
    }
    if (message.op !== "run" || this.#run === null) return text
    this.#number = message.run
    this.#step = 0
    this.#requested = 0
    this.#isRunning = false
    // A message that stops the clock could come after the first step.
    return JSON.stringify({...message, seed: 1, paused: true})
  }

  #fromService(text: string): void {
    const message = JSON.parse(text)
    if (this.#number === null || message.run !== this.#number || this.#isDone) return
    if (message.op === "state" && message.state === "ended") {
      this.#hasEnded = true
      this.#isDone = true
    } else if (message.op === "state" && message.state === "running") {
      this.#isRunning = true
      this.#goOn()
    } else if (message.op === "frame" && this.#isRunning) {
      this.#step = message.step
      this.#goOn()
    }
  }

  #goOn(): void {
    const stop = this.#stops[0]
    if (stop === undefined || this.#step < this.#requested) return
    if (this.#step >= stop.step) {
      this.#stops.shift()
      stop.act()
      this.#goOn()
      return
    }
    const upTo = Math.min(stop.step, this.#step + stepsAhead)
    for (let step = this.#step; step < upTo; step++) this.#send({op: "forward"})
    this.#requested = upTo
  }
}
