/// Every ready-made piece works as it is: with its name in `simulate` it is a whole program that GHC and hlint have
/// nothing to say about, and it is found by the words that a learner would look for.

import {spawnSync} from "node:child_process"
import {mkdtempSync, rmSync, writeFileSync} from "node:fs"
import {tmpdir} from "node:os"
import {join} from "node:path"
import {expect, test} from "vitest"
import {table as de} from "../../languages/de/blocks/index.ts"
import {en} from "../../languages/en/blocks/index.ts"
import {table as es} from "../../languages/es/blocks/index.ts"
import {table as fr} from "../../languages/fr/blocks/index.ts"
import {table as pt} from "../../languages/pt/blocks/index.ts"
import {packageDatabase} from "../scripts/ghc.ts"
import {readWorkspace} from "../src/blocks/block_reader.ts"
import {speak} from "../src/words/index.ts"
import {toHaskell} from "../src/workspace/inference/code_generation.ts"
import {plug} from "../src/workspace/moves/block_moves.ts"
import {newWorkspace} from "../src/workspace/project_file.ts"
import {readyReactions, readyTasks} from "../src/workspace/toolbox/ready_made_definitions.ts"
import {toolbox} from "../src/workspace/toolbox/toolbox.ts"
import {libraryItems} from "../src/workspace/toolbox/toolbox_search.ts"
import {compileAll} from "./ghc.ts"
import {run} from "./process.ts"

const database = packageDatabase()
const hlint = spawnSync("hlint", ["--version"]).status === 0

/// The piece on a fresh workspace, with its name in `simulate`.
const programs = [...readyReactions(), ...readyTasks()].map(({label, block}) => {
  const name = String(block.extraState?.name)
  const fresh = newWorkspace()
  const [main] = fresh.blocks.blocks
  const reference = {type: "name", id: "used", extraState: {name, args: 0}}
  const whole = plug(fresh, {block: main?.id ?? "", input: "R0"}, reference)
  const piece = {...block, id: "piece"}
  const workspace = {...whole, blocks: {...whole.blocks, blocks: [piece, ...whole.blocks.blocks]}}
  return {label, name, program: readWorkspace(workspace).program, ...toHaskell(workspace)}
})

test("pieces have names and labels of their own", () => {
  expect(new Set(programs.map(p => p.name)).size).toBe(programs.length)
  expect(new Set(programs.map(p => p.label)).size).toBe(programs.length)
})

test.each(programs)("$label has no problem, and reads so", ({problems, text, name}) => {
  expect(problems).toEqual([])
  expect(text).toContain(`main = simulate ${name}`)
  expect(text).toMatchSnapshot()
})

// What the test itself writes above a program is not what is looked at.
test.skipIf(database === undefined)("GHC compiles them all, without a warning", async () => {
  const candidates = programs.map(({name, program, text}) => ({
    name: `Ready${name}`,
    program,
    text,
  }))
  expect(
    Object.fromEntries(
      await compileAll(database ?? "", candidates, [
        "-Wall",
        "-Werror",
        "-Wno-dodgy-imports",
        "-Wno-unused-imports",
        // Where a drive ended is a result that a step may leave unused.
        "-Wno-unused-do-bind",
      ]),
    ),
  ).toEqual({})
})

/// Every definition of the toolbox in an empty program, each once.
const dropped = new Map(
  (["tasks", "reactions", "haskell"] as const)
    .flatMap(level => toolbox(level).flatMap(category => category.items))
    .filter(({block}) => block.type === "define")
    .map(({label, block}) => {
      const fresh = newWorkspace()
      const blocks = [{...block, id: "piece"}, ...fresh.blocks.blocks]
      const workspace = {...fresh, blocks: {...fresh.blocks, blocks}}
      const {text} = toHaskell(workspace)
      return [text, {label, text, program: readWorkspace(workspace).program}] as const
    }),
)

// What is still to be filled in is an error for a run only. A match that lacks a case would end the run.
test.skipIf(database === undefined)("every definition has a case for each input as it is", async () => {
  const candidates = [...dropped.values()].map((one, i) => ({...one, name: `Dropped${i}`}))
  expect(candidates.length).toBeGreaterThan(30)
  const complaints = await compileAll(database ?? "", candidates, [
    "-fdefer-type-errors",
    "-fno-show-valid-hole-fits",
    "-Werror=incomplete-patterns",
    "-Werror=incomplete-uni-patterns",
  ])
  const named = candidates.map(({label, name}) => [label, complaints.get(name) ?? ""] as const)
  expect(Object.fromEntries(named.filter(([, complaint]) => complaint !== ""))).toEqual({})
  expect(complaints.get("") ?? "").toBe("")
})

test.skipIf(!hlint)("hlint has no hint about them", async () => {
  const folder = mkdtempSync(join(tmpdir(), "rosy-ready-"))
  try {
    for (const {name, text} of programs) writeFileSync(join(folder, `${name}.hs`), text)
    expect((await run("hlint", [folder])).stdout.trim()).toBe("No hints")
  } finally {
    rmSync(folder, {recursive: true, force: true})
  }
})

test("every level offers them first or last, and none hides one", () => {
  const labels = programs.map(p => p.label).sort()
  for (const level of ["tasks", "reactions", "haskell"] as const) {
    const found = toolbox(level).flatMap(category => category.items.map(item => item.label))
    expect(found.filter(label => labels.includes(label)).sort()).toEqual(labels)
  }
})

/// What is typed, and a block that must be among what is found.
const looked = [
  ["speed", "Velocity"],
  ["light", "Led1"],
  ["forever", "step_forever"],
  ["wall", "Bumper"],
  ["loop", "step_repeat"],
  ["colour", "LedColor"],
  ["time", "Clock"],
  ["variable", "Memory"],
  ["noise", "Sound"],
] as const

