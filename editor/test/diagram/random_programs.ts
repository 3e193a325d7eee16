/// Random programs as the compiler would report them, and edits of one function.

import fc from "fast-check"
import type {ProgramPart, TypeShape} from "../../src/program/program_graph.ts"

const leaf = (spelled: string, own = false): TypeShape => ({
  kind: "type",
  written: spelled,
  spelled,
  own,
  topic: null,
})
const onTopic = (spelled: string, name: string | null): TypeShape => ({
  kind: "type",
  written: spelled,
  spelled,
  own: false,
  topic: {name, type: "std_msgs/Float64"},
})
const topics = [onTopic("Charge", "/mobile_base/sensors/core"), onTopic("Level", null)]
const events = ["Bumper", "Cliff", "Wheel", "Button"].map(type => leaf(type))
const states = ["Velocity", "Position", "Orientation"].map(type => leaf(type))
const samples = ["Seconds", "StdGen", "()"].map(type => leaf(type))
const stores = ["Memory Int", "Memory Mode", "Param Bool"].map(type => leaf(type))
const channels = ["Alarm", "Wanted Velocity", "ChangeDirection"].map(type => leaf(type, true))
const commands = ["Velocity", "Led1", "Led2", "Sound", "Say"].map(type => leaf(type))

const shapeOf = (leaves: readonly TypeShape[]): fc.Arbitrary<TypeShape> => {
  const one = fc.constantFrom(...leaves)
  const several = fc.array(one, {minLength: 2, maxLength: 3})
  return fc.oneof(
    {weight: 5, arbitrary: one},
    {weight: 1, arbitrary: several.map((of): TypeShape => ({kind: "all", of}))},
    {weight: 2, arbitrary: several.map((of): TypeShape => ({kind: "either", of}))},
    {weight: 1, arbitrary: one.map((of): TypeShape => ({kind: "maybe", of}))},
  )
}
const inputs = fc.array(shapeOf([...events, ...states, ...samples, ...stores, ...channels, ...topics]), {
  maxLength: 3,
})
const output = shapeOf([...commands, ...stores, ...channels, ...topics])

export type FunctionPart = ProgramPart & {readonly kind: "function"}

const functionNamed = (name: string): fc.Arbitrary<FunctionPart> =>
  fc.record({inputs, output}).map(ends => ({kind: "function", name, at: null, ...ends}))

export const anyFunction: fc.Arbitrary<FunctionPart> = functionNamed("edited")

const functions = (most: number) =>
  fc
    .array(fc.record({inputs, output}), {minLength: 1, maxLength: most})
    .map(all => all.map((ends, i): FunctionPart => ({kind: "function", name: `f${i}`, at: null, ...ends})))

const step: fc.Arbitrary<ProgramPart> = fc.oneof(
  fc
    .constantFrom("drive 20", "turn 90", "wait 1")
    .map((name): ProgramPart => ({kind: "step", name, at: null})),
  functions(3).map((parts): ProgramPart => ({kind: "task", name: "work", at: null, start: [], parts})),
)
const chart: fc.Arbitrary<ProgramPart> = fc.letrec<{chart: ProgramPart}>(tie => ({
  chart: fc
    .tuple(
      fc.constantFrom("sequence", "repeat", "parallel", "race", "choice"),
      fc.array(fc.oneof({maxDepth: 2}, step, tie("chart")), {minLength: 1, maxLength: 3}),
    )
    .map(([kind, steps]): ProgramPart => ({kind, name: "plan", at: null, turns: null, steps})),
})).chart

/// Functions, and at times tasks beside them.
export const anyProgram: fc.Arbitrary<readonly ProgramPart[]> = fc
  .tuple(functions(12), fc.array(fc.oneof(step, chart), {maxLength: 2}))
  .map(([own, tasks]) => [...own, ...tasks])
