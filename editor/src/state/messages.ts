/// Messages between the page and the service, as `protocol/README.md` §1, §4 and §6 define them. Units are SI: metres, radians counter-clockwise, seconds.

import type {LessonChecks} from "../lessons/lesson.ts"
import type {Preview} from "../preview/preview.ts"
import type {Explanation} from "../why/explanation.ts"
import type {WhyRequest} from "../why/why_state.ts"
import type {World, WorldFile} from "../worlds/world.ts"
import type {Channels} from "./channels.ts"
import type {Firing, FiringBranch} from "./firings.ts"
import type {OwnTopic, ProgramPart} from "./program_graph.ts"
import type {OwnedRobot, RobotName} from "./robots.ts"
import type {ProblemSentences, Sentence} from "./sentence.ts"

/// 1-based, counted in characters.
export interface Place {
  readonly line: number
  readonly column: number
}

/// protocol §1. `end` is exclusive; what may be absent there is `null` here.
export interface Problem {
  /// A note is advice about a program that may be meant so.
  readonly severity: "error" | "warning" | "note"
  readonly kind: string
  readonly start: Place | null
  readonly end: Place | null
  readonly function: string | null
  readonly message: string
  readonly hint: string
  readonly ghc: string
  readonly time: number | null
  readonly inputs: readonly string[]
  /// `message` and `hint` with their ids, for other languages.
  readonly sentences: ProblemSentences
  /// Ways to mend it, the likeliest first.
  readonly fixes: readonly ProblemFix[]
}

export interface ProblemFix {
  readonly title: string
  readonly sentence: Sentence | null
  readonly edits: readonly {readonly start: Place; readonly end: Place; readonly text: string}[]
}

/// One picture of the robot: ground truth in room coordinates, and what its channels say.
export interface Frame {
  readonly run: number
  readonly step: number
  readonly time: number
  readonly x: number
  readonly y: number
  readonly theta: number
  /// In a message only those that have changed.
  readonly channels: Channels
  readonly fired: readonly string[]
  /// What the program sensed since the last frame, as Haskell shows it.
  readonly sensed: readonly string[]
  /// Where the movable boxes, then the movable rounds, are, as x, y, theta; `null` while they stand where the world
  /// put them.
  readonly boxes: readonly (readonly [number, number, number])[] | null
  /// Where the robot believes it is, in a world where that differs.
  readonly ghost: readonly [number, number, number] | null
  /// All that the program remembers; `null` in a message when that has not changed.
  readonly memory: readonly MemoryValue[] | null
  /// The firings since the last frame; only while the page observes the run.
  readonly firings?: readonly Firing[]
}

