/// A stand-in for the service while the page is being worked on: it speaks protocol/README.md §4 and drives a
/// robot that knows one trick. It does not read programs; words in them choose what happens:
/// `_` refuses the program, `explode` ends the run with a problem, `slow` compiles for three seconds.
///
///   node dev/fake-service.mjs [PORT]      prints its address; 0 takes any free port

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {createServer} from "node:http"
import {join} from "node:path"
import {fileURLToPath} from "node:url"
import {WebSocketServer} from "ws"

const world = {
  name: "corridor",
  size: [4.5, 4.5],
  start: {x: 0.6, y: 0.8, theta: 0.35},
  tile: 0.5,
  tiles: [...Array(6).fill("........."), "...OO....", ".........", "........."],
  walls: [{from: [3.2, 2.4], to: [3.2, 4.5]}],
  boxes: [{x: 1.2, y: 3.4, w: 0.5, h: 0.4, theta: 0.3, movable: true}],
}
const worlds = {corridor: world, empty: {name: "empty", size: [6, 4], start: {x: 1, y: 2, theta: 0}}}

// The project's own examples, from the folder in ROSY_EXAMPLES or beside the editor.
const folder = process.env.ROSY_EXAMPLES ?? fileURLToPath(new URL("../../examples", import.meta.url))
const examples = Object.fromEntries(
  readdirSync(folder, {withFileTypes: true})
    .filter(entry => entry.isDirectory() && existsSync(join(folder, entry.name, "program.rosy")))
    .map(({name}) => {
      const about = readFileSync(join(folder, name, "README.md"), "utf8").split("\n").filter(line => line !== "")
      return [name, [about[0].replace(/^# */, ""), about[1].split(/(?<=\.) /)[0], join(folder, name, "program.rosy")]]
    }),
)

const http = createServer((request, response) => {
  const path = decodeURIComponent(new URL(request.url, "http://x").pathname)
  const answer = body => {
    response.setHeader("content-type", "application/json")
    response.end(JSON.stringify(body))
  }
  if (path === "/api/examples")
    return answer(Object.entries(examples).map(([name, [title, teaches]]) => ({name, title, teaches, level: "start"})))
  if (path === "/api/worlds") return answer(Object.keys(worlds))
  const name = path.replace("/api/examples/", "")
  if (Object.hasOwn(examples, name)) return response.end(readFileSync(examples[name][2]))
  response.statusCode = 404
  response.end()
})

const sockets = new WebSocketServer({server: http, path: "/api/session"})
sockets.on("connection", socket => {
  let room = world
  let timer
  let robot
  let standing = false
  let again
  const send = message => socket.send(JSON.stringify(message))
  const problem = (kind, message, hint, more = {}) => ({severity: "error", kind, message, hint, ghc: "", ...more})
  const end = (run, ended, problems = []) => {
    clearTimeout(timer)
    robot = undefined
    send({op: "state", run, state: "ended", ended, problems})
  }

  const step = (run, source, n) => {
    const {start, size} = room
    robot ??= {...start, v: 0, hit: false}
    const fired = ["accelerate"]
    robot.v = Math.min(0.7, robot.v + 0.01)
    const nx = robot.x + robot.v * 0.02 * Math.cos(robot.theta)
    const ny = robot.y + robot.v * 0.02 * Math.sin(robot.theta)
    const r = 0.176
    const blocked =
      nx < r || ny < r || nx > size[0] - r || ny > size[1] - r || (room.walls?.length && nx > 3.2 - r && nx < 3.3 && ny > 2.4)
    if (!blocked) Object.assign(robot, {x: nx, y: ny})
    if (blocked && !robot.hit) {
      fired.push("play")
      send({op: "sound", run, time: n * 0.02, sound: 4})
      send({op: "said", run, time: n * 0.02, text: "bump!"})
    }
    robot.hit = blocked
    if (blocked) robot.v = 0.05
    robot.theta += blocked ? 0.05 : 0.0035
    const {x, y, theta, v, hit} = robot
    send({op: "frame", run, step: n, time: n * 0.02, pose: {x, y, theta}, channels: {Velocity: [v, 0.2], Bumper: [0, hit ? 1 : 0, 0], Cliff: [0, 0, x < 2 && y < 1 ? 1 : 0], Led1: [hit ? 3 : 2], Led2: [1]}, fired, sensed: []})
    if (source.includes("explode") && n > 40)
      return end(run, "error", [problem("exception", "`play` divided by zero.", "A number that may be 0 stands below the line.", {function: "play", time: n * 0.02, inputs: ["Bumper CenterBumper Pressed"]})])
    again = () => step(run, source, n + 1)
    if (!standing) timer = setTimeout(again, 20)
  }

  socket.on("message", data => {
    const message = JSON.parse(String(data))
    switch (message.op) {
      case "world":
        room = typeof message.world === "string" ? (worlds[message.world] ?? world) : message.world
        robot = undefined
        clearTimeout(timer)
        return send({op: "world", world: room})
      case "check": {
        const line = message.source.split("\n").findIndex(l => / _( |$)/.test(l))
        const problems =
          line < 0 || !message.source.includes("= _") ? [] : [problem("hole", "`accelerate` has an empty socket.", "Put a block into it.", {function: "accelerate", start: {line: line + 1, column: 1}, end: {line: line + 1, column: 4}})]
        return send({op: "checked", id: message.id, problems, declarations: [], graph: {functions: []}})
      }
      case "run": {
        clearTimeout(timer)
        robot = undefined
        send({op: "state", run: message.run, state: "compiling"})
        standing = false
        const begin = () => {
          if (message.source.includes("= _")) return end(message.run, "refused", [problem("hole", "`main` has an empty socket.", "Put a block into it.", {function: "main"})])
          send({op: "state", run: message.run, state: "running"})
          step(message.run, message.source, 0)
        }
        timer = setTimeout(begin, message.source.includes("slow") ? 3000 : 30)
        return
      }
      case "pause":
        standing = true
        return
      case "resume":
        standing = false
        return again()
      case "forward":
        return again()
      case "stop":
      case "reset":
        clearTimeout(timer)
        robot = undefined
        return send({op: "world", world: room})
    }
  })
  socket.on("close", () => clearTimeout(timer))
  send({op: "hello", protocol: 1, session: "s1"})
  send({op: "worker", state: "ready"})
  send({op: "world", world: room})
})

http.listen(Number(process.argv[2] ?? 0), "127.0.0.1", () => console.log(`http://127.0.0.1:${http.address().port}`))
