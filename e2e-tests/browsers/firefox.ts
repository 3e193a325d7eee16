/// Firefox as Debian packages it, driven over WebDriver BiDi (https://www.w3.org/TR/webdriver-bidi/) without geckodriver.

import {type ChildProcess, spawn} from "node:child_process"
import {once} from "node:events"
import {mkdtemp, rm} from "node:fs/promises"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {createInterface} from "node:readline"
import WebSocket from "ws"
import {type Browser, windowSize} from "./browser.ts"

interface Answer {
  readonly id?: number
  readonly type: "success" | "error" | "event"
  readonly result?: unknown
  readonly error?: string
  readonly message?: string
}

/// A connection on which each command is answered by its number.
class Connection {
  private readonly socket: WebSocket
  private readonly waiting = new Map<number, {done(result: unknown): void; failed(error: Error): void}>()
  private sent = 0

  private constructor(socket: WebSocket) {
    this.socket = socket
    socket.on("message", data => this.answered(JSON.parse(String(data))))
    socket.on("close", () => {
      for (const {failed} of this.waiting.values()) failed(new Error("Firefox closed the connection"))
    })
  }

  static async to(address: string): Promise<Connection> {
    const socket = new WebSocket(address)
    await once(socket, "open")
    return new Connection(socket)
  }

  send<R>(method: string, params: object): Promise<R> {
    const id = ++this.sent
    return new Promise<R>((done, failed) => {
      this.waiting.set(id, {done: result => done(result as R), failed})
      this.socket.send(JSON.stringify({id, method, params}))
    })
  }

  close(): void {
    this.socket.close()
  }

  private answered({id, type, result, error, message}: Answer): void {
    const one = id === undefined ? undefined : this.waiting.get(id)
    if (id === undefined || one === undefined) return
    this.waiting.delete(id)
    if (type === "success") one.done(result)
    else one.failed(new Error(`${error}: ${message}`))
  }
}

type CallResult =
  | {readonly type: "success"; readonly result: {readonly value?: string}}
  | {readonly type: "exception"; readonly exceptionDetails: {readonly text: string}}

export async function startFirefox(program: string): Promise<Browser> {
  const profile = await mkdtemp(join(tmpdir(), "rosy-firefox-"))
  const args = [
    "--headless",
    "--no-remote",
    "--profile",
    profile,
    "--remote-debugging-port",
    "0",
    "about:blank",
  ]
  const child = spawn(program, args, {stdio: ["ignore", "ignore", "pipe"]})
  const connection = await Connection.to(`${await listening(child)}/session`)
  await connection.send("session.new", {capabilities: {}})
  // The first tab of a window has the focus in the address bar; a new one has it in its page.
  const {context} = await connection.send<{context: string}>("browsingContext.create", {type: "tab"})
  await connection.send("browsingContext.activate", {context})
  await connection.send("browsingContext.setViewport", {context, viewport: windowSize})
  return {
    async opens(url) {
      await connection.send("browsingContext.navigate", {context, url, wait: "complete"})
    },
    async acts(actions) {
      await connection.send("input.performActions", {context, actions})
    },
    async asks(ask, ...args) {
      const answer = await connection.send<CallResult>("script.callFunction", {
        functionDeclaration: `async text => JSON.stringify(await (${ask})(...JSON.parse(text)))`,
        arguments: [{type: "string", value: JSON.stringify(args)}],
        target: {context},
        awaitPromise: true,
      })
      if (answer.type === "exception") throw new Error(answer.exceptionDetails.text)
      return answer.result.value === undefined ? undefined : JSON.parse(answer.result.value)
    },
    async picture() {
      const {data} = await connection.send<{data: string}>("browsingContext.captureScreenshot", {context})
      return Buffer.from(data, "base64")
    },
    async closes() {
      await connection.send("browser.close", {})
      connection.close()
      if (child.exitCode === null) await once(child, "exit")
      await rm(profile, {recursive: true, force: true, maxRetries: 5})
    },
  }
}

/// The address that a started Firefox prints.
async function listening(child: ChildProcess): Promise<string> {
  if (child.stderr === null) throw new Error("expected Firefox to have an error output")
  for await (const line of createInterface(child.stderr)) {
    const found = /WebDriver BiDi listening on (ws:\S+)/.exec(line)
    if (found?.[1] !== undefined) {
      child.stderr.resume()
      return found[1]
    }
  }
  throw new Error("Firefox ended without listening")
}
