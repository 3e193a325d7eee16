/// What the toolbox offers: ready blocks, with the sockets filled where a newcomer would have to search.
///
/// Three levels filter and order; none locks anything: text and saved programs may hold every block at every level.

import type {Level, ToolboxCategory, ToolboxItem} from "../api.ts"
import {choiceOf, choices, lookOf} from "../blocks/vocabulary.ts"
import {isNumberLiteral, isOperator, isVariableName, reservedWords} from "../haskell/lexemes.ts"
import type {Extra, SavedBlock} from "../saved.ts"
import {library} from "../types/library.ts"
import {asFunction, type Type} from "../types/type.ts"

function make(
  type: string,
  extra: Extra = {},
  sockets: {readonly [name: string]: SavedBlock} = {},
): SavedBlock {
  return {
    type,
    ...(Object.keys(extra).length > 0 ? {extraState: extra} : {}),
    ...(Object.keys(sockets).length > 0
      ? {inputs: Object.fromEntries(Object.entries(sockets).map(([name, block]) => [name, {block}]))}
      : {}),
  }
}

const num = (value: string) => make("number", {value})
const text = (value: string) => make("text", {value})
const ref = (name: string) => make("name", {name, args: 0})
const named = (name: string) => make("pattern_name", {name})
const anything = (what: string) => make("pattern_any", {what})
const pick = (of: string, value: string) => make("choice", {of, value})
const match = (of: string, value: string) => make("pattern_choice", {of, value})
const numbered = (blocks: readonly SavedBlock[], letter: string) =>
  Object.fromEntries(blocks.map((b, i) => [`${letter}${i}`, b]))
const con = (name: string, ...args: readonly SavedBlock[]) =>
  make("construct", {con: name, args: Math.max(args.length, lookOf(name).parts.length)}, numbered(args, "A"))
const pat = (name: string, ...args: readonly SavedBlock[]) =>
  make(
    "pattern_construct",
    {con: name, args: Math.max(args.length, lookOf(name).parts.length)},
    numbered(args, "A"),
  )
const call = (name: string, count: number, ...args: readonly SavedBlock[]) =>
  make("name", {name, args: count, fn: true}, numbered(args, "A"))
const infix = (op: string, left?: SavedBlock, right?: SavedBlock) =>
  make("infix", {op}, {...(left === undefined ? {} : {L: left}), ...(right === undefined ? {} : {R: right})})
const item = (label: string, block: SavedBlock): ToolboxItem => ({label, block})

/// Every other name that a program knows without defining it, for the search: it finds all of Haskell at every level.
export function libraryItems(): ToolboxItem[] {
  const values = [...library.values].flatMap(([name, scheme]): ToolboxItem[] => {
    const count = inputsOf(scheme.type)
    if (!isOperator(name) && count === 0) return [item(name, ref(name))]
    if (!isOperator(name)) {
      const itself = make("name", {name, args: 0, fn: true})
      return [item(name, call(name, count)), item(`${name} as a function`, itself)]
    }
    return count === 2 ? [item(name, infix(name))] : []
  })
  const constructors = [...library.constructors.values()].flatMap((info): ToolboxItem[] => {
    if (!/^[A-Z]/.test(info.name) || choiceOf(info.name) !== undefined) return []
    const extra = {con: info.name, args: info.fields.length}
    return [
      item(info.name, make("construct", extra)),
      item(`${info.name} pattern`, make("pattern_construct", extra)),
      ...(info.fields.length === 0
        ? []
        : [item(`${info.name} as a function`, make("construct", {con: info.name, args: 0}))]),
    ]
  })
  return [...values, ...constructors]
}

/// What was typed into the search as a block of its own: a number, a text in quotes, a new name.
export function typedItems(typed: string): ToolboxItem[] {
  const query = typed.trim()
  const number = query.replace(",", ".")
  if (isNumberLiteral(number.replace(/^-/, ""))) {
    return [item(number, num(number)), item(number, make("pattern_number", {value: number}))]
  }
  const quoted = /^["“](.+?)["”]?$/.exec(query)?.[1]
  if (quoted !== undefined)
    return [item(quoted, text(quoted)), item(quoted, make("pattern_text", {value: quoted}))]
  return isVariableName(query) && !reservedWords.has(query) ? [item(query, named(query))] : []
}

