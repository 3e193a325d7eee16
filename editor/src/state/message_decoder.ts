/// Decoder of the service's messages, as `protocol/README.md` §1, §4 and §6 define them; the only one.

import {lessonChecks} from "../lessons/lesson.ts"
import {preview} from "../preview/preview.ts"
import {explanation} from "../why/explanation.ts"
import {worded} from "../words/worker_sentences.ts"
import type {World} from "../worlds/world.ts"
import {readWorld} from "../worlds/world_decoder.ts"
import type {Channels} from "./channels.ts"
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
import {branch, type Firing, firing} from "./firings.ts"
import type {
  Declared,
  Frame,
  Goal,
  MemoryValue,
  Place,
  Problem,
  ProblemFix,
  ServiceMessage,
  Suggestion,
  TypesAtPlaces,
} from "./messages.ts"
import {ownTopics, programParts} from "./program_graph.ts"
import type {RobotName} from "./robots.ts"
import {problemSentences, sentence, untranslated} from "./sentence.ts"

const place = object<Place>(get => ({line: get("line", number), column: get("column", number)}))

const fix = object<ProblemFix>(get => ({
  title: get("title", string),
  sentence: get("sentence", optional(sentence, null)),
  edits: get(
    "edits",
    list(object(at => ({start: at("start", place), end: at("end", place), text: at("text", string)}))),
  ),
}))

export const problem = object<Problem>(get => ({
  severity: get("severity", oneOf("error", "warning", "note")),
  kind: get("kind", string),
  start: get("start", optional(place, null)),
  end: get("end", optional(place, null)),
  function: get("function", optional(string, null)),
  message: get("message", string),
  hint: get("hint", optional(string, "")),
  ghc: get("ghc", optional(string, "")),
  time: get("time", optional(number, null)),
  inputs: get("inputs", optional(list(string), [])),
  sentences: get("sentences", optional(problemSentences, untranslated)),
  fixes: get("fixes", optional(list(fix), [])),
}))

const types = object<TypesAtPlaces>(get => ({
  names: get("names", list(string)),
  at: get("at", list(list(number))),
}))

const fitting = object<Suggestion>(get => ({
  name: get("name", string),
  type: get("type", string),
  takes: get("takes", number),
}))

const triple: Decoder<readonly [number, number, number]> = (v, path) => {
  if (!Array.isArray(v) || v.length !== 3) throw new Mismatch(path, "three numbers")
  return [number(v[0], `${path}[0]`), number(v[1], `${path}[1]`), number(v[2], `${path}[2]`)]
}

/// A world in the format of `protocol/README.md` §6.
const world: Decoder<World> = (value, path) => {
  const read = readWorld(value)
  if (read.kind === "world") return read.world
  const {fault} = read
  throw new Mismatch(
    [path, fault.path].filter(Boolean).join("."),
    fault.why.replace(/^expected /, "").replace(/\.$/, ""),
  )
}

const kept = object<MemoryValue>(get => ({type: get("type", string), value: get("value", string)}))

const pose = object<Pick<Frame, "x" | "y" | "theta">>(get => ({
  x: get("x", number),
  y: get("y", number),
  theta: get("theta", number),
}))

const channelValue: Decoder<number | string> = (v, path) => (typeof v === "string" ? v : number(v, path))

const channels: Decoder<Channels> = (v, path) => {
  if (typeof v !== "object" || v === null || Array.isArray(v)) throw new Mismatch(path, "an object")
  return Object.fromEntries(
    Object.entries(v).map(([name, values]) => [name, list(channelValue)(values, `${path}.${name}`)]),
  )
}

const firings: Decoder<{readonly firings?: readonly Firing[]}> = (v, path) =>
  v === undefined ? {} : {firings: list(firing)(v, path)}

const frame = object<Frame>(get => ({
  run: get("run", number),
  step: get("step", number),
  time: get("time", number),
  ...get("pose", pose),
  channels: get("channels", channels),
  fired: get("fired", optional(list(string), [])),
  sensed: get("sensed", optional(list(string), [])),
  boxes: get("boxes", optional(list(triple), null)),
  ghost: get("ghost", optional(triple, null)),
  memory: get("memory", optional(list(kept), null)),
  ...get("firings", firings),
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
  why: worded(get("sentence", optional(sentence, null)), get("why", string)),
  stopped: get("stopped", boolean),
  maxSpeed: get("max_speed", number),
  maxTurn: get("max_turn", number),
}))

const serviceMessage: Decoder<ServiceMessage> = (value, path) => {
  const op = object(get => get("op", string))(value, path)
  return object<ServiceMessage>(get => {
    switch (op) {
      case "hello":
        return {
          op,
          session: get("session", string),
          ...(get("class", optional(boolean, false)) ? {inClass: true} : {}),
        }
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
          parts: get("graph", optional(programParts, [])),
          topics: get("graph", optional(ownTopics, [])),
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
        if (state === "compiling") return {op, run, state}
        if (state === "running")
          return {op, run, state, branches: get("branches", optional(list(branch), []))}
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
      case "previewed":
        return {op, preview: preview(value, "previewed")}
      case "diverged":
        return {op, run: get("run", number), time: get("time", number)}
      case "uncompared":
        return {op, run: get("run", number), time: get("time", number)}
      case "checks":
        return {op, checks: lessonChecks(value, "checks")}
      case "said":
        return {op, run: get("run", number), time: get("time", number), text: get("text", string)}
      case "sound":
        return {op, run: get("run", number), time: get("time", number), sound: get("sound", number)}
      case "conflict":
        return {
          op,
          run: get("run", number),
          time: get("time", number),
          command: get("command", string),
          winner: get("winner", string),
          loser: get("loser", string),
        }
      case "because":
        return {op, answer: explanation(value, "because")}
      case "robots":
        return {op, locked: get("locked", boolean), robots: get("robots", list(robotName))}
      case "robot":
        return {op, robot: robot(value, "robot")}
      case "safety": {
        const since = get("since", optional(number, null))
        const override = since === null ? null : {run: get("run", number), since}
        return {op, on: get("on", boolean), override}
      }
      case "recorded":
        return {op, run: get("run", number), file: get("file", string)}
      case "replayed":
        return {op, run: get("run", number), program: get("program", string), robot: get("robot", string)}
      case "refusal": {
        const said = get("sentences", optional(problemSentences, untranslated))
        return {
          op,
          message: worded(said.message, get("message", string)),
          hint: worded(said.hint, get("hint", optional(string, ""))),
        }
      }
      default:
        throw new Mismatch("op", `a message this page knows, found ${JSON.stringify(op)}`)
    }
  })(value, path)
}

/// Reads one message of the service.
export function readServiceMessage(text: string): Decoded<ServiceMessage> {
  return decode(serviceMessage, parseJson(text))
}
