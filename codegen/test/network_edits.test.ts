/// Edits of the dataflow network: what they write, why they are refused, and that they change nothing else.

import {beforeAll, describe, expect, test} from "vitest"
import {
  type NetworkAction,
  networkEdit,
  refusalSentence,
  type WrittenShape,
  writtenNetwork,
} from "../src/network_edits/index.ts"
import {openView, type Reader, syncText, workspaceOf} from "../src/reader/index.ts"
import {pieceText} from "../src/reader/view/view.ts"
import {inferWorkspace} from "../src/workspace/inference/workspace_inference.ts"
import {isRefusal} from "../src/workspace/moves/refusal_messages.ts"
import {drawnAction, exampleTexts} from "./generate/network_actions.ts"
import {Dice} from "./generate/random.ts"
import {testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const edit = (text: string, action: NetworkAction) => networkEdit(reader, openView(reader, text), action)

function edited(text: string, ...actions: readonly NetworkAction[]): string {
  return actions.reduce((before, action) => {
    const outcome = edit(before, action)
    if (!outcome.ok) throw new Error(refusalSentence(outcome.refusal))
    return outcome.text
  }, text)
}

const empty = "main :: IO ()\nmain = simulate _\n"
const reflex = `-- Away from walls.
backOff :: Bumper -> Velocity -- quickly
backOff (Bumper _ _) = Velocity (-0.2) 0

main :: IO ()
main = simulate backOff -- all of it
`
const twoCases = `react :: Either Bumper Cliff -> Memory Bool -> Maybe Sound
react (Left bumper) (Memory seen) = Nothing
react (Right cliff) (Memory seen) = Just ErrorSound

main = simulate react
`

const twoOutputs = `react :: Bumper -> Memory Int -> Maybe (Velocity, Led1, Memory Int) -- all of it
react (Bumper _ Pressed) (Memory n)
  | n > 3 = Nothing
  | otherwise = Just (Velocity (-0.2) 0, Led1 Red, Memory (n + 1))
react _ (Memory n) = if n > 2 then Nothing else Just (Velocity 0 0, Led1 Green, Memory n) -- stop

main = simulate react
`

describe("an edit writes what a person would write", () => {
  test.each<[string, string, readonly NetworkAction[], string]>([
    [
      "a sensor connected to an actuator",
      empty,
      [{kind: "connect-sensor-to-actuator", sensor: "Bumper", actuator: "Velocity", name: "backOff"}],
      "backOff :: Bumper -> Maybe Velocity\nbackOff (Bumper _ Pressed) = Just (Velocity (-0.2) 0)\nbackOff (Bumper _ Released) = Nothing\n\nmain :: IO ()\nmain = simulate backOff\n",
    ],
    [
      "the tick connected to an actuator, beside another function",
      reflex,
      [{kind: "connect-sensor-to-actuator", sensor: "()", actuator: "Led1", name: "shine"}],
      reflex
        .replace("main ::", "shine :: Led1\nshine = Led1 Red\n\nmain ::")
        .replace("simulate backOff", "simulate (backOff, shine)"),
    ],
    [
      "one more input",
      reflex,
      [{kind: "add-input", function: "backOff", type: "Velocity", as: "all"}],
      reflex
        .replace("Bumper -> Velocity", "Bumper -> Velocity -> Velocity")
        .replace("(Bumper _ _) =", "(Bumper _ _) (Velocity linear angular) ="),
    ],
    [
      "another event",
      reflex,
      [{kind: "add-input", function: "backOff", type: "Cliff", as: "either"}],
      reflex
        .replace("Bumper ->", "Either Bumper Cliff ->")
        .replace(
          "backOff (Bumper _ _) = Velocity (-0.2) 0\n",
          "backOff (Left (Bumper _ _)) = Velocity (-0.2) 0\nbackOff (Right (Cliff side status)) = _\n",
        ),
    ],
    [
      "a memory that is read, and one that is written",
      reflex,
      [
        {kind: "add-input", function: "backOff", type: "Memory Bool", as: "all"},
        {kind: "add-output", function: "backOff", type: "Memory Bool"},
      ],
      reflex
        .replace("Bumper -> Velocity", "Bumper -> Memory Bool -> (Velocity, Memory Bool)")
        .replace("(Bumper _ _) = Velocity (-0.2) 0", "(Bumper _ _) (Memory bool) = (Velocity (-0.2) 0, _)"),
    ],
    [
      "a bump that is remembered, and a light that shows it",
      empty,
      [
        {kind: "connect-sensor-to-actuator", sensor: "Bumper", actuator: "Memory Bool", name: "bump"},
        {kind: "connect-sensor-to-actuator", sensor: "Memory Bool", actuator: "Led1", name: "shine"},
      ],
      `bump :: Bumper -> Maybe (Memory Bool)
bump (Bumper _ Pressed) = Just (Memory True)
bump _ = Nothing

shine :: Memory Bool -> Led1
shine (Memory True) = Led1 Red
shine (Memory False) = Led1 Black

main :: IO ()
main = simulate (bump, shine)
`,
    ],
    [
      "an event that is sent where the function sends anything",
      `onBump :: Bumper -> Maybe Sound
onBump (Bumper _ Pressed) = Just ErrorSound
onBump _ = Nothing

shine :: Led1
shine = Led1 Red

main = simulate (onBump, shine)
`,
      [{kind: "connect-functions", from: "onBump", to: "shine", event: "Hit", as: "all"}],
      `onBump :: Bumper -> Maybe (Sound, Hit)
onBump (Bumper _ Pressed) = Just (ErrorSound, Hit)
onBump _ = Nothing

shine :: Hit -> Led1
shine Hit = Led1 Red

data Hit = Hit

main = simulate (onBump, shine)
`,
    ],
    [
      "a memory beside another one that is written at times",
      "bump :: Bumper -> Maybe (Memory Bool)\nbump (Bumper _ Pressed) = Just (Memory True)\nbump _ = Nothing\n\nmain = simulate bump\n",
      [{kind: "add-output", function: "bump", type: "Memory Int"}],
      "bump :: Bumper -> Maybe (Memory Bool, Memory Int)\nbump (Bumper _ Pressed) = Just (Memory True, _)\nbump _ = Nothing\n\nmain = simulate bump\n",
    ],
    [
      "two functions connected by a new event",
      reflex.replace("main ::", "shine :: Led1\nshine = Led1 Red\n\nmain ::"),
      [{kind: "connect-functions", from: "backOff", to: "shine", event: "Hit", as: "all"}],
      reflex
        .replace("Bumper -> Velocity", "Bumper -> (Velocity, Hit)")
        .replace("= Velocity (-0.2) 0", "= (Velocity (-0.2) 0, Hit)")
        .replace("main ::", "shine :: Hit -> Led1\nshine Hit = Led1 Red\n\ndata Hit = Hit\n\nmain ::"),
    ],
    [
      "one side of an Either cut off, with its case",
      twoCases,
      [{kind: "cut-input", function: "react", type: "Bumper"}],
      twoCases
        .replace("Either Bumper Cliff", "Cliff")
        .replace("react (Left bumper) (Memory seen) = Nothing\n", "")
        .replace("(Right cliff)", "cliff"),
    ],
    [
      "an input cut off that nothing tells apart",
      twoCases,
      [{kind: "cut-input", function: "react", type: "Cliff"}],
      twoCases
        .replace("Either Bumper Cliff", "Bumper")
        .replace("react (Right cliff) (Memory seen) = Just ErrorSound\n", "")
        .replace("(Left bumper)", "bumper"),
    ],
    [
      "an output cut off, in every answer",
      twoOutputs,
      [{kind: "cut-output", function: "react", type: "Led1"}],
      twoOutputs
        .replace("Maybe (Velocity, Led1, Memory Int)", "Maybe (Velocity, Memory Int)")
        .replace("(Velocity (-0.2) 0, Led1 Red, Memory (n + 1))", "(Velocity (-0.2) 0, Memory (n + 1))")
        .replace("(Velocity 0 0, Led1 Green, Memory n)", "(Velocity 0 0, Memory n)"),
    ],
    [
      "all outputs but the first cut off",
      twoOutputs,
      [
        {kind: "cut-output", function: "react", type: "Velocity"},
        {kind: "cut-output", function: "react", type: "Led1"},
      ],
      twoOutputs
        .replace("Maybe (Velocity, Led1, Memory Int)", "Maybe (Memory Int)")
        .replace("(Velocity (-0.2) 0, Led1 Red, Memory (n + 1))", "(Memory (n + 1))")
        .replace("(Velocity 0 0, Led1 Green, Memory n)", "(Memory n)"),
    ],
    [
      "the only output cut off: the function stands beside",
      reflex.replace("simulate backOff", "simulate (backOff, shine)"),
      [{kind: "cut-output", function: "backOff", type: "Velocity"}],
      reflex.replace("simulate backOff", "simulate shine"),
    ],
    [
      "a function renamed wherever it is named",
      reflex,
      [{kind: "rename", function: "backOff", name: "flee"}],
      reflex.replaceAll("backOff", "flee"),
    ],
    [
      "a copy that stands beside, with its comments",
      reflex,
      [{kind: "duplicate", function: "backOff", name: "flee"}],
      reflex.replace(
        "main ::",
        "-- Away from walls.\n-- quickly\nflee :: Bumper -> Velocity\nflee (Bumper _ _) = Velocity (-0.2) 0\n\nmain ::",
      ),
    ],
    [
      "out of simulate, and back",
      `${reflex.replace("simulate backOff", "simulate (backOff, shine)")}\nshine :: Led1\nshine = Led1 Red\n`,
      [
        {kind: "leave", function: "backOff"},
        {kind: "join", function: "backOff"},
      ],
      `${reflex.replace("simulate backOff", "simulate (shine, backOff)")}\nshine :: Led1\nshine = Led1 Red\n`,
    ],
    [
      "a deleted function that another one went before",
      `${reflex.replace("simulate backOff", "simulate (priority 1 backOff go)")}\ngo :: Velocity\ngo = Velocity 0.2 0\n`,
      [{kind: "delete", function: "backOff"}],
      "\nmain :: IO ()\nmain = simulate go -- all of it\n\ngo :: Velocity\ngo = Velocity 0.2 0\n",
    ],
  ])("%s", (_, before, actions, after) => {
    expect(edited(before, ...actions)).toBe(after)
  })
})

describe("an edit is refused with its cause:", () => {
  test.each<[string, NetworkAction, string]>([
    [reflex, {kind: "add-input", function: "backOff", type: "Bumper", as: "all"}, "already-takes"],
    [twoCases, {kind: "add-input", function: "react", type: "Cliff", as: "either"}, "already-takes"],
    [reflex, {kind: "add-output", function: "backOff", type: "Velocity"}, "already-sends"],
    [twoCases, {kind: "add-output", function: "react", type: "Sound"}, "already-sends"],
    [reflex, {kind: "join", function: "backOff"}, "already-runs"],
    [reflex, {kind: "leave", function: "absent"}, "does-not-run"],
    [reflex, {kind: "delete", function: "absent"}, "no-such-function"],
    [reflex, {kind: "cut-input", function: "backOff", type: "Cliff"}, "does-not-take"],
    [reflex, {kind: "cut-output", function: "backOff", type: "Led1"}, "does-not-send"],
    [
      "f :: Bumper -> (Velocity, Led1)\nf _ = both\n\nboth :: (Velocity, Led1)\nboth = (Velocity 0 0, Led1 Red)\n\nmain = simulate f\n",
      {kind: "cut-output", function: "f", type: "Led1"},
      "computes-together",
    ],
    [
      "f :: Bumper -> Led1\nf (Bumper _ Pressed) = Led1 Red\nf (Bumper _ Released) = Led1 Green\n\nmain = simulate f\n",
      {kind: "cut-input", function: "f", type: "Bumper"},
      "tells-apart",
    ],
    [
      "f (Bumper side _) = g side\n\ng side = Led1 Red\n\nmain = simulate f\n",
      {kind: "delete", function: "g"},
      "used-elsewhere",
    ],
    [
      "f :: Bumper -> Velocity -> Velocity\nf bumper velocity = velocity\n\nmain = simulate f\n",
      {kind: "cut-input", function: "f", type: "Velocity"},
      "does-not-fit",
    ],
    [
      "f :: Velocity -> Led1\nf v = Led1 Red\n\nmain = simulate f\n",
      {kind: "add-input", function: "f", type: "Bumper", as: "either"},
      "takes-no-event",
    ],
    [
      reflex,
      {kind: "connect-sensor-to-actuator", sensor: "Cliff", actuator: "Velocity", name: "backOff"},
      "name-taken",
    ],
    [
      reflex,
      {kind: "connect-sensor-to-actuator", sensor: "Cliff", actuator: "Velocity", name: "of"},
      "not-a-name",
    ],
    [
      "f :: Bumper -> Led1\nf bumper = Led1 Red\n\nmain = do\n  simulate f\n  return ()\n",
      {kind: "connect-sensor-to-actuator", sensor: "Cliff", actuator: "Velocity", name: "stop"},
      "no-simulate",
    ],
    [
      reflex,
      {kind: "connect-functions", from: "backOff", to: "backOff", event: "hit", as: "either"},
      "not-a-type-name",
    ],
    [
      reflex,
      {kind: "connect-functions", from: "backOff", to: "backOff", event: "Led1", as: "either"},
      "name-taken",
    ],
  ])("%#", (text, action, cause) => {
    const outcome = edit(text, action)
    expect(outcome.ok ? outcome.text : outcome.refusal.kind).toBe(cause)
    if (!outcome.ok) expect(refusalSentence(outcome.refusal)).toMatch(/\.$/)
  })
})

test("an edit declares the type of a memory, as one change", () => {
  const action = {kind: "add-output", function: "backOff", type: "Memory Mode"} as const
  const declaring = (name: string, ...values: readonly string[]) =>
    networkEdit(reader, openView(reader, reflex), action, undefined, {name, values})
  const outcome = declaring("Mode", "Calm", "Alarmed")
  expect(outcome.ok && outcome.text).toBe(
    reflex
      .replace("Bumper -> Velocity", "Bumper -> (Velocity, Memory Mode)")
      .replace("= Velocity (-0.2) 0", "= (Velocity (-0.2) 0, _)")
      .replace("main ::", "data Mode = Calm | Alarmed\n\nmain ::"),
  )
  for (const [cause, name, ...values] of [
    ["not-a-type-name", "mode", "Calm"],
    ["not-a-type-name", "Mode", "calm"],
    ["name-taken", "Bumper", "Calm"],
    ["name-taken", "Mode", "Calm", "Calm"],
    ["name-taken", "Mode", "Pressed"],
  ] as const) {
    const refused = declaring(name, ...values)
    expect(refused.ok ? refused.text : refused.refusal.kind, [name, ...values].join(" ")).toBe(cause)
  }
})

test("an edit of a definition whose text is broken is refused, and names it", () => {
  const whole = "f :: Bumper -> Led1\nf bumper = Led1 Red\n\nmain = simulate f\n"
  const broken = syncText(reader, openView(reader, whole), whole.replace("f bumper =", "f (bumper ="))
  expect(networkEdit(reader, broken, {kind: "add-output", function: "f", type: "Sound"})).toEqual({
    ok: false,
    refusal: {kind: "unfinished", names: ["f"]},
  })
})

test("the written network tells what runs, what stands beside, tasks, and no helpers", () => {
  const text = `type Hit = Bool
data Alarm = Alarm
data Mode = Calm | Alarmed
data Turn = Turn Double
data Pair a = Pair a a
f :: Either Bumper Alarm -> Memory Hit -> (Velocity, Maybe Led1)
f _ (Memory h) = _
beside :: Velocity -> Velocity
beside v = faster v
faster :: Velocity -> Velocity
faster v = v
half :: Double -> Double
half x = x / 2
main = simulate (f, drive 10)
`
  const type = (written: string, spelled = written, own = false): WrittenShape => ({
    kind: "type",
    written,
    spelled,
    own,
    topic: null,
  })
  expect(writtenNetwork(workspaceOf(openView(reader, text)))).toEqual({
    hasSimulate: true,
    types: ["Hit", "Mode", "Turn"],
    tasks: [{kind: "step", block: expect.any(String), name: "drive", turns: null, steps: [], result: null}],
    steps: [],
    functions: [
      {
        name: "f",
        runs: true,
        inputs: [
          {kind: "either", of: [type("Bumper"), type("Alarm", "Alarm", true)]},
          type("Memory Hit", "Memory Bool"),
        ],
        output: {kind: "all", of: [type("Velocity"), {kind: "maybe", of: type("Led1")}]},
      },
      {name: "beside", runs: false, inputs: [type("Velocity")], output: type("Velocity")},
    ],
  })
})

const cases = 6 * Number(process.env.ROSY_TEST_NIGHTLY ?? 1)

test("random edits of the examples change the meant definitions alone, and every type fits", () => {
  let made = 0
  for (const [name, program] of exampleTexts) {
    const dice = new Dice(program.length)
    let text = program
    for (let i = 0; i < cases; i++) {
      const before = openView(reader, text)
      const [action, meant] = drawnAction(before, dice)
      const outcome = networkEdit(reader, before, action)
      if (!outcome.ok) continue
      made++
      const after = openView(reader, outcome.text)
      const others = (view: typeof before) =>
        view.module.pieces
          .filter(piece => piece.kind === "declaration" && !piece.names.some(one => meant.includes(one)))
          .map(pieceText)
      expect(others(after), `${name}: ${JSON.stringify(action)}`).toEqual(others(before))
      const mistakes = (view: typeof before) =>
        inferWorkspace(workspaceOf(view)).inference.problems.filter(isRefusal).length
      expect(mistakes(after), outcome.text).toBeLessThanOrEqual(mistakes(before))
      text = outcome.text
    }
  }
  expect(made).toBeGreaterThan(2 * exampleTexts.length)
})

test("a memory of a synonym has the name that the program gives it, also where it is written at times", () => {
  const text =
    "type Hit = Bool\n\nbump :: Bumper -> Maybe (Memory Hit)\nbump _ = Just (Memory True)\n\nmain = simulate bump\n"
  const {functions} = writtenNetwork(workspaceOf(openView(reader, text)))
  expect(functions.find(({name}) => name === "bump")?.output).toMatchObject({
    kind: "maybe",
    of: {kind: "type", written: "Memory Hit"},
  })
})
