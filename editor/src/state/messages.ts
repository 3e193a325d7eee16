/// The messages between the page and the service, as `protocol/README.md` §1, §4 and §6 define them, and the
/// one parser that lets them in. Units are SI: metres, radians counter-clockwise, seconds.

import {readWorld} from "../worlds/read.ts"
import type {World, WorldFile} from "../worlds/world.ts"
import {
  boolean,
  type Decoded,
  type Decoder,
  decode,
  list,
  Mismatch,
  number,
  object,
  oneOf,
  optional,
  parseJson,
  string,
} from "./decode.ts"
import type {Held, RobotName} from "./robots.ts"

/// 1-based, counted in characters.
export interface Place {
  readonly line: number
  readonly column: number
}

/// protocol §1. `end` is exclusive; what may be absent there is `null` here.
export interface Problem {
  readonly severity: "error" | "warning"
  readonly kind: string
  readonly start: Place | null
  readonly end: Place | null
  readonly function: string | null
  readonly message: string
  readonly hint: string
  readonly ghc: string
  readonly time: number | null
  readonly inputs: readonly string[]
  /// Ways to mend it, the likeliest first.
  readonly fixes: readonly ProblemFix[]
}

export interface ProblemFix {
  readonly title: string
  readonly edits: readonly {readonly start: Place; readonly end: Place; readonly text: string}[]
}

/// One picture of the robot: ground truth in room coordinates. Bits as in kobuki_msgs/SensorState: right 1,
/// centre 2, left 4; wheels right 1, left 2; button n is bit n. LEDs: 0 black, 1 green, 2 orange, 3 red.
export interface Frame {
  readonly run: number
  readonly step: number
  readonly time: number
  readonly x: number
  readonly y: number
  readonly theta: number
  readonly v: number
  readonly w: number
  readonly bumpers: number
  readonly cliffs: number
  readonly wheels: number
  readonly buttons: number
  readonly led1: number
  readonly led2: number
  readonly fired: readonly string[]
  /// Where the movable boxes, then the movable rounds, are, as x, y, theta; `null` while they stand where the world
  /// put them.
  readonly boxes: readonly (readonly [number, number, number])[] | null
  /// Where the robot believes it is, in a world where that differs.
  readonly ghost: readonly [number, number, number] | null
  /// All that the program remembers; `null` in a message when that has not changed.
  readonly memory: readonly Kept[] | null
}

/// A value that the program remembers: its type (`Memory Int`) and the value, as Haskell writes them.
export interface Kept {
  readonly type: string
  readonly value: string
}

/// What is to be done in a world, and how far it is.
export interface Goal {
  readonly kind: string
  readonly title: string
  readonly state: "open" | "done" | "missed"
  /// 0 to 1.
  readonly progress: number
  /// When it was done or missed, in seconds of the run.
  readonly time: number | null
}

export type WorkerState = "starting" | "ready" | "restarting"
export type Ended = "done" | "error" | "stuck" | "stopped" | "time" | "refused"
/// protocol §3: the piece of text from line and column up to line and column has the type `names[n]`; an outer piece comes
/// before those inside it.
export interface TypesAtPlaces {
  readonly names: readonly string[]
  readonly at: readonly (readonly number[])[]
}

/// A name that can stand at a place, with its type and how many values must follow it to give what is wanted there.
export interface Fitting {
  readonly name: string
  readonly type: string
  readonly takes: number
}

export interface Declared {
  readonly name: string
  readonly type: string
}

