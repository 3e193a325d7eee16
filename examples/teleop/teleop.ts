/// Drives a Kobuki by hand through rosbridge: the simulated one of an open room, or a real one.
///
/// Velocity is published ten times a second while something is held: a robot that hears nothing for 0.6 s stops
/// by itself (kobuki_node, `cmd_vel_timeout`).

import {Ros, Topic} from "roslib"

interface Twist {
  linear: {x: number; y: number; z: number}
  angular: {x: number; y: number; z: number}
}
interface Odometry {
  pose: {pose: {position: {x: number; y: number}}}
  twist: {twist: {linear: {x: number}}}
}

/// Milliseconds between two velocities.
const beat = 100
/// How fast the robot turns, rad/s.
const turning = 1
/// Events on the page; the oldest go.
const maxEvents = 8

const events: Record<string, {type: string; tell: (msg: Record<string, number>) => string}> = {
  "/mobile_base/events/bumper": {
    type: "kobuki_msgs/BumperEvent",
    tell: m => `${["left", "centre", "right"][m.bumper ?? 0]} bumper ${m.state ? "pressed" : "released"}`,
  },
  "/mobile_base/events/cliff": {
    type: "kobuki_msgs/CliffEvent",
    tell: m => `${["left", "centre", "right"][m.sensor ?? 0]} cliff sensor: ${m.state ? "hole" : "floor"}`,
  },
  "/mobile_base/events/button": {
    type: "kobuki_msgs/ButtonEvent",
    tell: m => `button ${m.button} ${m.state ? "pressed" : "released"}`,
  },
  "/mobile_base/events/wheel_drop": {
    type: "kobuki_msgs/WheelDropEvent",
    tell: m => `${m.wheel ? "right" : "left"} wheel ${m.state ? "in the air" : "on the ground"}`,
  },
}

function at(id: string): HTMLElement {
  const found = document.getElementById(id)
  if (found === null) throw new Error(`expected #${id} in index.html, found nothing`)
  return found
}

/// Where the robot is: any rosbridge server, or a room of the Rosy that serves this page.
function address(): string | null {
  const asked = new URLSearchParams(location.search)
  const session = asked.get("session")
  if (session === null) return asked.get("robot")
  return `${location.protocol === "https:" ? "wss:" : "ws:"}//${location.host}/rosbridge/${encodeURIComponent(session)}`
}

function drive(robot: string): void {
  const ros = new Ros()
  ros.on("connection", () => {
    at("state").textContent = "The robot listens."
    ros.getTopics(found => {
      at("topics").replaceChildren(
        ...found.topics.map((topic, i) => {
          const item = document.createElement("li")
          item.textContent = `${topic} · ${found.types[i] ?? ""}`
          return item
        }),
      )
    })
  })
  ros.on("close", () => {
    at("state").textContent = "The robot is gone. Is its room still open?"
  })
  ros.on("error", () => {
    at("state").textContent = "The robot does not answer. Open this page from Rosy's menu again."
  })
  ros.connect(robot).catch(() => undefined)
  at("address").textContent = robot

  new Topic<Odometry>({ros, name: "/odom", messageType: "nav_msgs/Odometry", throttle_rate: beat}).subscribe(
    odometry => {
      const {x, y} = odometry.pose.pose.position
      at("x").textContent = `${x.toFixed(2)} m`
      at("y").textContent = `${y.toFixed(2)} m`
      at("v").textContent = `${odometry.twist.twist.linear.x.toFixed(2)} m/s`
    },
  )
  for (const [name, {type, tell}] of Object.entries(events))
    new Topic<Record<string, number>>({ros, name, messageType: type}).subscribe(msg => {
      const item = document.createElement("li")
      item.textContent = tell(msg)
      at("events").prepend(item)
      while (at("events").childElementCount > maxEvents) at("events").lastElementChild?.remove()
    })

  const velocity = new Topic<Twist>({
    ros,
    name: "/mobile_base/commands/velocity",
    messageType: "geometry_msgs/Twist",
  })
  holdToDrive((forwards, left) => {
    if (!ros.isConnected) return
    velocity.publish({
      linear: {x: forwards * Number((at("speed") as HTMLInputElement).value), y: 0, z: 0},
      angular: {x: 0, y: 0, z: left * turning},
    })
  })
}

/// Tells the direction while something is held, and once that nothing is.
function holdToDrive(tell: (forwards: number, left: number) => void): void {
  const keys: Record<string, string> = {
    ArrowUp: "1 0",
    ArrowDown: "-1 0",
    ArrowLeft: "0 1",
    ArrowRight: "0 -1",
    " ": "0 0",
  }
  const buttons = [...document.querySelectorAll<HTMLButtonElement>("[data-drive]")]
  const held = new Set<string>()
  let timer: ReturnType<typeof setInterval> | undefined

  const say = () => {
    const wanted = [...held].map(direction => direction.split(" ").map(Number))
    const sum = (axis: number) => wanted.reduce((n, direction) => n + (direction[axis] ?? 0), 0)
    tell(sum(0), sum(1))
  }
  const change = (direction: string, down: boolean) => {
    if (direction === "0 0") held.clear()
    else if (down) held.add(direction)
    else held.delete(direction)
    for (const b of buttons) b.classList.toggle("held", held.has(b.dataset.drive ?? ""))
    clearInterval(timer)
    if (held.size > 0) timer = setInterval(say, beat)
    say()
  }
  const free = () => change("0 0", false)

  for (const button of buttons) {
    const direction = button.dataset.drive ?? "0 0"
    button.addEventListener("pointerdown", event => {
      button.setPointerCapture(event.pointerId)
      change(direction, true)
    })
    button.addEventListener("pointerup", () => change(direction, false))
    button.addEventListener("pointercancel", () => change(direction, false))
    button.addEventListener("contextmenu", event => event.preventDefault())
  }
  const onKey = (down: boolean) => (event: KeyboardEvent) => {
    const own = event.target as HTMLElement
    const direction = keys[event.key]
    // A slider uses these keys itself, and a summary the space bar.
    if (direction === undefined || event.repeat || own.matches("input")) return
    if (event.key === " " && own.matches("summary")) return
    // On a button the space bar and Enter hold it.
    event.preventDefault()
    const button = event.key === " " ? own.closest<HTMLButtonElement>("[data-drive]") : null
    change(button?.dataset.drive ?? direction, down)
  }
  window.addEventListener("keydown", onKey(true))
  window.addEventListener("keyup", onKey(false))
  // Who looks elsewhere holds nothing.
  window.addEventListener("blur", free)
  document.addEventListener("visibilitychange", free)
}

const robot = address()
if (robot === null)
  at("state").textContent = "Open this page from Rosy's menu: there it learns which robot to drive."
else drive(robot)

const speed = at("speed") as HTMLInputElement
const showSpeed = () => {
  at("shown").textContent = `${speed.value} m/s`
}
speed.addEventListener("input", showSpeed)
// Whoever set it with the pointer wants the arrow keys to drive again.
speed.addEventListener("pointerup", () => speed.blur())
showSpeed()
