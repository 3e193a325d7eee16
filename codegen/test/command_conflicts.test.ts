/// Conflicts of functions that set the same actuator: a table of programs that conflict and of programs that do not.

import {existsSync, readdirSync, readFileSync} from "node:fs"
import {beforeAll, describe, expect, test} from "vitest"
import {
  type ConflictNames,
  conflictFix,
  conflictMerge,
  conflictShown,
  infer,
  newProject,
  openProject,
  parseProject,
} from "../src/index.ts"
import {openView, type Reader, workspaceOf} from "../src/reader/index.ts"
import {events, heldCommands, states} from "../src/robot/roles.ts"
import {words} from "../src/words/index.ts"
import {commandConflicts, conflictProblems} from "../src/workspace/inference/command_conflicts.ts"
import {inferWorkspace} from "../src/workspace/inference/workspace_inference.ts"
import {corpus, testReader} from "./reader/open.ts"

const examples = new URL("../../examples/", import.meta.url)
let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

/// The functions of the programs below.
const definitions: {readonly [name: string]: string} = {
  drive: "drive :: Velocity\ndrive = Velocity 0.2 0",
  circle: "circle :: Velocity\ncircle = Velocity 0.2 0.5",
  pulse: "pulse :: () -> Velocity\npulse () = Velocity 0.2 0",
  accelerate: "accelerate :: Velocity -> Velocity\naccelerate (Velocity v w) = Velocity (v + 0.1) w",
  steer: "steer :: Orientation -> Velocity\nsteer (Orientation a) = Velocity 0.2 a",
  home: "home :: Position -> Velocity\nhome (Position x y)\n  | x > 1 = Velocity 0 0\n  | otherwise = Velocity 0.2 y",
  wander: "wander :: Clock -> Velocity\nwander (Clock _ _ s _) = Velocity 0.2 (fromIntegral s)",
  timed: "timed :: Seconds -> Velocity\ntimed now = if now > 2 then Velocity 0 0 else Velocity 0.2 0",
  dice: "dice :: StdGen -> Velocity\ndice gen = Velocity 0.2 (fst (randomR (-1, 1) gen))",
  pose: "pose :: Pose -> Velocity\npose (Pose _ (Orientation a)) = Velocity 0 a",
  backOff:
    "backOff :: Bumper -> Maybe Velocity\nbackOff (Bumper _ Pressed) = Just (Velocity (-0.2) 0)\nbackOff _ = Nothing",
  bounce: "bounce :: Bumper -> Velocity\nbounce _ = Velocity (-0.2) 0",
  flee: "flee :: Bumper -> Velocity\nflee (Bumper _ _) = Velocity (-0.3) 0",
  left: "left :: BumperLeft -> Velocity\nleft _ = Velocity 0 (-1)",
  right: "right :: BumperRight -> Velocity\nright _ = Velocity 0 1",
  stopAtHole:
    "stopAtHole :: Cliff -> Maybe Velocity\nstopAtHole (Cliff _ Hole) = Just (Velocity 0 0)\nstopAtHole _ = Nothing",
  lifted: "lifted :: Wheel -> Velocity\nlifted _ = Velocity 0 0",
  button: "button :: Button -> Velocity\nbutton _ = Velocity 0.2 0",
  bumpThere: "bumpThere :: Bumper -> Position -> Velocity\nbumpThere _ (Position x _) = Velocity x 0",
  safety:
    "safety :: Either Bumper Cliff -> Maybe Velocity\nsafety (Left _) = Just (Velocity 0 0)\nsafety (Right _) = Nothing",
  lamp: "lamp :: Clock -> Led1\nlamp _ = Led1 Orange",
  glow: "glow :: Led1\nglow = Led1 Green",
  bumpLamp: "bumpLamp :: Bumper -> Led1\nbumpLamp _ = Led1 Red",
  cliffLamp: "cliffLamp :: Cliff -> Maybe Led1\ncliffLamp _ = Just (Led1 Red)",
  second: "second :: Led2\nsecond = Led2 Green",
  bumpSecond: "bumpSecond :: Bumper -> Led2\nbumpSecond _ = Led2 Red",
  both: "both :: Bumper -> (Led1, Velocity)\nboth _ = (Led1 Red, Velocity 0 0)",
  shine: "shine :: (Velocity, Led1)\nshine = (Velocity 0.2 0, Led1 Green)",
  beepOn: "beepOn :: Bumper -> Sound\nbeepOn _ = ErrorSound",
  hum: "hum :: Sound\nhum = OnSound",
  talk: 'talk :: Say\ntalk = Say "hello"',
  shout: 'shout :: Bumper -> Say\nshout _ = Say "ouch"',
  remember: "remember :: Bumper -> Memory Bool\nremember (Bumper _ status) = Memory (status == Pressed)",
  recall:
    "recall :: Memory Bool -> Velocity\nrecall (Memory hit) = if hit then Velocity (-0.2) 0 else Velocity 0.2 0",
  recallNow:
    "recallNow :: Memory Bool -> Velocity -> Velocity\nrecallNow (Memory hit) (Velocity v w)\n  | hit = Velocity (v - 0.1) w\n  | otherwise = Velocity (v + 0.1) w",
  rememberAndBack:
    "rememberAndBack :: Bumper -> (Memory Bool, Velocity)\nrememberAndBack _ = (Memory True, Velocity (-0.2) 0)",
  count: "count :: Button -> Memory Int -> Memory Int\ncount _ (Memory n) = Memory (n + 1)",
  byCount: "byCount :: Memory Int -> Velocity\nbyCount (Memory n) = Velocity (0.1 * fromIntegral n) 0",
  unless:
    "unlessBlocked :: Memory Bool -> Maybe Velocity\nunlessBlocked (Memory True) = Nothing\nunlessBlocked (Memory False) = Just (Velocity 0.2 0)",
  sometimes:
    "sometimes :: Position -> Maybe Velocity\nsometimes (Position x _) = if x > 1 then Just (Velocity 0 0) else Nothing",
  even: "evenSecond :: Clock -> Velocity\nevenSecond (Clock _ _ s _)\n  | even s = Velocity 0.2 0",
  choose:
    "choose :: Either Bumper Velocity -> Velocity\nchoose (Left _) = Velocity 0 0\nchoose (Right v) = v",
  event: "data Hit = Hit\n\ndetect :: Bumper -> Hit\ndetect _ = Hit",
  onHit: "onHit :: Hit -> Velocity\nonHit _ = Velocity (-0.2) 0",
  modeOnHit: "modeOnHit :: Hit -> Memory Bool\nmodeOnHit _ = Memory True",
  square: "square :: Task ()\nsquare = drive 50",
  list: "several :: Bumper -> [Led1]\nseveral _ = [Led1 Red, Led1 Green]",
}