export type ServiceMessage =
  | {readonly op: "hello"; readonly session: string}
  | {readonly op: "worker"; readonly state: WorkerState}
  | {readonly op: "world"; readonly world: World}
  | {
      readonly op: "checked"
      readonly id: number
      readonly problems: readonly Problem[]
      readonly declarations: readonly Declared[]
      readonly types: TypesAtPlaces
    }
  | {
      readonly op: "completed"
      readonly id: number
      readonly names: readonly Fitting[]
      /// The type that is wanted there; `null` when anything would do or nothing is known.
      readonly expected: string | null
    }
  | {readonly op: "state"; readonly run: number; readonly state: "compiling" | "running"}
  | {readonly op: "state"; readonly run: number; readonly state: "queued"; readonly place: number}
  | {
      readonly op: "state"
      readonly run: number
      readonly state: "ended"
      readonly ended: Ended
      readonly problems: readonly Problem[]
    }
  | {readonly op: "frame"; readonly frame: Frame}
  | {readonly op: "goals"; readonly run: number; readonly goals: readonly Goal[]}
  | {readonly op: "said"; readonly run: number; readonly time: number; readonly text: string}
  | {readonly op: "sound"; readonly run: number; readonly time: number; readonly sound: number}
  | {readonly op: "robots"; readonly locked: boolean; readonly robots: readonly RobotName[]}
  | {readonly op: "robot"; readonly robot: Omit<Held, "link"> & {readonly link: Held["link"] | "gone"}}
  | {readonly op: "refusal"; readonly message: string; readonly hint: string}

/// How many seconds of the run pass in one of the learner's; `"max"` is as fast as it can.
export type Speed = number | "max"

/// What the learner's hands do to the robot.
export type Hand =
  | {readonly press: string}
  | {readonly release: string}
  | {readonly lift: "left" | "right" | "both"}
  | {readonly lower: "left" | "right" | "both"}
  | {readonly teleport: {readonly x: number; readonly y: number; readonly theta: number}}
  | {
      readonly move: {
        /// The number of a movable thing, as in `boxes` of a frame.
        readonly thing: number
        readonly x: number
        readonly y: number
        readonly theta: number
      }
    }

export type PageMessage =
  | {readonly op: "world"; readonly world: string | WorldFile}
  | {readonly op: "check"; readonly id: number; readonly source: string}
  | {
      readonly op: "complete"
      readonly id: number
      readonly source: string
      readonly line: number
      readonly column: number
    }
  | {
      readonly op: "run"
      readonly run: number
      readonly source: string
      readonly seed?: number
      readonly speed: Speed
    }
  | {readonly op: "stop"}
  | {readonly op: "reset"}
  | {readonly op: "speed"; readonly speed: Speed}
  | {readonly op: "pause"}
  | {readonly op: "resume"}
  | {readonly op: "forward"}
  | ({readonly op: "input"} & Hand)
  | {readonly op: "unlock"; readonly code: string}
  | {readonly op: "take"; readonly robot: string; readonly who: string; readonly run: number}
  | {readonly op: "leave"}
  | {readonly op: "estop"}
  | {readonly op: "free"}
  | {readonly op: "alive"}

const place = object<Place>(get => ({line: get("line", number), column: get("column", number)}))

const fix = object<ProblemFix>(get => ({
  title: get("title", string),
  edits: get(
    "edits",
    list(object(at => ({start: at("start", place), end: at("end", place), text: at("text", string)}))),
  ),
}))

export const problem = object<Problem>(get => ({
  severity: get("severity", oneOf("error", "warning")),
  kind: get("kind", string),
  start: get("start", optional(place, null)),
  end: get("end", optional(place, null)),
  function: get("function", optional(string, null)),
  message: get("message", string),
  hint: get("hint", optional(string, "")),
  ghc: get("ghc", optional(string, "")),
  time: get("time", optional(number, null)),
  inputs: get("inputs", optional(list(string), [])),
  fixes: get("fixes", optional(list(fix), [])),
}))

const types = object<TypesAtPlaces>(get => ({
  names: get("names", list(string)),
  at: get("at", list(list(number))),
}))

const fitting = object<Fitting>(get => ({
  name: get("name", string),
  type: get("type", string),
  takes: get("takes", number),
}))

const triple: Decoder<readonly [number, number, number]> = (v, path) => {
  if (!Array.isArray(v) || v.length !== 3) throw new Mismatch(path, "three numbers")
  return [number(v[0], `${path}[0]`), number(v[1], `${path}[1]`), number(v[2], `${path}[2]`)]
}

