/// Edits of the dataflow network as values, and what comes of one: a new text, or the cause why there is none.

import type {BlockId} from "../serialized_blocks.ts"

/// A step of a task that an edit adds, with values to be changed; `task` is a task of the program.
export type NewStep =
  | {readonly kind: "drive" | "turn" | "wait" | "say" | "driveUntilBump" | "driveBack"}
  | {readonly kind: "task"; readonly name: string}

/// Types are written as the program writes them, without brackets around the whole: `Bumper`, `Memory Hit`.
export type NetworkAction =
  /// A new function of that type, which `simulate` runs. The sensor `()` is the tick: the function takes nothing.
  | {
      readonly kind: "connect-sensor-to-actuator"
      readonly sensor: string
      readonly actuator: string
      readonly name: string
    }
  /// `all`: one more argument. `either`: the first event that it takes, or this one.
  | {
      readonly kind: "add-input"
      readonly function: string
      readonly type: string
      readonly as: "all" | "either"
    }
  | {readonly kind: "add-output"; readonly function: string; readonly type: string}
  /// The sender sends the event, and the receiver takes it. An event that the program does not have yet is declared.
  | {
      readonly kind: "connect-functions"
      readonly from: string
      readonly to: string
      readonly event: string
      readonly as: "all" | "either"
    }
  | {readonly kind: "cut-input"; readonly function: string; readonly type: string}
  /// A function that sends nothing else is no longer run; its definition stays.
  | {readonly kind: "cut-output"; readonly function: string; readonly type: string}
  | {readonly kind: "delete"; readonly function: string}
  | {readonly kind: "rename"; readonly function: string; readonly name: string}
  | {readonly kind: "duplicate"; readonly function: string; readonly name: string}
  /// `simulate` runs the function, or no longer runs it.
  | {readonly kind: "join"; readonly function: string}
  | {readonly kind: "leave"; readonly function: string}
  /// Steps of tasks are named by their blocks. `inside`: at the end of a loop or of a definition. Without a step it is the end of the program's task, which
  /// begins with it where there is none.
  | {
      readonly kind: "add-step"
      readonly at: BlockId | null
      readonly where: "before" | "after" | "inside"
      readonly step: NewStep
    }
  | {
      readonly kind: "move-step"
      readonly step: BlockId
      readonly at: BlockId
      readonly where: "before" | "after"
    }
  | {readonly kind: "delete-step"; readonly step: BlockId}
  /// The steps from one to another of the same chain are repeated, for ever without a number of turns.
  | {
      readonly kind: "loop-steps"
      readonly from: BlockId
      readonly to: BlockId
      readonly turns: number | null
    }
  | {
      readonly kind: "put-beside"
      readonly step: BlockId
      readonly with: BlockId
      readonly as: "parallel" | "race"
    }
  /// A loop, or two tasks side by side, become steps one after the other.
  | {readonly kind: "take-apart"; readonly step: BlockId}

/// A type of the program's own that an edit declares for what it connects: its name, and its values.
export interface DeclaredType {
  readonly name: string
  readonly values: readonly string[]
}

/// Why an edit is not made.
export type NetworkRefusal =
  /// No definition of the program has this name and is made of equations that blocks can say.
  | {readonly kind: "no-such-function"; readonly function: string}
  | {readonly kind: "name-taken"; readonly name: string}
  | {readonly kind: "not-a-name"; readonly name: string}
  | {readonly kind: "not-a-type-name"; readonly name: string}
  /// The program has no `simulate`, or computes what it gives to it.
  | {readonly kind: "no-simulate"}
  | {readonly kind: "type-unknown"; readonly function: string}
  | {readonly kind: "already-takes"; readonly function: string; readonly type: string}
  | {readonly kind: "already-sends"; readonly function: string; readonly type: string}
  | {readonly kind: "already-runs"; readonly function: string}
  | {readonly kind: "does-not-run"; readonly function: string}
  /// There is nothing that the new event could be an alternative to.
  | {readonly kind: "takes-no-event"; readonly function: string}
  | {readonly kind: "takes-too-much"; readonly function: string}
  /// Equations of the function tell values of this input apart.
  | {readonly kind: "tells-apart"; readonly function: string; readonly type: string}
  | {readonly kind: "does-not-take"; readonly function: string; readonly type: string}
  | {readonly kind: "does-not-send"; readonly function: string; readonly type: string}
  /// The function does not write this output for itself: it computes it with others, or chooses between them.
  | {readonly kind: "computes-together"; readonly function: string; readonly type: string}
  /// Other definitions use the function.
  | {readonly kind: "used-elsewhere"; readonly function: string}
  | {readonly kind: "no-such-step"}
  /// Nothing would be left in a loop, a definition or one of two tasks side by side.
  | {readonly kind: "only-step"}
  /// A step would stand inside of itself.
  | {readonly kind: "inside-itself"}
  /// Only steps of one chain can be repeated together, or put side by side.
  | {readonly kind: "other-chain"}
  /// Neither a loop nor tasks side by side.
  | {readonly kind: "not-composed"}
  /// The program would have a mistake that it does not have; `why` is a sentence in the learner's language.
  | {readonly kind: "does-not-fit"; readonly why: string}
  /// The texts of these definitions are unfinished, or say what blocks cannot.
  | {readonly kind: "unfinished"; readonly names: readonly string[]}
  /// What was written for a definition lacks something, or is no Haskell.
  | {readonly kind: "unfinished-text"}

export type NetworkEdit =
  /// `selects` is the definition that the learner looks at next.
  | {readonly ok: true; readonly text: string; readonly selects: string | undefined}
  | {readonly ok: false; readonly refusal: NetworkRefusal}