/// What a name of the table is called in the program.
const called: {readonly [key: string]: string} = {
  unless: "unlessBlocked",
  even: "evenSecond",
  event: "detect",
  list: "several",
}

function program(names: string): string {
  const used = names.split(" ")
  const run = used.map(name => called[name] ?? name)
  const what = run.length === 1 ? run[0] : `(${run.join(", ")})`
  const text = used.map(name => definitions[name] ?? "").join("\n\n")
  return `${text}\n\nmain :: IO ()\nmain = simulate ${what}\n`
}

const conflictsOf = (text: string) =>
  commandConflicts(inferWorkspace(workspaceOf(openView(reader, text)))).map(
    ({command, winner, loser}) => `${winner.name} > ${loser.name} ${command}`,
  )

/// What `simulate` runs, and which function keeps winning over which.
const conflicting = [
  ["drive backOff", "drive > backOff Velocity"],
  ["backOff drive", "drive > backOff Velocity"],
  ["circle backOff", "circle > backOff Velocity"],
  ["drive bounce", "drive > bounce Velocity"],
  ["drive stopAtHole", "drive > stopAtHole Velocity"],
  ["drive lifted", "drive > lifted Velocity"],
  ["drive button", "drive > button Velocity"],
  ["drive left", "drive > left Velocity"],
  ["drive safety", "drive > safety Velocity"],
  ["drive bumpThere", "drive > bumpThere Velocity"],
  ["pulse backOff", "pulse > backOff Velocity"],
  ["accelerate backOff", "accelerate > backOff Velocity"],
  ["accelerate bounce", "accelerate > bounce Velocity"],
  ["accelerate stopAtHole", "accelerate > stopAtHole Velocity"],
  ["steer backOff", "steer > backOff Velocity"],
  ["home bounce", "home > bounce Velocity"],
  ["wander backOff", "wander > backOff Velocity"],
  ["timed backOff", "timed > backOff Velocity"],
  ["dice lifted", "dice > lifted Velocity"],
  ["pose button", "pose > button Velocity"],
  ["button pose", "pose > button Velocity"],
  ["drive circle", "circle > drive Velocity"],
  ["circle drive", "drive > circle Velocity"],
  ["drive accelerate", "accelerate > drive Velocity"],
  ["accelerate drive", "accelerate > drive Velocity"],
  ["steer accelerate", "accelerate > steer Velocity"],
  ["pulse drive", "drive > pulse Velocity"],
  ["sometimes accelerate", "accelerate > sometimes Velocity"],
  ["bounce flee", "flee > bounce Velocity"],
  ["backOff bounce", "bounce > backOff Velocity"],
  ["lamp bumpLamp", "lamp > bumpLamp Led1"],
  ["glow bumpLamp", "glow > bumpLamp Led1"],
  ["glow cliffLamp", "glow > cliffLamp Led1"],
  ["glow list", "glow > several Led1"],
  ["second bumpSecond", "second > bumpSecond Led2"],
  ["drive both", "drive > both Velocity"],
  ["shine bumpLamp", "shine > bumpLamp Led1"],
  ["byCount backOff", "byCount > backOff Velocity"],
  ["count byCount backOff", "byCount > backOff Velocity"],
  ["event onHit drive", "drive > onHit Velocity"],
  ["remember recall drive", "drive > recall Velocity"],
] as const