/// A world, and the JSON it came as.
const world: Decoder<World> = (value, path) => {
  const read = readWorld(value)
  if (read.kind === "world") return read.world
  const {fault} = read
  throw new Mismatch(
    [path, fault.path].filter(Boolean).join("."),
    fault.why.replace(/^expected /, "").replace(/\.$/, ""),
  )
}

const kept = object<Kept>(get => ({type: get("type", string), value: get("value", string)}))

const frame = object<Frame>(get => ({
  run: get("run", number),
  step: get("step", number),
  time: get("time", number),
  x: get("x", number),
  y: get("y", number),
  theta: get("theta", number),
  v: get("v", number),
  w: get("w", number),
  bumpers: get("bumpers", number),
  cliffs: get("cliffs", number),
  wheels: get("wheels", number),
  buttons: get("buttons", number),
  led1: get("led1", number),
  led2: get("led2", number),
  fired: get("fired", optional(list(string), [])),
  boxes: get("boxes", optional(list(triple), null)),
  ghost: get("ghost", optional(triple, null)),
  memory: get("memory", optional(list(kept), null)),
}))

const goal = object<Goal>(get => ({
  kind: get("kind", string),
  title: get("title", optional(string, "")),
  state: get("state", oneOf("open", "done", "missed")),
  progress: get("progress", optional(number, 0)),
  time: get("time", optional(number, null)),
}))

const declared = object<Declared>(get => ({name: get("name", string), type: get("type", string)}))

const robotName = object<RobotName>(get => ({
  name: get("name", string),
  holder: get("holder", optional(string, null)),
  yours: get("yours", boolean),
}))

const robot = object(get => ({
  name: get("name", string),
  link: get("link", oneOf("connecting", "connected", "lost", "gone")),
  why: get("why", string),
  safety: get("safety", boolean),
  backing: get("backing", boolean),
  stopped: get("stopped", boolean),
  maxSpeed: get("max_speed", number),
  maxTurn: get("max_turn", number),
}))

const serviceMessage: Decoder<ServiceMessage> = (value, path) => {
  const op = object(get => get("op", string))(value, path)
  return object<ServiceMessage>(get => {
    switch (op) {
      case "hello":
        return {op, session: get("session", string)}
      case "worker":
        return {op, state: get("state", oneOf("starting", "ready", "restarting"))}
      case "world":
        return {op, world: get("world", world)}
      case "checked":
        return {
          op,
          id: get("id", number),
          problems: get("problems", list(problem)),
          declarations: get("declarations", optional(list(declared), [])),
          types: get("types", optional(types, {names: [], at: []})),
        }
      case "completed":
        return {
          op,
          id: get("id", number),
          names: get("names", list(fitting)),
          expected: get("expected", optional(string, null)),
        }
      case "state": {
        const state = get("state", oneOf("queued", "compiling", "running", "ended"))
        const run = get("run", number)
        if (state === "queued") return {op, run, state, place: get("place", number)}
        if (state !== "ended") return {op, run, state}
        return {
          op,
          run,
          state,
          ended: get("ended", oneOf("done", "error", "stuck", "stopped", "time", "refused")),
          problems: get("problems", optional(list(problem), [])),
        }
      }
      case "frame":
        return {op, frame: frame(value, "frame")}
      case "goals":
        return {op, run: get("run", number), goals: get("goals", list(goal))}
      case "said":
        return {op, run: get("run", number), time: get("time", number), text: get("text", string)}
      case "sound":
        return {op, run: get("run", number), time: get("time", number), sound: get("sound", number)}
      case "robots":
        return {op, locked: get("locked", boolean), robots: get("robots", list(robotName))}
      case "robot":
        return {op, robot: robot(value, "robot")}
      case "refusal":
        return {op, message: get("message", string), hint: get("hint", optional(string, ""))}
      default:
        throw new Mismatch("op", `a message this page knows, found ${JSON.stringify(op)}`)
    }
  })(value, path)
}

/// Reads one message of the service.
export function readServiceMessage(text: string): Decoded<ServiceMessage> {
  return decode(serviceMessage, parseJson(text))
}
