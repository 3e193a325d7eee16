/// A real robot and the same program in the simulator beside it.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds} = measuresOf("en")
const list = new Intl.ListFormat("en")

/// When something happened to the real robot and to the simulated one, s; `null` is never.
type Times = readonly [real: number | null, simulated: number | null]
const at = (time: number | null) => (time === null ? "never" : `at ${seconds(time, 1)}`)

export const twin = {
  show: "Simulator beside it",
  hint: "The same program also drives the simulated robot in the chosen room: both paths, charts, and what was different",
  real: (n: number) => `Run ${n}, real`,
  simulated: (n: number) => `Run ${n}, simulated`,
  names: {real: "real", simulated: "simulated"},
  /// `what` are the parts below.
  sentence: (time: number, what: readonly string[]) =>
    `After ${seconds(time, 1)}: the real robot ${list.format(what)}.`,
  same: (time: number) => `After ${seconds(time, 1)}: the real robot and the simulated one did the same.`,
  turned: {
    more: (angle: string) => `turned ${angle} more`,
    less: (angle: string) => `turned ${angle} less`,
    left: (angle: string) => `turned ${angle} further to the left`,
    right: (angle: string) => `turned ${angle} further to the right`,
  },
  drove: {
    further: (way: string) => `drove ${way} further`,
    less: (way: string) => `drove ${way} less`,
  },
  apart: (way: string) => `was ${way} away from the simulated one`,
  felt: {
    Bumper: ([real, simulated]: Times) =>
      `had its bumper pressed ${at(real)}, the simulated one ${at(simulated)}`,
    Cliff: ([real, simulated]: Times) => `came to an edge ${at(real)}, the simulated one ${at(simulated)}`,
    Wheel: ([real, simulated]: Times) =>
      `had a wheel in the air ${at(real)}, the simulated one ${at(simulated)}`,
  },
} as const