const peaceful = [
  "drive",
  "backOff",
  "accelerate",
  "square",
  "drive beepOn",
  "accelerate beepOn",
  "drive bumpLamp",
  "drive bumpLamp bumpSecond",
  "drive glow second",
  "hum beepOn",
  "talk shout",
  "backOff stopAtHole",
  "bounce lifted",
  "left right",
  "button backOff",
  "bounce button lifted",
  "bumpLamp cliffLamp",
  "both stopAtHole",
  "both cliffLamp",
  "remember recall",
  "remember recallNow",
  "remember recall beepOn",
  "rememberAndBack recall",
  "recall rememberAndBack",
  "rememberAndBack recallNow",
  "remember recall backOff",
  "remember recallNow backOff",
  "remember recall bounce",
  "remember unless backOff",
  "remember unless safety",
  "remember unless bounce",
  "unless safety",
  "count byCount",
  "count byCount button",
  "event onHit",
  "event onHit beepOn",
  "event modeOnHit recall",
  "event modeOnHit recall backOff",
  "event modeOnHit onHit recall",
  "even backOff",
  "even bounce",
  "even stopAtHole",
  "sometimes backOff",
  "sometimes bounce",
  "backOff sometimes",
  "accelerate sometimes",
  "steer sometimes",
  "home sometimes",
  "choose beepOn",
  "choose bumpLamp",
  "square beepOn",
  "square bumpLamp",
  "lamp bumpSecond",
  "glow bumpSecond",
  "list cliffLamp",
  "wander beepOn shout",
  "timed bumpLamp",
  "dice beepOn",
  "pose second",
  "safety button",
  "home lamp beepOn",
  "steer hum shout",
] as const

/// A function of a state runs with each odometry message, a constant at each tick; which state it is makes no difference (rules R2 and R3).
test.each([...states])("a function of %s keeps winning over a constant", state => {
  const text = `drive :: Velocity\ndrive = Velocity 0.2 0\n\nsteady :: ${state} -> Velocity\nsteady _ = Velocity 0.1 0`
  for (const pair of ["(drive, steady)", "(steady, drive)"])
    expect(conflictsOf(`${text}\n\nmain :: IO ()\nmain = simulate ${pair}\n`)).toEqual([
      "steady > drive Velocity",
    ])
})

test.each([...events])("a function of the event %s loses to a constant", event => {
  const text = `drive :: Velocity\ndrive = Velocity 0.2 0\n\nsteady :: ${event} -> Velocity\nsteady _ = Velocity 0.1 0`
  expect(conflictsOf(`${text}\n\nmain :: IO ()\nmain = simulate (drive, steady)\n`)).toEqual([
    "drive > steady Velocity",
  ])
})

test.each([...heldCommands])(
  "two functions of %s conflict, and the sentence names what they set",
  command => {
    const sends = (name: string) => `${name} :: Clock -> ${command}\n${name} clock = ${name} clock`
    const program = `${sends("one")}\n\n${sends("two")}\n\nmain :: IO ()\nmain = simulate (one, two)\n`
    const inferred = inferWorkspace(workspaceOf(openView(reader, program)))
    expect(conflictProblems(inferred).map(problem => problem.message)).toEqual(
      Array.from({length: 2}, () =>
        words.conflicts.bothSet("one", "two", words.actuators[command as "Velocity"]),
      ),
    )
  },
)

test("the table is as large as it says", () => {
  expect(conflicting.length).toBeGreaterThanOrEqual(40)
  expect(peaceful.length).toBeGreaterThanOrEqual(60)
  expect(new Set([...conflicting.map(([run]) => run), ...peaceful]).size).toBe(
    conflicting.length + peaceful.length,
  )
})

