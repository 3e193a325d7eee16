/// Words of the run tree: runs of a program in a room, what was changed between them, and their comparison.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds, count} = measuresOf("en")

export const runs = {
  show: "Show the runs in this room",
  empty: "Run the program: each run is kept here, with a picture of its path.",
  choose: "Choose a run to look at it again.",
  isRunning: "Stop the program to look at another run.",
  run: (number: number) => `Run ${number}`,
  goOn: (number: number) => `Go on with run ${number}`,
  otherProgram: (number: number) => `Run ${number} had another program.`,
  showProgram: "Show its program",
  continued: (run: number, at: number) => `continues run ${run} at ${seconds(at, 2)}`,
  changes: {
    same: "the same program",
    layout: "only comments or layout",
    value: (name: string, before: string, after: string) => `${name}: ${before} → ${after}`,
    added: {function: (name: string) => `new function ${name}`, type: (name: string) => `new type ${name}`},
    removed: (name: string) => `without ${name}`,
    changed: (name: string) => `${name} changed`,
    renamed: (before: string, after: string) => `${before} is now called ${after}`,
    more: (n: number) => count(n, {one: "and one more change", other: n => `and ${n} more changes`}),
  },
  goals: (done: number, all: number) => `${done} of ${all} goals`,
  compare: "Compare with",
  none: "no other run",
  compared: "compared",
  paused: "paused",
  /// How the path of each of two runs is drawn.
  lines: {shown: "solid line", compared: "dotted line"},
  both: "The two runs",
  length: "Length",
  way: "Way driven",
  goalStates: {
    open: "not done",
    done: (at: number) => `done at ${seconds(at, 1)}`,
    missed: (at: number) => `missed at ${seconds(at, 1)}`,
  },
  dropped: (n: number) =>
    count(n, {one: "An older run is no longer kept.", other: n => `${n} older runs are no longer kept.`}),
} as const
