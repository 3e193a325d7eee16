/// Hints: about the check that the last run missed, nothing that is done already, and functions that nothing uses.

import {describe, expect, test} from "vitest"
import {hintedChecks, hintsOf, isInProgram, unusedFunctions} from "../../src/features/lessons/hints.ts"
import type {Check} from "../../src/lesson_files/lesson.ts"
import type {LessonChecks} from "../../src/state/messages/messages.ts"
import type {Verdict} from "../../src/wire/verdict.generated.ts"

const checks: readonly Check[] = [
  {id: "takes", text: "It takes a `Cliff`", hints: ["Which function?", "", "cliff :: Cliff -> Stop"]},
  {id: "stays", text: "It stays up", hints: ["Is it fast?", "Look at go."]},
]
const told = (run: number | null, ...states: readonly Verdict["state"][]): LessonChecks => ({
  run,
  passed: false,
  over: true,
  checks: states.map((state, i) => ({id: checks[i]?.id ?? "", state, seen: null})),
})
const text = `cliff :: Cliff -> Stop
cliff _ = Stop

go = Velocity 0.2 0

main = simulate go
`
const program = {text: "main = simulate ()\n", declared: []}
const texts = (found: ReturnType<typeof hintsOf>) =>
  found?.hints.map(hint => ("text" in hint ? hint.text : hint))

describe("hints", () => {
  test("are about the first check that is open, and about one that a run has missed before it", () => {
    expect(hintsOf(checks, null, program)?.check).toBe("takes")
    expect(hintsOf(checks, told(null, "open", "missed"), program)?.check).toBe("takes")
    expect(hintsOf(checks, told(1, "open", "missed"), program)?.check).toBe("stays")
    expect(hintsOf(checks, told(1, "done", "open"), program)?.check).toBe("stays")
    expect(hintsOf(checks, told(1, "done", "done"), program)).toBe(null)
  })

  test("leave out a piece that the program has already", () => {
    expect(texts(hintsOf(checks, null, program))).toEqual(["Which function?", "cliff :: Cliff -> Stop"])
    expect(texts(hintsOf(checks, null, {...program, text}))).toEqual(["Which function?"])
  })

  test("begin, after a run, with a function that nothing uses", () => {
    const declared = [
      {name: "cliff", type: "Cliff -> Stop"},
      {name: "main", type: "IO ()"},
    ]
    const [first] = hintsOf(checks, told(1, "missed"), {text, declared})?.hints ?? []
    expect(first).toEqual({kind: "not-run", name: "cliff"})
    expect(texts(hintsOf(checks, null, {text, declared}))).toEqual(["Which function?"])
  })
})

describe("a type that the check needs", () => {
  const watched = hintedChecks([
    {kind: "function", id: "takes", takes: ["Cliff"], gives: ["Stop"]},
    {kind: "answers", id: "stays", event: "Bumper _ Pressed", command: "Led1 Red"},
    {kind: "at", id: "there", time: 5, goal: 0},
    "no check",
  ])
  const hint = (state: Verdict["state"], own: string, types: readonly string[] = []) =>
    texts(
      hintsOf(
        checks,
        told(null, state, "open"),
        {text: own, declared: types.map(type => ({name: "f", type}))},
        watched,
      ),
    )?.filter(found => typeof found !== "string")

  test("is named behind the question while the program lacks it, what is taken before what is given", () => {
    expect(texts(hintsOf(checks, null, program, watched))).toEqual([
      "Which function?",
      {kind: "not-taken", type: "Cliff"},
      "cliff :: Cliff -> Stop",
    ])
    expect(hint("open", "f x = x", ["Cliff -> Int"])).toEqual([{kind: "not-given", type: "Stop"}])
    expect(hint("done", "f _ = ()")).toEqual([{kind: "not-taken", type: "Bumper"}])
  })

  test("is not named when a type, a pattern or a task has it", () => {
    expect(hint("open", "f x = x", ["Cliff -> Stop"])).toEqual([])
    expect(hint("done", "light (Bumper _ Pressed) = Led1 Red")).toEqual([])
    expect(hint("done", "main = simulate (do wait 1 >> f)", ["Bumper -> Done ()"])).toEqual([])
    expect(hint("done", "-- Bumper and Led1\nf = 1")).toEqual([{kind: "not-taken", type: "Bumper"}])
  })
})

test("a piece is in a program when all its lines are, whatever the spaces", () => {
  expect(isInProgram("cliff  ::Cliff -> Stop\ncliff _ = Stop", text)).toBe(true)
  expect(isInProgram("cliff _ = Stop\nmain = simulate cliff", text)).toBe(false)
})

test("a function is used by another definition, not by its own and not by a comment", () => {
  const of = (...names: readonly string[]) => names.map(name => ({name, type: "Int -> Int"}))
  const loop =
    "-- half is not used\nhalf n = half (n - 1)\n\ntwice n = n\n\ntwice' n = twice n\n\nmain = f twice'\n"
  expect(unusedFunctions({text: loop, declared: of("half", "twice", "twice'")})).toEqual(["half"])
  expect(unusedFunctions({text, declared: [{name: "go", type: "Velocity"}]})).toEqual([])
})
