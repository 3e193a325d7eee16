/// The socket of class mode over a service that answers, is slow, or stands still.

import {afterEach, beforeEach, expect, test, vi} from "vitest"
import {openClassSocket} from "../../src/classroom/messages/class_socket.ts"

/// A WebSocket whose service is the test.
class Scripted {
  static readonly OPEN = 1
  static readonly opened: Scripted[] = []
  readyState = 1
  readonly sent: string[] = []
  onopen: (() => void) | null = null
  onclose: (() => void) | null = null
  onmessage: ((event: {readonly data: string}) => void) | null = null

  constructor() {
    Scripted.opened.push(this)
    queueMicrotask(() => this.onopen?.())
  }

  send(text: string): void {
    this.sent.push(text)
  }

  close(): void {
    this.readyState = 3
  }

  says(message: object): void {
    this.onmessage?.({data: JSON.stringify(message)})
  }
}

vi.mock("../../src/browser/service_address.ts", () => ({
  socketAddress: async () => "ws://127.0.0.1/api/class",
}))

/// Seconds of page time.
const passes = (seconds: number) => vi.advanceTimersByTimeAsync(seconds * 1000)

async function opened() {
  const log: string[] = []
  const socket = openClassSocket<object, unknown>(
    "api/class",
    text => ({kind: "ok", value: JSON.parse(text)}),
    {
      opened: () => log.push("opened"),
      lost: () => log.push("lost"),
      received: message => log.push(JSON.stringify(message)),
    },
  )
  await passes(0)
  const [service] = Scripted.opened
  if (service === undefined) throw new Error("expected a socket, found none")
  return {log, socket, service}
}

beforeEach(() => {
  vi.useFakeTimers()
  vi.stubGlobal("window", {location: {}})
  vi.stubGlobal("WebSocket", Scripted)
  Scripted.opened.splice(0)
})

afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

test("a service that stands still is lost after some seconds, and connected again when it is back", async () => {
  const {log, socket, service} = await opened()
  await passes(2)
  expect(service.sent).toEqual([])
  await passes(18)
  expect(service.sent).toContain('{"op":"ping"}')
  expect(log.slice(0, 2)).toEqual(["opened", "lost"])
  const newest = Scripted.opened.at(-1)
  expect(newest).not.toBe(service)
  newest?.says({op: "class"})
  expect(log.slice(-2)).toEqual(["opened", '{"op":"class"}'])
  expect(socket.send({})).toBe(true)
  // What the first connection still says is about the past.
  service.says({op: "late"})
  expect(log.at(-1)).toBe('{"op":"class"}')
})

test("a service that has nothing to say but answers stays connected, and the page is not told the answers", async () => {
  const {log, service} = await opened()
  for (let look = 0; look < 50; look += 1) {
    await passes(3)
    if (service.sent.splice(0).includes('{"op":"ping"}')) service.says({op: "pong"})
  }
  expect(log).toEqual(["opened"])
  expect(Scripted.opened).toHaveLength(1)
})

test("a page that is told something does not ask", async () => {
  const {service} = await opened()
  for (let second = 0; second < 30; second += 1) {
    service.says({op: "places"})
    await passes(1)
  }
  expect(service.sent).toEqual([])
})
