/// A language of a dozen blocks for the tests of the block view: shapes like codegen's, types that are single words.
///
/// It stands in for codegen where a test is about the view and must not change when the vocabulary grows.

import {
  type BlockProblem,
  type BlockView,
  type Checker,
  type Extra,
  type Family,
  type Inference,
  type InScope,
  type Item,
  type Place,
  type Reference,
  type SavedBlock,
  type SavedWorkspace,
  type Shape,
  setIn,
  socketKey,
  type TypeInfo,
} from "@rosy/codegen"
import type {Language} from "../../src/views/blocks/construction/language.ts"

const label = (text: string, strong = false): Item => ({kind: "label", text, strong})
const socket = (name: string, hint: string, sort: "expression" | "pattern" = "expression"): Item => ({
  kind: "socket",
  name,
  sort,
  aria: `${hint} goes here`,
  hint,
})
const text = (extra: Extra, key: string, otherwise: string) => String(extra[key] ?? otherwise)

function block(
  type: string,
  shape: (extra: Extra) => Omit<Shape, "tooltip" | "aria">,
  press?: BlockView["press"],
): BlockView {
  return {
    type,
    shape: extra => ({tooltip: `What ${type} does, with an example.`, aria: type, ...shape(extra)}),
    press: press ?? (extra => extra),
  }
}

const count = (extra: Extra, least: number) => Number(extra.count ?? least)

const views: readonly BlockView[] = [
  block("function", extra => ({
    family: "own",
    connects: {as: "definition"},
    rows: [
      [
        {kind: "binder", key: "name", value: text(extra, "name", "f"), aria: "name of the function"},
        {kind: "signature", key: "signature", value: "", aria: "type"},
      ],
      [label("when it has"), socket("P0", "what", "pattern")],
      [label("send"), socket("E0", "what")],
    ],
  })),
  block(
    "main",
    extra => ({
      family: "task",
      connects: {as: "definition"},
      rows: [
        [label("simulate", true)],
        [
          ...Array.from({length: count(extra, 1)}, (_, at) => [
            ...(at === 0 ? [] : [label("and")]),
            socket(`C${at}`, "function"),
          ]).flat(),
          {kind: "button", action: "more", text: "+", aria: "one more"},
          ...(count(extra, 1) > 1
            ? [{kind: "button", action: "less", text: "−", aria: "one less"} as const]
            : []),
        ],
      ],
    }),
    (extra, action) => setIn(extra, "count", count(extra, 1) + (action === "more" ? 1 : -1)),
  ),
  block("velocity_pattern", extra => ({
    family: "state",
    connects: {as: "pattern"},
    rows: [
      [
        label("Velocity"),
        {kind: "binder", key: "vl", value: text(extra, "vl", "vl"), aria: "linear"},
        {kind: "binder", key: "va", value: text(extra, "va", "va"), aria: "angular"},
      ],
    ],
  })),
  block("bumper_pattern", extra => ({
    family: "event",
    connects: {as: "pattern"},
    rows: [
      [
        label("Bumper"),
        label("any side"),
        {
          kind: "menu",
          key: "status",
          value: text(extra, "status", "Pressed"),
          options: [
            ["Pressed", "Pressed"],
            ["Released", "Released"],
          ],
          aria: "status",
        },
      ],
    ],
  })),
  block("velocity", () => ({
    family: "command",
    connects: {as: "expression"},
    rows: [[label("Velocity"), socket("L", "metres a second"), socket("A", "turn")]],
  })),
  block("number", extra => ({
    family: "number",
    connects: {as: "expression"},
    rows: [[{kind: "number", key: "value", value: text(extra, "value", "0"), aria: "number"}]],
  })),
  block("plus", () => ({
    family: "number",
    connects: {as: "expression"},
    rows: [[socket("L", "number"), label("+"), socket("R", "number")]],
  })),
  block("name", extra => ({
    family: "own",
    connects: {as: "expression"},
    rows: [[{kind: "reference", key: "name", value: text(extra, "name", "x"), aria: "name"}]],
  })),
  block("just", () => ({
    family: "memory",
    connects: {as: "expression"},
    rows: [[label("just"), socket("V", "what")]],
  })),
  block("nothing", () => ({family: "memory", connects: {as: "expression"}, rows: [[label("nothing")]]})),
  block("sound", extra => ({
    family: "command",
    connects: {as: "expression"},
    rows: [
      [
        label("Sound"),
        {
          kind: "menu",
          key: "sound",
          value: text(extra, "sound", "ErrorSound"),
          options: [
            ["ErrorSound", "ErrorSound"],
            ["OnSound", "OnSound"],
          ],
          aria: "sound",
        },
      ],
    ],
  })),
  block("led", () => ({family: "command", connects: {as: "expression"}, rows: [[label("Led1 Orange")]]})),
  block("true", () => ({family: "choice", connects: {as: "expression"}, rows: [[label("True")]]})),
  block("do", () => ({
    family: "task",
    connects: {as: "expression"},
    rows: [[label("do")], [{kind: "stack", name: "S", sort: "step", aria: "steps"}]],
  })),
  block("wait", () => ({
    family: "task",
    connects: {as: "step"},
    rows: [[label("wait"), socket("T", "seconds")]],
  })),
]