test.each(conflicting)("%s: %s", (run, expected) => {
  const text = program(run)
  expect(infer(workspaceOf(openView(reader, text))).problems.filter(p => p.severity === "error")).toEqual([])
  expect(conflictsOf(text)).toEqual([expected])
})

test.each(peaceful)("%s: no conflict", run => {
  const text = program(run)
  expect(infer(workspaceOf(openView(reader, text))).problems).toEqual([])
})

test("constants in simulate conflict as well, and both blocks are told", () => {
  const workspace = workspaceOf(
    openView(reader, `${definitions.backOff}\n\nmain :: IO ()\nmain = simulate (Velocity 0.2 0, backOff)\n`),
  )
  const problems = infer(workspace).problems
  expect(problems.map(p => [p.severity, p.kind, p.message])).toEqual(
    Array(2).fill([
      "warning",
      "conflict",
      "`backOff` and `Velocity` both set the velocity, and `Velocity` keeps winning.",
    ]),
  )
  expect(new Set(problems.map(p => p.block)).size).toBe(2)
})

test("an empty program and one that is not finished have no conflict", () => {
  expect(conflictsOf("main :: IO ()\nmain = simulate _\n")).toEqual([])
  expect(
    infer(openProject(newProject("empty")).workspace).problems.filter(p => p.kind === "conflict"),
  ).toEqual([])
})

/// The program after the way out, as the page rewrites it.
function resolved(text: string, names: ConflictNames): string {
  const fix = fixOf(text, names)
  return fix === undefined ? "" : `${text.slice(0, fix.start)}${fix.text}${text.slice(fix.end)}`
}

const fixOf = (text: string, names: ConflictNames) =>
  conflictFix(workspaceOf(openView(reader, text)), names, text, {
    start: text.indexOf("main ::"),
    end: text.length,
  })

/// The program whose functions are added up.
function merged(text: string, names: ConflictNames): string | undefined {
  const main = {start: text.indexOf("main ::"), end: text.length}
  const fix = conflictMerge(workspaceOf(openView(reader, text)), names, text, main)
  return fix?.edits
    .toSorted((one, other) => other.start - one.start)
    .reduce((now, {start, end, text: by}) => now.slice(0, start) + by + now.slice(end), text)
}

test.each([
  ["steer accelerate", true],
  ["accelerate drive", true],
  ["drive circle", true],
  ["glow recallNow timed", true],
  ["drive backOff", false],
  ["drive sometimes", false],
  ["glow bumpLamp", false],
])("the sum of what both want, where both are always asked: %s", (run, exists) => {
  const [loser = "", winner = ""] = run.split(" ").slice(-2)
  const command = run.startsWith("glow b") ? "Led1" : "Velocity"
  const text = merged(program(run), {command, winner, loser})
  expect(text !== undefined).toBe(exists)
  if (text === undefined) return
  expect(infer(workspaceOf(openView(reader, text))).problems, text).toEqual([])
  expect(lastLine(text)).toBe(`main = simulate (${run.startsWith("glow") ? "glow, " : ""}together)`)
})

test("the sum takes each input once", () => {
  const names = {command: "Velocity", winner: "accelerate", loser: "recallNow"}
  expect(
    merged(program("recallNow accelerate"), names),
  ).toContain(`together :: Memory Bool -> Velocity -> Velocity
together input1 input2 = Velocity (v1 + v2) (w1 + w2)
  where
    Velocity v1 w1 = recallNow input1 input2
    Velocity v2 w2 = accelerate input2

main ::`)
})

const lastLine = (text: string) => text.trimEnd().slice(text.trimEnd().lastIndexOf("\n") + 1)