function inputsOf(type: Type): number {
  const f = asFunction(type)
  return f === undefined ? 0 : Math.min(9, 1 + inputsOf(f.to))
}

function reaction(
  name: string,
  as: string,
  patterns: readonly SavedBlock[],
  answer?: SavedBlock,
): SavedBlock {
  return make(
    "define",
    {name, as, arity: patterns.length, equations: [{}]},
    {
      ...Object.fromEntries(patterns.map((p, i) => [`P0_${i}`, p])),
      ...(answer === undefined ? {} : {E0_0: answer}),
    },
  )
}

const drive = con("Velocity", num("0.5"), num("0"))
const senses: readonly ToolboxItem[] = [
  item(
    "when the bumper is pressed",
    reaction("onBump", "event", [pat("Bumper", anything("side"), match("ButtonStatus", "Pressed"))]),
  ),
  item(
    "when the left bumper is pressed",
    reaction("onLeftBump", "event", [pat("BumperLeft", match("ButtonStatus", "Pressed"))]),
  ),
  item(
    "at any bumper event",
    make(
      "define",
      {name: "onAnyBump", as: "event", arity: 1, equations: [{}], signature: "Bumper -> Maybe Sound"},
      {P0_0: anything("bumper event"), E0_0: con("Just", pick("Sound", "ButtonSound"))},
    ),
  ),
  item(
    "when there is a hole",
    reaction("onCliff", "event", [pat("Cliff", anything("side"), match("CliffStatus", "Hole"))]),
  ),
  item(
    "when a wheel leaves the ground",
    reaction("onLift", "event", [pat("Wheel", anything("side"), match("WheelStatus", "Air"))]),
  ),
  item(
    "when a button is pressed",
    reaction("onButton", "event", [
      pat("Button", match("ButtonNumber", "Button0"), match("ButtonStatus", "Pressed")),
    ]),
  ),
  item("Bumper event", pat("Bumper", anything("side"), match("ButtonStatus", "Pressed"))),
  item("Cliff event", pat("Cliff", anything("side"), match("CliffStatus", "Hole"))),
  item("Wheel event", pat("Wheel", anything("side"), match("WheelStatus", "Air"))),
  item("Button event", pat("Button", match("ButtonNumber", "Button0"), match("ButtonStatus", "Pressed"))),
  ...[
    "BumperSide",
    "ButtonStatus",
    "CliffSide",
    "CliffStatus",
    "WheelSide",
    "WheelStatus",
    "ButtonNumber",
    "RobotStatus",
  ].map(type =>
    item(
      `pattern ${choices[type]?.what} ${type} ${choices[type]?.options.join(" ")}`,
      match(type, choices[type]?.options[0] ?? ""),
    ),
  ),
  item("any, whatever it is", anything("thing")),
]

const states: readonly ToolboxItem[] = [
  item(
    "when it has a velocity",
    reaction("accelerate", "state", [pat("Velocity", named("vl"), named("va"))]),
  ),
  item("when it has a position", reaction("here", "state", [pat("Position", named("x"), named("y"))])),
  item("when it has an orientation", reaction("facing", "state", [pat("Orientation", named("angle"))])),
  item("Velocity state", pat("Velocity", named("vl"), named("va"))),
  item("Position state", pat("Position", named("x"), named("y"))),
  item("Orientation state", pat("Orientation", named("angle"))),
  item("Pose state", pat("Pose", named("position"), named("angle"))),
  item("Clock time of day", pat("Clock", named("h"), named("m"), named("s"), named("ms"))),
  item("a name for what is here", named("x")),
]

const commands: readonly ToolboxItem[] = [
  item("send always: drive on", reaction("move", "command", [], drive)),
  item("Velocity: drive and turn", drive),
  item("Led1: first light", con("Led1", pick("LedColor", "Orange"))),
  item("Led2: second light", con("Led2", pick("LedColor", "Orange"))),
  item("Sound: play a sound", pick("Sound", "ErrorSound")),
  item("Say: speech bubble", con("Say", text("hello"))),
  item("colour of a light", pick("LedColor", "Red")),
  item("several at once, tuple", make("tuple", {items: 2})),
  item("three at once, tuple", make("tuple", {items: 3})),
  item("nothing to send, ()", make("tuple", {items: 0})),
]