const makes: Readonly<Record<string, string>> = {
  velocity: "Velocity",
  number: "Double",
  plus: "Double",
  sound: "Sound",
  led: "Led1",
  just: "Maybe",
  nothing: "Maybe",
  true: "Bool",
  velocity_pattern: "Velocity",
  bumper_pattern: "Bumper",
}
const wants: Readonly<Record<string, string>> = {
  "velocity/L": "Double",
  "velocity/A": "Double",
  "plus/L": "Double",
  "plus/R": "Double",
  "wait/T": "Double",
}
const familyOf: Readonly<Record<string, Family>> = {
  Velocity: "command",
  Double: "number",
  Sound: "command",
  Led1: "command",
  Maybe: "memory",
  Bool: "choice",
  Bumper: "event",
}

export function* blocksOf(workspace: SavedWorkspace): Generator<SavedBlock> {
  function* within(block: SavedBlock): Generator<SavedBlock> {
    yield block
    for (const input of Object.values(block.inputs ?? {}))
      if (input.block !== undefined) yield* within(input.block)
    if (block.next?.block !== undefined) yield* within(block.next.block)
  }
  for (const top of workspace.blocks.blocks) yield* within(top)
}

function infer(workspace: SavedWorkspace): Inference {
  const blocks = new Map<string, TypeInfo>()
  const sockets = new Map<string, TypeInfo>()
  const problems: BlockProblem[] = []
  const definitions = new Map<string, {name: string; type: string; family: Family}>()
  for (const block of blocksOf(workspace)) {
    const id = block.id ?? ""
    const type = makes[block.type] ?? (block.type === "name" ? "Double" : undefined)
    if (type !== undefined) {
      const family = block.type === "velocity_pattern" ? "state" : familyOf[type]!
      blocks.set(id, {type, family})
    }
    for (const name of ["L", "R", "A", "V", "E0", "P0", "T"]) {
      const wanted = wants[`${block.type}/${name}`]
      if (wanted !== undefined) sockets.set(socketKey(id, name), {type: wanted, family: familyOf[wanted]!})
    }
    if (block.type === "function") {
      const from = block.inputs?.P0?.block?.type
      const family = from === "velocity_pattern" ? "state" : from === "bumper_pattern" ? "event" : "own"
      const to = makes[block.inputs?.E0?.block?.type ?? ""] ?? "a"
      definitions.set(id, {
        name: String(block.extraState?.name ?? "f"),
        type: `${makes[from ?? ""] ?? "a"} -> ${to}`,
        family,
      })
      if (block.inputs?.E0?.block === undefined) {
        problems.push({
          severity: "error",
          kind: "hole",
          block: id,
          input: "E0",
          message: "Something is missing here.",
          hint: "",
        })
      }
    }
  }
  return {blocks, sockets, definitions, problems, stamps: new Map()}
}

function checker(workspace: SavedWorkspace): Checker {
  const all = new Map([...blocksOf(workspace)].map(block => [block.id, block]))
  return {
    fits(place: Place, moved) {
      const block = typeof moved === "string" ? all.get(moved) : moved
      if ("below" in place) return {fits: true}
      const parent = all.get(place.block)
      const wanted = wants[`${parent?.type}/${place.input}`]
      const made = makes[block?.type ?? ""]
      if (wanted === undefined || made === undefined || wanted === made) return {fits: true}
      return {fits: false, why: `This socket wants a \`${wanted}\`, and this is a \`${made}\`.`}
    },
  }
}

function referenceTo(workspace: SavedWorkspace, place: Place, definition: SavedBlock | string): Reference {
  const block =
    typeof definition === "string" ? [...blocksOf(workspace)].find(({id}) => id === definition) : definition
  const name = block?.extraState?.name
  if (block?.type !== "function" || typeof name !== "string" || "below" in place)
    return {fits: false, why: "Only a function leaves its name here."}
  return {fits: true, block: {type: "name", extraState: {name}}}
}