describe("the way out", () => {
  test.each(conflicting)("of %s", run => {
    const workspace = workspaceOf(openView(reader, program(run)))
    const names = infer(workspace).problems.find(p => p.kind === "conflict")?.conflict
    if (names === undefined) throw new Error("expected a conflict")
    const text = resolved(program(run), names)
    expect(lastLine(text)).toContain(`priority 1 ${names.loser} ${names.winner}`)
    expect(infer(workspaceOf(openView(reader, text))).problems, text).toEqual([])
  })

  test.each([
    ["(drive, backOff)", "(priority 1 backOff drive)"],
    ["(backOff, beepOn, drive)", "(beepOn, priority 1 backOff drive)"],
    ["((drive, beepOn), backOff)", "(priority 1 backOff (drive, beepOn))"],
    ["((beepOn, drive), (hum, backOff))", "(priority 1 (hum, backOff) (beepOn, drive))"],
    ["(beepOn, (drive, backOff))", "(beepOn, (priority 1 backOff drive))"],
    ["(drive, priority 2 backOff button)", "(priority 1 (priority 2 backOff button) drive)"],
  ])("in simulate %s", (before, after) => {
    const text = (what: string) =>
      `${["drive", "backOff", "beepOn", "hum", "button"].map(name => definitions[name]).join("\n\n")}\n\nmain :: IO ()\nmain = simulate ${what}\n`
    const names = {command: "Velocity", winner: "drive", loser: "backOff"}
    const found = resolved(text(before), names)
    expect(lastLine(found)).toBe(`main = simulate ${after}`)
    expect(infer(workspaceOf(openView(reader, found))).problems).toEqual([])
  })

  test("needs both functions, and a conflict", () => {
    const names = {command: "Velocity", winner: "drive", loser: "nothing"}
    const workspace = workspaceOf(openView(reader, program("drive backOff")))
    expect(fixOf(program("drive backOff"), names)).toBeUndefined()
    expect(conflictShown(workspace, names)).toEqual([])
  })

  test("is none for functions that share a side", () => {
    const text = `${program("drive backOff stopAtHole").replace(/simulate .*/, "simulate (priority 1 stopAtHole (drive, backOff))")}`
    expect(conflictsOf(text)).toEqual(["drive > backOff Velocity"])
  })
})

describe("what a run has shown", () => {
  const shown = (run: string, winner: string, loser: string) =>
    conflictShown(workspaceOf(openView(reader, program(run))), {command: "Velocity", winner, loser})

  test("is said on both blocks, also when the types cannot tell", () => {
    const problems = shown("even backOff", "evenSecond", "backOff")
    expect(problems.map(p => [p.severity, p.message])).toEqual(
      Array(2).fill([
        "warning",
        "`backOff` and `evenSecond` both set the velocity, and `evenSecond` keeps winning.",
      ]),
    )
    expect(new Set(problems.map(p => p.block)).size).toBe(2)
  })

  test("is no conflict in the example whose winner reads what the loser's events have written", () => {
    const project = parseProject(readFileSync(new URL("safetyControl/program.rosy", examples), "utf8"))
    if (!project.ok) throw new Error("expected the example to open")
    const workspace = workspaceOf(openView(reader, project.project.haskell))
    // sim-service/tests/system/test_examples.py finds this pair in runs.
    for (const [winner, loser] of [
      ["cruise", "safetyControl"],
      ["safetyControl", "cruise"],
    ] as const)
      expect(conflictShown(workspace, {command: "Velocity", winner, loser})).toEqual([])
  })

  test("is no conflict when one of them knows of the other", () => {
    expect(shown("remember recall bounce", "recall", "bounce")).toEqual([])
    expect(shown("remember recall bounce", "bounce", "recall")).toEqual([])
  })
})

describe("no false alarm", () => {
  const names = readdirSync(examples).filter(name => existsSync(new URL(`${name}/program.rosy`, examples)))
  test.each(names)("example %s", name => {
    const outcome = parseProject(readFileSync(new URL(`${name}/program.rosy`, examples), "utf8"))
    expect(outcome.ok).toBe(true)
    if (outcome.ok) expect(conflictsOf(outcome.project.haskell)).toEqual([])
  })
})

describe("no false alarm in lessons", () => {
  const lessons = new URL("lessons/", examples)
  const programs = readdirSync(lessons).flatMap(lesson => {
    if (!existsSync(new URL(`${lesson}/lesson.json`, lessons))) return []
    const solutions = readdirSync(new URL(`${lesson}/solutions/`, lessons), {recursive: true})
      .map(name => `solutions/${name}`)
      .filter(name => name.endsWith(".hs"))
    return ["start.hs", ...solutions].map(name => `${lesson}/${name}`)
  })
  // In these steps a conflict is seen before it is solved.
  const wanted: Readonly<Record<string, readonly string[]>> = {
    "two-wills/start.hs": ["go > back Velocity"],
    "wire-a-reflex/solutions/reflex/reference.hs": ["go > backOff Velocity"],
    "wire-a-reflex/solutions/reflex/two-answers.hs": ["go > shine Velocity"],
  }
  test("there are lessons", () => expect(programs.length).toBeGreaterThan(30))
  test.each(programs)("%s", program =>
    expect(conflictsOf(readFileSync(new URL(program, lessons), "utf8"))).toEqual(wanted[program] ?? []),
  )
})

test("what is found in the corpus", () => {
  const found = corpus.flatMap(({name, text}) => conflictsOf(text).map(conflict => `${name}: ${conflict}`))
  expect(found).toMatchInlineSnapshot(`[]`)
})