const robotWords = {
  en: [
    ["forward", "step_drive"],
    ["turn", "step_turn"],
    ["left", "step_turn"],
    ["stop", "Velocity"],
    ["cm", "step_drive"],
    ["wall", "Bumper"],
    ["until", "step_drive_until_bump"],
    ["random", "randomR"],
    ["wait", "step_wait"],
    ["blink", "step_blink"],
    ["beep", "step_beep"],
    ["degrees", "step_turn"],
    ["place", "step_go_to"],
    ["target", "goToPlace"],
    ["edge", "stopAtEdge"],
    ["follow", "followWall"],
    ["along", "followWall"],
    ["table", "stopAtEdge"],
    ["cliff", "stopAtEdge"],
    ["pen", "step_pen_down"],
    ["draw", "step_pen_down"],
    ["turtle", "step_pen_up"],
    ["ink", "step_pen_color"],
    ["thick", "step_pen_width"],
    ["line", "followLine"],
  ],
  de: [
    ["vorwärts", "step_drive"],
    ["drehe", "step_turn"],
    ["links", "step_turn"],
    ["stopp", "Velocity"],
    ["cm", "step_drive"],
    ["wand", "Bumper"],
    ["bis", "step_drive_until_bump"],
    ["zufall", "randomR"],
    ["warte", "step_wait"],
    ["blinke", "step_blink"],
    ["piepe", "step_beep"],
    ["grad", "step_turn"],
    ["ort", "step_go_to"],
    ["ziel", "goToPlace"],
    ["kante", "stopAtEdge"],
    ["entlang", "followWall"],
    ["tisch", "stopAtEdge"],
    ["abgrund", "stopAtEdge"],
    ["stift", "step_pen_down"],
    ["zeichnen", "step_pen_down"],
    ["malen", "step_pen_color"],
    ["dick", "step_pen_width"],
    ["linie", "followLine"],
  ],
  pt: [
    ["frente", "step_drive"],
    ["gire", "step_turn"],
    ["esquerda", "step_turn"],
    ["pare", "Velocity"],
    ["cm", "step_drive"],
    ["parede", "Bumper"],
    ["até", "step_drive_until_bump"],
    ["aleatório", "randomR"],
    ["espere", "step_wait"],
    ["pisque", "step_blink"],
    ["apite", "step_beep"],
    ["graus", "step_turn"],
    ["lugar", "step_go_to"],
    ["alvo", "goToPlace"],
    ["beira", "stopAtEdge"],
    ["seguir", "followWall"],
    ["mesa", "stopAtEdge"],
    ["caneta", "step_pen_down"],
    ["desenhar", "step_pen_down"],
    ["tinta", "step_pen_color"],
    ["linha", "followLine"],
  ],
  es: [
    ["adelante", "step_drive"],
    ["girar", "step_turn"],
    ["izquierda", "step_turn"],
    ["detener", "Velocity"],
    ["parar", "Velocity"],
    ["cm", "step_drive"],
    ["pared", "Bumper"],
    ["obstáculo", "Bumper"],
    ["hasta", "step_drive_until_bump"],
    ["azar", "randomR"],
    ["esperar", "step_wait"],
    ["parpadear", "step_blink"],
    ["pitar", "step_beep"],
    ["grados", "step_turn"],
    ["lugar", "step_go_to"],
    ["meta", "goToPlace"],
    ["borde", "stopAtEdge"],
    ["seguir", "followWall"],
    ["mesa", "stopAtEdge"],
    ["lápiz", "step_pen_down"],
    ["dibujar", "step_pen_down"],
    ["tinta", "step_pen_color"],
    ["línea", "followLine"],
  ],
  fr: [
    ["avancer", "step_drive"],
    ["reculer", "step_drive_back"],
    ["tourner", "step_turn"],
    ["gauche", "step_turn"],
    ["arrêter", "Velocity"],
    ["cm", "step_drive"],
    ["mur", "Bumper"],
    ["jusqu", "step_drive_until_bump"],
    ["hasard", "randomR"],
    ["attendre", "step_wait"],
    ["clignoter", "step_blink"],
    ["biper", "step_beep"],
    ["degré", "step_turn"],
    ["endroit", "step_go_to"],
    ["cible", "goToPlace"],
    ["bord", "stopAtEdge"],
    ["longer", "followWall"],
    ["table", "stopAtEdge"],
    ["stylo", "step_pen_down"],
    ["dessiner", "step_pen_down"],
    ["encre", "step_pen_color"],
    ["ligne", "followLine"],
  ],
} as const

test.each([
  ["en", en, robotWords.en],
  ["de", de, robotWords.de],
  ["pt", pt, robotWords.pt],
  ["es", es, robotWords.es],
  ["fr", fr, robotWords.fr],
] as const)("the search understands robot words in %s", (_, table, asked) => {
  speak(table)
  try {
    const items = [...toolbox("reactions").flatMap(category => category.items), ...libraryItems()]
    for (const [word, about] of asked) {
      const found = items.filter(({label, also}) => `${label} ${also ?? ""}`.toLowerCase().includes(word))
      expect(JSON.stringify(found.map(item => item.block)), word).toContain(`"${about}"`)
    }
  } finally {
    speak(en)
  }
})

test.each(looked)("%s finds %s", (word, about) => {
  const items = [...toolbox("haskell").flatMap(category => category.items), ...libraryItems()]
  const found = items.filter(({label, also}) => `${label} ${also ?? ""}`.toLowerCase().includes(word))
  expect(JSON.stringify(found.map(item => item.block))).toContain(`"${about}"`)
})