function namesInScope(): readonly InScope[] {
  return ["vl", "va"].map(name => ({
    name,
    type: "Double",
    family: "number" as const,
    block: {type: "name", extraState: {name}},
    fits: true,
  }))
}

export const small: Language = {
  blockTypes: views,
  infer,
  session: () => ({infer, checker, namesInScope, referenceTo, overriddenReaction: () => undefined}),
  rename(workspace, block, key, name) {
    if (!/^[a-z]\w*$/.test(name)) return {ok: false, why: "A name is one word with a small letter first."}
    const all = [...blocksOf(workspace)]
    const old = all.find(found => found.id === block)?.extraState?.[key]
    const changes = all
      .filter(found => found.id === block || (found.type === "name" && found.extraState?.name === old))
      .map(found => ({
        block: found.id!,
        extra: setIn(found.extraState ?? {}, found.id === block ? key : "name", name),
      }))
    return {ok: true, changes}
  },
  libraryItems: () => [],
  withOnlyEvent: block => block,
  lookInside: () => undefined,
  ownDefinition: () => undefined,
  typedItems: () => [],
  toolbox() {
    return [
      {
        name: "When it senses",
        family: "event",
        items: [{label: "when bumper pressed", block: {type: "bumper_pattern"}}],
      },
      {
        name: "Tell the robot",
        family: "command",
        items: [
          {
            label: "velocity drive speed",
            block: {
              type: "velocity",
              inputs: {
                L: {block: {type: "number", extraState: {value: "0.5"}}},
                A: {block: {type: "number", extraState: {value: "0"}}},
              },
            },
          },
          {label: "sound play", block: {type: "sound"}},
          {label: "light led", block: {type: "led"}},
        ],
      },
      {
        name: "Memory",
        family: "memory",
        items: [
          {label: "just", block: {type: "just"}},
          {label: "nothing", block: {type: "nothing"}},
        ],
      },
      {
        name: "Tasks",
        family: "task",
        items: [
          {label: "do steps", block: {type: "do"}},
          {label: "wait", block: {type: "wait"}},
        ],
      },
      {
        name: "Numbers",
        family: "number",
        items: [
          {label: "number", block: {type: "number"}},
          {label: "plus add", block: {type: "plus"}},
        ],
      },
      {name: "Choices", family: "choice", items: [{label: "true", block: {type: "true"}}]},
      {name: "Functions", family: "own", items: [{label: "function", block: {type: "function"}}]},
    ]
  },
}

/// accelerateAndPlay, as far as the small language goes, with a light that belongs nowhere.
export const sample: SavedWorkspace = {
  blocks: {
    languageVersion: 0,
    blocks: [
      {
        type: "function",
        id: "accelerate",
        x: 40,
        y: 40,
        extraState: {name: "accelerate"},
        inputs: {
          P0: {block: {type: "velocity_pattern", id: "pattern", extraState: {vl: "vl", va: "va"}}},
          E0: {
            block: {
              type: "velocity",
              id: "velocity",
              inputs: {
                L: {
                  block: {
                    type: "plus",
                    id: "plus",
                    inputs: {
                      L: {block: {type: "name", id: "ref", extraState: {name: "vl"}}},
                      R: {block: {type: "number", id: "half", extraState: {value: "0.5"}}},
                    },
                  },
                },
                A: {block: {type: "name", id: "ref2", extraState: {name: "va"}}},
              },
            },
          },
        },
      },
      {
        type: "function",
        id: "play",
        x: 40,
        y: 220,
        extraState: {name: "play"},
        inputs: {
          P0: {block: {type: "bumper_pattern", id: "bumper"}},
          E0: {block: {type: "just", id: "just", inputs: {V: {block: {type: "sound", id: "sound"}}}}},
        },
      },
      {
        type: "main",
        id: "main",
        x: 40,
        y: 390,
        extraState: {count: 2},
        inputs: {
          C0: {block: {type: "name", id: "c0", extraState: {name: "accelerate"}}},
          C1: {block: {type: "name", id: "c1", extraState: {name: "play"}}},
        },
      },
      {type: "led", id: "led", x: 330, y: 500},
      {type: "nothing", id: "nothing", x: 330, y: 560},
      {type: "true", id: "true", x: 480, y: 560},
      {type: "velocity", id: "empty", x: 330, y: 610},
      {
        type: "do",
        id: "do",
        x: 40,
        y: 500,
        inputs: {S: {block: {type: "wait", id: "wait", next: {block: {type: "wait", id: "wait2"}}}}},
      },
    ],
  },
}