const memory: readonly ToolboxItem[] = [
  item("just: there is a value, Maybe", con("Just")),
  item("nothing: no value, Maybe", con("Nothing")),
  item("Memory: remember", con("Memory")),
  item("what is remembered, Memory", pat("Memory", named("m"))),
  item("when it remembers", reaction("remember", "memory", [pat("Memory", named("m"))])),
  item("Left: the first of two", con("Left")),
  item("Right: the second of two", con("Right")),
  item("just pattern, Maybe", pat("Just", named("x"))),
  item("nothing pattern, Maybe", pat("Nothing")),
  item("left pattern, Either", pat("Left", named("x"))),
  item("right pattern, Either", pat("Right", named("x"))),
  item("Param: remember in all tasks", con("Param")),
]

const taskItems: readonly ToolboxItem[] = [
  item(
    "a task of several steps",
    reaction("drawSquare", "task", [], make("do", {}, {S: make("step_say", {}, {X: text("go")})})),
  ),
  item("do these steps", make("do")),
  item("do one thing", make("step_do")),
  item("do and name the result", make("step_bind", {}, {P: named("x")})),
  item("repeat a number of times", make("step_repeat", {}, {N: num("4")})),
  item("forever", make("step_forever")),
  item("say", make("step_say", {}, {X: text("done")})),
  item("wait some seconds", make("step_wait", {}, {X: num("1")})),
  item("only if", make("step_when")),
  item("unless", make("step_unless")),
  item("if, do, else", make("step_if")),
  item("let, for the steps below", make("step_let")),
  item("task: start something, then react until done", call("task", 2)),
  item("Done: end the task", con("Done", make("tuple", {items: 0}))),
  item("once: send something one time", call("once", 1)),
  item("parallel: both at the same time", call("parallel", 2)),
  item("race: the first to end wins", call("race", 2)),
]

const numbers: readonly ToolboxItem[] = [
  item("number", num("0.5")),
  item("plus +", infix("+")),
  item("minus -", infix("-")),
  item("times *", infix("*")),
  item("divided by /", infix("/")),
  item("the other side of zero, negate", make("negate")),
  item("pi", ref("pi")),
  item("power ^", infix("^")),
  item("whole division div mod", infix("div")),
  item("degrees as an orientation", call("degreesToOrientation", 1, num("90"))),
  item("orientation in degrees", call("orientationToDegrees", 1)),
  item("position as an arrow, positionToVec", call("positionToVec", 1)),
  item("arrow as a position, vecToPosition", call("vecToPosition", 1)),
  item("length of an arrow, magnitudeVec", call("magnitudeVec", 1)),
  item("add or subtract arrows, addVec subVec", infix("addVec")),
  item("number as seconds, doubleToSeconds", call("doubleToSeconds", 1)),
  item("shortest turn, normOrientation", call("normOrientation", 1)),
  item("centimetres as metres", call("centimetersToMeters", 1, num("50"))),
  item("abs: without sign", call("abs", 1)),
  item("min: the smaller", call("min", 2)),
  item("max: the larger", call("max", 2)),
  item("number as a decimal, fromIntegral", call("fromIntegral", 1)),
  item("exactly this number, pattern", make("pattern_number", {value: "0"})),
]

const decide: readonly ToolboxItem[] = [
  item("if then else", make("if")),
  item("look at a value and choose, case", make("case", {alternatives: [{}, {}]})),
  item("compare > < == ", infix(">")),
  item("equal ==", infix("==")),
  item("and &&", infix("&&")),
  item("or ||", infix("||")),
  item("not", call("not", 1)),
  item("true false", pick("Bool", "True")),
  item("true false pattern", match("Bool", "True")),
]

const types: readonly ToolboxItem[] = [
  item(
    "own type with cases, data",
    make("data", {
      name: "Mode",
      constructors: [
        {name: "Go", fields: []},
        {name: "Stop", fields: []},
      ],
    }),
  ),
  item("another name for a type", make("synonym", {name: "Hit", type: "Bool"})),
  item(
    "own type with named parts, record",
    make("data", {
      name: "Goal",
      constructors: [
        {
          name: "Goal",
          fields: [
            {name: "distance", type: "Double"},
            {name: "angle", type: "Double"},
          ],
        },
      ],
    }),
  ),
  item("value of a type", make("typed", {type: "Double"})),
  item(
    "a task with a start and a stop, record",
    make(
      "record",
      {con: "TaskOptions", fields: ["starting", "stopped"]},
      {F0: make("tuple", {items: 0}), F1: make("tuple", {items: 0})},
    ),
  ),
  item("changed copy of a record, update", make("update", {fields: ["stopped"]}, {R: ref("taskOptions")})),
  item(
    "look at a record by its parts, pattern",
    make("pattern_record", {con: "TaskOptions", fields: ["stopped"]}),
  ),
  item("Haskell definition", make("raw_definition", {text: "helper :: Int -> Int\nhelper n = n + 1"})),
]