/// A value that the program remembers: its type (`Memory Int`) and the value, as Haskell writes them.
export interface MemoryValue {
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
export interface Suggestion {
  readonly name: string
  readonly type: string
  readonly takes: number
}

/// A run on a real robot, and its recording.
export interface RecordedFile {
  readonly run: number
  readonly file: string
}

export interface Declared {
  readonly name: string
  readonly type: string
}

export type ServiceMessage =
  | {readonly op: "hello"; readonly session: string; readonly inClass?: true}
  | {readonly op: "worker"; readonly state: WorkerState}
  | {readonly op: "world"; readonly world: World}
  | {
      readonly op: "checked"
      readonly id: number
      readonly problems: readonly Problem[]
      readonly declarations: readonly Declared[]
      /// What the program runs; none when it has mistakes.
      readonly parts: readonly ProgramPart[]
      readonly topics: readonly OwnTopic[]
      readonly types: TypesAtPlaces
    }
  | {
      readonly op: "completed"
      readonly id: number
      readonly names: readonly Suggestion[]
      /// The type that is wanted there; `null` when anything would do or nothing is known.
      readonly expected: string | null
    }
  | {readonly op: "state"; readonly run: number; readonly state: "compiling"}
  | {
      readonly op: "state"
      readonly run: number
      readonly state: "running"
      /// Between which the functions of a program that begins to run choose; none when it goes on.
      readonly branches?: readonly FiringBranch[]
    }
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
  | {readonly op: "previewed"; readonly preview: Preview}
  /// A program that repeats the last run gave other commands for the first time.
  | {readonly op: "diverged"; readonly run: number; readonly time: number}
  /// From this time on, it is not known whether such a program gave other commands.
  | {readonly op: "uncompared"; readonly run: number; readonly time: number}
  | {readonly op: "checks"; readonly checks: LessonChecks}
  | {readonly op: "said"; readonly run: number; readonly time: number; readonly text: string}
  | {readonly op: "sound"; readonly run: number; readonly time: number; readonly sound: number}
  /// `winner` keeps replacing the commands of `loser` on the channel `command`.
  | {
      readonly op: "conflict"
      readonly run: number
      readonly time: number
      readonly command: string
      readonly winner: string
      readonly loser: string
    }
  | {readonly op: "because"; readonly answer: Explanation}
  | {readonly op: "robots"; readonly locked: boolean; readonly robots: readonly RobotName[]}
  | {
      readonly op: "robot"
      readonly robot: Omit<OwnedRobot, "link"> & {readonly link: OwnedRobot["link"] | "gone"}
    }
  | {
      readonly op: "safety"
      readonly on: boolean
      /// The run and its time at which the rules began to override the program; `null` while they do not.
      readonly override: {readonly run: number; readonly since: number} | null
    }
  /// A run on a real robot is in this file, on the computer of the service.
  | ({readonly op: "recorded"} & RecordedFile)
  /// A recording is shown as this run.
  | {readonly op: "replayed"; readonly run: number; readonly program: string; readonly robot: string}
  | {readonly op: "refusal"; readonly message: string; readonly hint: string}

/// How many seconds of the run pass in one of the learner's; `"max"` is as fast as it can.
export type Speed = number | "max"

/// How much of the page its user sees; `visible` is beside the window that has the focus.
export type PageVisibility = "focused" | "visible" | "hidden"

/// Input of the learner to the simulated robot: buttons, lifting, moving.
export type Hand =
  | {readonly press: string}
  | {readonly release: string}
  | {readonly lift: "left" | "right" | "both"}
  | {readonly lower: "left" | "right" | "both"}
  | {readonly teleport: {readonly x: number; readonly y: number; readonly theta: number}}
  /// A message on a topic that the program takes itself.
  | {readonly publish: {readonly topic: string; readonly msg: object}}
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
  | {
      readonly op: "lesson"
      readonly step: {readonly seconds: number; readonly checks: readonly unknown[]} | null
    }
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
      /// Repeat so many steps of the run `of`, and go on from there.
      readonly after?: number
      /// In the simulator: the clock is stopped before the first step.
      readonly paused?: boolean
      readonly of?: number
      /// Beside a real robot, the number of the same run in the simulator.
      readonly twin?: number
    }
  /// Show the recording of the run `of`, or, without it, of the file that was sent last. `room`: from the start of the drawn room.
  | {readonly op: "replay"; readonly run: number; readonly of?: number; readonly room: boolean}
  | {readonly op: "prepare-previews"}
  | {readonly op: "preview"; readonly id: number; readonly source: string; readonly seconds: number}
  | {readonly op: "stop"}
  | {readonly op: "reset"}
  | {readonly op: "speed"; readonly speed: Speed}
  | {readonly op: "pause"}
  | {readonly op: "resume"}
  | {readonly op: "forward"}
  | {readonly op: "observe"; readonly on: boolean; readonly frames?: boolean}
  | {readonly op: "visibility"; readonly state: PageVisibility}
  | WhyRequest
  | ({readonly op: "input"} & Hand)
  | {readonly op: "unlock"; readonly code: string}
  | {readonly op: "take"; readonly robot: string; readonly who: string; readonly run: number}
  | {readonly op: "leave"}
  | {readonly op: "estop"}
  | {readonly op: "free"}
  | {readonly op: "safety"; readonly on: boolean}
  | {readonly op: "alive"}
