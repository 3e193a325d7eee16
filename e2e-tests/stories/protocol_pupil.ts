/// A pupil as a client of the protocol (sections 4 and 11): joins, runs, saves and hands in as a page does, without a browser.

import {once} from "node:events"
import WebSocket from "ws"
import type {RunningClass} from "./running_class.ts"

interface Message {
  readonly op: string
  readonly [field: string]: unknown
}

interface Task {
  readonly id: number
  readonly open: boolean
  readonly handed_in: object | null
}

/// A program that turns on the spot. Slow runs keep thirty robots on the move at little cost.
const program = "main = simulate (Velocity 0 1)\n"
const slowly = 0.1

/// Opens a socket that passes decoded messages on.
async function open(address: string, heard: (message: Message) => void): Promise<WebSocket> {
  const socket = new WebSocket(address)
  socket.on("message", data => heard(JSON.parse(String(data))))
  await once(socket, "open")
  // It is followed by "close".
  socket.on("error", () => {})
  return socket
}

export class ProtocolPupil {
  readonly nickname: string
  /// The newest texts that were reported as saved and that were sent.
  acknowledged = ""
  sent = ""
  /// The newest version as the service read it back.
  stored = ""
  /// The message of "eyes up"; null while there is none.
  attention: string | null = null
  /// The name of the lesson that the teacher sent.
  lesson = ""
  /// The step of the run that was shown last.
  step = 0
  private tasks: readonly Task[] = []
  private token = ""
  private pupil: number | null = null
  private saves = 0
  private version = 0
  private wake: (() => void)[] = []
  private socket: WebSocket | null = null
  private page: WebSocket | null = null

  private constructor(nickname: string) {
    this.nickname = nickname
  }

  static async joins({address, code}: RunningClass, nickname: string): Promise<ProtocolPupil> {
    const pupil = new ProtocolPupil(nickname)
    await pupil.connects(address)
    pupil.send({op: "join", code, nickname, language: "en"})
    await pupil.until(() => pupil.pupil !== null)
    return pupil
  }

  /// A pupil's other device, with the newest version of the program that was changed last.
  static async resumes({address, code}: RunningClass, words: string): Promise<ProtocolPupil> {
    const pupil = new ProtocolPupil("")
    await pupil.connects(address)
    pupil.send({op: "resume", code, words})
    await pupil.until(() => pupil.stored !== "")
    return pupil
  }

  /// The same device again, after the connection was cut.
  async returns({address}: RunningClass): Promise<void> {
    this.stored = ""
    await this.connects(address)
    this.send({op: "enter", token: this.token})
    await this.until(() => this.stored !== "")
  }

  /// Opens a page session, which the board shows, and runs a program in it until it drives.
  async runs({address}: RunningClass): Promise<void> {
    this.page = await open(`${address.replace("http", "ws")}/api/session`, message => {
      if (message.op === "hello") this.send({op: "here", session: message["session"]})
      if (message.op === "frame") this.step = Number(message["step"])
      this.changed()
    })
    this.page.send(JSON.stringify({op: "run", run: 1, source: program, seed: 1, speed: slowly}))
    this.tells(true)
    await this.until(() => this.step > 0)
  }

  stops(): void {
    this.page?.close()
    this.tells(false)
  }

  tells(running: boolean): void {
    const lesson = this.lesson === "" ? null : {name: this.lesson, done: 1, steps: 3}
    this.send({op: "status", errors: false, running, lesson})
  }

  async handsIn(): Promise<void> {
    const open = () => this.tasks.find(task => task.open)
    await this.until(() => open() !== undefined)
    this.send({op: "hand-in", task: open()?.id, name: "walk", text: this.text()})
    await this.until(() => open()?.handed_in !== null)
  }

  /// Saves one version after the other until the connection is cut.
  async savesUntilCut(): Promise<void> {
    while (this.socket?.readyState === WebSocket.OPEN) {
      this.saves += 1
      this.sent = this.text()
      const mark = `m${this.saves}`
      const base = this.version
      this.send({op: "save", program: "p", name: "walk", text: this.sent, reason: "change", base, mark})
      await this.until(() => this.acknowledged === this.sent || this.socket?.readyState !== WebSocket.OPEN)
    }
  }

  get savesReported(): number {
    return this.acknowledged === this.sent ? this.saves : this.saves - 1
  }

  /// Waits until this holds.
  async until(claim: () => boolean): Promise<void> {
    while (!claim()) await new Promise<void>(resolve => this.wake.push(resolve))
  }

  leaves(): void {
    this.page?.close()
    this.socket?.close()
  }

  private text(): string {
    return `${program}-- ${this.nickname}, version ${this.saves}\n`
  }

  private async connects(address: string): Promise<void> {
    this.socket = await open(`${address.replace("http", "ws")}/api/class`, message => {
      this.heard(message)
      this.changed()
    })
    this.socket.on("close", () => this.changed())
  }

  private changed(): void {
    for (const resolve of this.wake.splice(0)) resolve()
  }

  private send(message: Message): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message))
  }

  private heard(message: Message): void {
    switch (message.op) {
      case "entered": {
        this.pupil = Number(message["pupil"])
        this.token = String(message["token"] ?? this.token)
        const [newest] = message["programs"] as readonly {readonly id: string}[]
        if (newest !== undefined) this.send({op: "read", program: newest.id})
        break
      }
      case "program":
        this.stored = String(message["text"])
        break
      case "saved":
        this.version = Number(message["version"])
        this.acknowledged = this.sent
        break
      case "attention":
        this.attention = message["message"] as string | null
        this.page?.send(JSON.stringify({op: this.attention === null ? "resume" : "pause"}))
        break
      case "handout":
        this.lesson = String(message["name"])
        this.tells(false)
        break
      case "tasks":
        this.tasks = message["tasks"] as readonly Task[]
        break
    }
  }
}