const functionItems: readonly ToolboxItem[] = [
  item("simulate: what to run", make("main", {controllers: 1})),
  item("function with an input", reaction("f", "plain", [named("x")])),
  item("constant", reaction("speed", "plain", [], num("0.5"))),
  item(
    "function with own definitions, where",
    make("define", {name: "f", as: "plain", arity: 1, equations: [{where: true}]}, {P0_0: named("x")}),
  ),
  item("give inputs to a function", make("apply", {args: 1})),
  item("function without a name, lambda", make("lambda", {inputs: 1}, {P0: named("x")})),
  item("operator with one side open, section", make("section", {op: "+", side: "right"}, {X: num("1")})),
  item("let: names for one expression", make("let")),
  item(
    "take a value apart",
    make("define_pattern", {}, {P: make("pattern_tuple", {items: 2}, {I0: named("a"), I1: named("b")})}),
  ),
  item("Haskell expression", make("raw_expression", {text: ""})),
  item("Haskell pattern", make("raw_pattern", {text: ""})),
]

const lists: readonly ToolboxItem[] = [
  item("text", text("hello")),
  item("one character", make("character", {value: "a"})),
  item("list", make("list", {items: 2})),
  item("empty list", make("list", {items: 0})),
  item("from one to another, range", make("range", {}, {A: num("1"), B: num("4")})),
  item(
    "list made from other lists",
    make("comprehension", {}, {B: ref("x"), S: make("step_bind", {}, {P: named("x")})}),
  ),
  item("put together ++", infix("++")),
  item("one more in front :", infix(":")),
  item("show: as text", call("show", 1)),
  item("map: change every item", call("map", 2)),
  item("filter: keep some items", call("filter", 2)),
  item("length: how many", call("length", 1)),
  item("sum of all", call("sum", 1)),
  item("together, tuple", make("tuple", {items: 2})),
  item("together, pattern", make("pattern_tuple", {items: 2}, {I0: named("a"), I1: named("b")})),
  item("first and rest, pattern", make("pattern_infix", {op: ":"}, {L: named("x"), R: named("xs")})),
  item("list pattern", make("pattern_list", {items: 0})),
  item("whole and parts, pattern", make("pattern_as", {name: "whole"})),
  item("exactly this text, pattern", make("pattern_text", {value: ""})),
]

const random: readonly ToolboxItem[] = [
  item(
    "a random number in a range",
    call("randomR", 2, make("tuple", {items: 2}, {I0: num("0"), I1: ref("pi")})),
  ),
  item("a random value", call("random", 1)),
]

const category = (
  name: string,
  family: ToolboxCategory["family"],
  items: readonly ToolboxItem[],
): ToolboxCategory => ({
  name,
  family,
  items,
})

const all = {
  senses: category("When it senses", "event", senses),
  states: category("How it is", "state", states),
  commands: category("Tell the robot", "command", commands),
  memory: category("Memory", "memory", memory),
  tasks: category("Tasks", "task", taskItems),
  numbers: category("Numbers", "number", [...numbers, ...random]),
  choices: category("Choices", "choice", decide),
  types: category("Own types", "own", types),
  functions: category("Functions", "own", functionItems),
  lists: category("Text and lists", "own", lists),
}

export function toolbox(level: Level): ToolboxCategory[] {
  switch (level) {
    case "tasks":
      return [
        all.tasks,
        all.commands,
        all.senses,
        all.numbers,
        all.choices,
        {...all.functions, items: functionItems.slice(0, 3)},
      ]
    case "reactions":
      return [
        all.senses,
        all.states,
        all.commands,
        all.memory,
        all.numbers,
        all.choices,
        all.types,
        all.functions,
        all.tasks,
      ]
    case "haskell":
      return [
        all.senses,
        all.states,
        all.commands,
        all.memory,
        all.tasks,
        all.numbers,
        all.choices,
        all.lists,
        all.types,
        all.functions,
      ]
  }
}
