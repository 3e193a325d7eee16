/// Messages of the service as the page keeps them (`message_decoder.ts` makes them of those that the service sends), and the parts that other modules name.

import type {OwnTopic, ProgramPart} from "../../program/program_graph.ts"
import type {Answer} from "../../wire/page/page.generated.ts"
import type {ChecksShown} from "../../wire/page/programs.generated.ts"
import type {RunRecorded} from "../../wire/page/recordings.generated.ts"
import type {RobotState, Safety} from "../../wire/page/robots.generated.ts"
import type {Input, Run, RunState, Frame as ShownFrame} from "../../wire/page/runs.generated.ts"
import type {Hello, WorkerState as WorkerShown} from "../../wire/page/session.generated.ts"
import type {PoseShown} from "../../wire/telemetry.generated.ts"
import type {Checked} from "../../wire/worker.generated.ts"
import type {World} from "../../worlds/world.ts"
import type {Preview} from "./preview.ts"
import type {Explanation} from "./why_state.ts"

/// State of the robot at one time: ground truth in room coordinates, and the values of its channels. A message has only values that changed.
export type Frame = Omit<ShownFrame, "op" | "pose" | "firings" | "times" | "others"> &
  PoseShown &
  Partial<Pick<ShownFrame, "firings" | "times" | "others">>

export type LessonChecks = Omit<ChecksShown, "op">

/// `failed`: the compiler cannot be started on the computer of the service.
export type WorkerState = WorkerShown["state"]
export type Ended = NonNullable<RunState["ended"]>

/// A run on a real robot, and its recording.
export type RecordedFile = Omit<RunRecorded, "op">

/// The messages that are passed on as the service sends them.
type Unchanged = Exclude<
  Answer,
  {
    readonly op:
      | "hello"
      | "worker"
      | "world"
      | "checked"
      | "state"
      | "frame"
      | "previewed"
      | "checks"
      | "because"
      | "robot"
      | "safety"
      | "refusal"
  }
>

export type ServiceMessage =
  | Unchanged
  | (Pick<Hello, "op" | "session"> & Partial<Pick<Hello, "class">>)
  | {readonly op: "worker"; readonly state: WorkerState; readonly fault: string}
  | {readonly op: "world"; readonly world: World}
  | (Omit<Checked, "graph"> & {
      /// What the program runs; none when it has mistakes.
      readonly parts: readonly ProgramPart[]
      readonly topics: readonly OwnTopic[]
    })
  | {readonly op: "state"; readonly run: number; readonly state: "compiling"}
  | ({readonly op: "state"; readonly run: number; readonly state: "running"} & Partial<
      Pick<RunState, "branches">
    >)
  | {readonly op: "state"; readonly run: number; readonly state: "queued"; readonly place: number}
  | ({readonly op: "state"; readonly state: "ended"; readonly ended: Ended} & Pick<
      RunState,
      "run" | "problems"
    >)
  | {readonly op: "frame"; readonly frame: Frame}
  | {readonly op: "previewed"; readonly preview: Preview}
  | {readonly op: "checks"; readonly checks: LessonChecks}
  | {readonly op: "because"; readonly answer: Explanation}
  | {readonly op: "robot"; readonly robot: Omit<RobotState, "op" | "sentence">}
  | (Pick<Safety, "op" | "on"> & {
      /// The run and its time at which the rules began to override the program; `null` while they do not.
      readonly override: {readonly run: number; readonly since: number} | null
    })
  | {readonly op: "refusal"; readonly message: string; readonly hint: string}

/// How many seconds of the run pass in one of the learner's; `"max"` is as fast as it can.
export type Speed = NonNullable<Run["speed"]>

/// Input of the learner to the simulated robot: buttons, lifting, moving.
export type Hand = Omit<Input, "op">
