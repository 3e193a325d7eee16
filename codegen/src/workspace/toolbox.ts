/// What the toolbox offers: ready blocks, with the sockets filled where a newcomer would have to search.
///
/// Three levels filter and order; none locks anything: text and saved programs may hold every block at every level.

import type {Level, ToolboxCategory, ToolboxItem} from "../api.ts"
import {choiceOf, choices, whatOf} from "../blocks/vocabulary.ts"
import {isNumberLiteral, isOperator, isVariableName, reservedWords} from "../haskell/lexemes.ts"
import type {SavedBlock} from "../saved.ts"
import {library} from "../types/library.ts"
import {asFunction, type Type} from "../types/type.ts"
import {perLanguage, words} from "../words/index.ts"
import {readyReactions, readyTasks} from "./readymade.ts"
import {
  anything,
  call,
  con,
  infix,
  make,
  match,
  named,
  num,
  pat,
  pick,
  reaction,
  ref,
  text,
} from "./saying.ts"

function item(label: string, block: SavedBlock): ToolboxItem {
  const also = alsoFor(block)
  return {label, block, ...(also === "" ? {} : {also})}
}

/// Other words for what a block and those in it are about.
function alsoFor(block: SavedBlock): string {
  const known: {readonly [about: string]: string} = words.toolbox.also
  const {con, of, name} = block.extraState ?? {}
  const own = [block.type, con, of, name].flatMap(about =>
    typeof about === "string" && Object.hasOwn(known, about) ? [known[about]] : [],
  )
  const inside = [...Object.values(block.inputs ?? {}), block.next].flatMap(input =>
    input?.block === undefined ? [] : [alsoFor(input.block)],
  )
  return [...own, ...inside].filter(found => found !== "").join(" ")
}

/// Every other name that a program knows without defining it, for the search: it finds all of Haskell at every level.
export function libraryItems(): ToolboxItem[] {
  const values = [...library.values].flatMap(([name, scheme]): ToolboxItem[] => {
    const count = inputsOf(scheme.type)
    if (!isOperator(name) && count === 0) return [item(name, ref(name))]
    if (!isOperator(name)) {
      const itself = make("name", {name, args: 0, fn: true})
      return [item(name, call(name, count)), item(words.toolbox.asAFunction(name), itself)]
    }
    return count === 2 ? [item(name, infix(name))] : []
  })
  const constructors = [...library.constructors.values()].flatMap((info): ToolboxItem[] => {
    if (!/^[A-Z]/.test(info.name) || choiceOf(info.name) !== undefined) return []
    const extra = {con: info.name, args: info.fields.length}
    return [
      item(info.name, make("construct", extra)),
      item(words.toolbox.pattern(info.name), make("pattern_construct", extra)),
      ...(info.fields.length === 0
        ? []
        : [item(words.toolbox.asAFunction(info.name), make("construct", {con: info.name, args: 0}))]),
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

const drive = con("Velocity", num("0.5"), num("0"))
const senses = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.whenTheBumperIsPressed,
    reaction("onBump", "event", [pat("Bumper", anything("side"), match("ButtonStatus", "Pressed"))]),
  ),
  item(
    words.toolbox.whenTheLeftBumperIsPressed,
    reaction("onLeftBump", "event", [pat("BumperLeft", match("ButtonStatus", "Pressed"))]),
  ),
  item(
    words.toolbox.atAnyBumperEvent,
    make(
      "define",
      {name: "onAnyBump", as: "event", arity: 1, equations: [{}], signature: "Bumper -> Maybe Sound"},
      {P0_0: anything("bumper event"), E0_0: con("Just", pick("Sound", "ButtonSound"))},
    ),
  ),
  item(
    words.toolbox.whenThereIsAHole,
    reaction("onCliff", "event", [pat("Cliff", anything("side"), match("CliffStatus", "Hole"))]),
  ),
  item(
    words.toolbox.whenAWheelLeavesTheGround,
    reaction("onLift", "event", [pat("Wheel", anything("side"), match("WheelStatus", "Air"))]),
  ),
  item(
    words.toolbox.whenAButtonIsPressed,
    reaction("onButton", "event", [
      pat("Button", match("ButtonNumber", "Button0"), match("ButtonStatus", "Pressed")),
    ]),
  ),
  item(words.toolbox.bumperEvent, pat("Bumper", anything("side"), match("ButtonStatus", "Pressed"))),
  item(words.toolbox.cliffEvent, pat("Cliff", anything("side"), match("CliffStatus", "Hole"))),
  item(words.toolbox.wheelEvent, pat("Wheel", anything("side"), match("WheelStatus", "Air"))),
  item(
    words.toolbox.buttonEvent,
    pat("Button", match("ButtonNumber", "Button0"), match("ButtonStatus", "Pressed")),
  ),
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
      words.toolbox.pattern2(whatOf(type), type, choices[type]?.options.join(" ") ?? ""),
      match(type, choices[type]?.options[0] ?? ""),
    ),
  ),
  item(words.toolbox.anyWhatever, anything("thing")),
])

const states = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.whenItHasAVelocity,
    reaction("accelerate", "state", [pat("Velocity", named("vl"), named("va"))]),
  ),
  item(
    words.toolbox.whenItHasAPosition,
    reaction("here", "state", [pat("Position", named("x"), named("y"))]),
  ),
  item(
    words.toolbox.whenItHasAnOrientation,
    reaction("facing", "state", [pat("Orientation", named("angle"))]),
  ),
  item(words.toolbox.velocityState, pat("Velocity", named("vl"), named("va"))),
  item(words.toolbox.positionState, pat("Position", named("x"), named("y"))),
  item(words.toolbox.orientationState, pat("Orientation", named("angle"))),
  item(words.toolbox.poseState, pat("Pose", named("position"), named("angle"))),
  item(words.toolbox.clockTimeOfDay, pat("Clock", named("h"), named("m"), named("s"), named("ms"))),
  item(words.toolbox.aNameForWhat, named("x")),
])

const commands = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.sendAlwaysDriveOn, reaction("move", "command", [], drive)),
  item(words.toolbox.velocityDriveAndTurn, drive),
  item(words.toolbox.led1FirstLight, con("Led1", pick("LedColor", "Orange"))),
  item(words.toolbox.led2SecondLight, con("Led2", pick("LedColor", "Orange"))),
  item(words.toolbox.soundPlayASound, pick("Sound", "ErrorSound")),
  item(words.toolbox.saySpeechBubble, con("Say", text("hello"))),
  item(words.toolbox.colourOfALight, pick("LedColor", "Red")),
  item(words.toolbox.severalAtOnceTuple, make("tuple", {items: 2})),
  item(words.toolbox.threeAtOnceTuple, make("tuple", {items: 3})),
  item(words.toolbox.nothingToSend, make("tuple", {items: 0})),
])

const memory = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.justThereIsAValueMaybe, con("Just")),
  item(words.toolbox.nothingNoValueMaybe, con("Nothing")),
  item(words.toolbox.memoryRemember, con("Memory")),
  item(words.toolbox.whatIsRememberedMemory, pat("Memory", named("m"))),
  item(words.toolbox.whenItRemembers, reaction("remember", "memory", [pat("Memory", named("m"))])),
  item(words.toolbox.leftTheFirstOfTwo, con("Left")),
  item(words.toolbox.rightTheSecondOfTwo, con("Right")),
  item(words.toolbox.justPatternMaybe, pat("Just", named("x"))),
  item(words.toolbox.nothingPatternMaybe, pat("Nothing")),
  item(words.toolbox.leftPatternEither, pat("Left", named("x"))),
  item(words.toolbox.rightPatternEither, pat("Right", named("x"))),
  item(words.toolbox.paramRememberInAllTasks, con("Param")),
])

const taskItems = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.aTaskOfSeveralSteps,
    reaction("drawSquare", "task", [], make("do", {}, {S: make("step_say", {}, {X: text("go")})})),
  ),
  item(words.toolbox.doTheseSteps, make("do")),
  item(words.toolbox.doOneThing, make("step_do")),
  item(words.toolbox.doAndNameTheResult, make("step_bind", {}, {P: named("x")})),
  item(words.toolbox.repeatANumberOfTimes, make("step_repeat", {}, {N: num("4")})),
  item(words.toolbox.forever, make("step_forever")),
  item(words.toolbox.say, make("step_say", {}, {X: text("done")})),
  item(words.toolbox.waitSomeSeconds, make("step_wait", {}, {X: num("1")})),
  item(words.toolbox.onlyIf, make("step_when")),
  item(words.toolbox.unless, make("step_unless")),
  item(words.toolbox.ifDoElse, make("step_if")),
  item(words.toolbox.letForTheStepsBelow, make("step_let")),
  item(words.toolbox.taskStartSomethingThenReactUntilDone, call("task", 2)),
  item(words.toolbox.doneEndTheTask, con("Done", make("tuple", {items: 0}))),
  item(words.toolbox.onceSendSomethingOneTime, call("once", 1)),
  item(words.toolbox.parallelBothAtTheSameTime, call("parallel", 2)),
  item(words.toolbox.raceTheFirstToEndWins, call("race", 2)),
])

const numbers = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.number, num("0.5")),
  item(words.toolbox.plus, infix("+")),
  item(words.toolbox.minus, infix("-")),
  item(words.toolbox.times, infix("*")),
  item(words.toolbox.dividedBy, infix("/")),
  item(words.toolbox.theOtherSideOfZeroNegate, make("negate")),
  item(words.toolbox.pi, ref("pi")),
  item(words.toolbox.power, infix("^")),
  item(words.toolbox.wholeDivisionDivMod, infix("div")),
  item(words.toolbox.degreesAsAnOrientation, call("degreesToOrientation", 1, num("90"))),
  item(words.toolbox.orientationInDegrees, call("orientationToDegrees", 1)),
  item(words.toolbox.positionAsAnArrowPositionToVec, call("positionToVec", 1)),
  item(words.toolbox.arrowAsAPositionVecToPosition, call("vecToPosition", 1)),
  item(words.toolbox.lengthOfAnArrowMagnitudeVec, call("magnitudeVec", 1)),
  item(words.toolbox.addOrSubtractArrowsAddVecSubVec, infix("addVec")),
  item(words.toolbox.numberAsSecondsDoubleToSeconds, call("doubleToSeconds", 1)),
  item(words.toolbox.shortestTurnNormOrientation, call("normOrientation", 1)),
  item(words.toolbox.centimetresAsMetres, call("centimetersToMeters", 1, num("50"))),
  item(words.toolbox.absWithoutSign, call("abs", 1)),
  item(words.toolbox.minTheSmaller, call("min", 2)),
  item(words.toolbox.maxTheLarger, call("max", 2)),
  item(words.toolbox.numberAsADecimalFromIntegral, call("fromIntegral", 1)),
  item(words.toolbox.exactlyThisNumberPattern, make("pattern_number", {value: "0"})),
])

const decide = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.ifThenElse, make("if")),
  item(words.toolbox.lookAtAValueAndChooseCase, make("case", {alternatives: [{}, {}]})),
  item(words.toolbox.theFirstThatHolds, make("branches", {guards: 2, otherwise: true})),
  item(words.toolbox.aFunctionThatLooksAtItsInput, make("case", {lambda: true, alternatives: [{}, {}]})),
  item(words.toolbox.compare, infix(">")),
  item(words.toolbox.equal, infix("==")),
  item(words.toolbox.and, infix("&&")),
  item(words.toolbox.or, infix("||")),
  item(words.toolbox.not, call("not", 1)),
  item(words.toolbox.trueFalse, pick("Bool", "True")),
  item(words.toolbox.trueFalsePattern, match("Bool", "True")),
])

const types = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.ownTypeWithCasesData,
    make("data", {
      name: "Mode",
      constructors: [
        {name: "Go", fields: []},
        {name: "Stop", fields: []},
      ],
    }),
  ),
  item(words.toolbox.anotherNameForAType, make("synonym", {name: "Hit", type: "Bool"})),
  item(
    words.toolbox.ownTypeWithNamedPartsRecord,
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
  item(words.toolbox.howATypeBelongsToAClass, make("instance", {head: "instance Show Mode"})),
  item(words.toolbox.valueOfAType, make("typed", {type: "Double"})),
  item(
    words.toolbox.aTaskWithAStart,
    make(
      "record",
      {con: "TaskOptions", fields: ["starting", "stopped"]},
      {F0: make("tuple", {items: 0}), F1: make("tuple", {items: 0})},
    ),
  ),
  item(
    words.toolbox.changedCopyOfARecordUpdate,
    make("update", {fields: ["stopped"]}, {R: ref("taskOptions")}),
  ),
  item(
    words.toolbox.lookAtARecordByItsParts,
    make("pattern_record", {con: "TaskOptions", fields: ["stopped"]}),
  ),
  item(
    words.toolbox.haskellDefinition,
    make("raw_definition", {text: "helper :: Int -> Int\nhelper n = n + 1"}),
  ),
])

const functionItems = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.simulateWhatToRun, make("main", {controllers: 1})),
  item(words.toolbox.functionWithAnInput, reaction("f", "plain", [named("x")])),
  item(words.toolbox.constant, reaction("speed", "plain", [], num("0.5"))),
  item(
    words.toolbox.functionWithOwnDefinitionsWhere,
    make("define", {name: "f", as: "plain", arity: 1, equations: [{where: true}]}, {P0_0: named("x")}),
  ),
  item(words.toolbox.giveInputsToAFunction, make("apply", {args: 1})),
  item(words.toolbox.functionWithoutANameLambda, make("lambda", {inputs: 1}, {P0: named("x")})),
  item(
    words.toolbox.operatorWithOneSideOpenSection,
    make("section", {op: "+", side: "right"}, {X: num("1")}),
  ),
  item(words.toolbox.letNamesForOneExpression, make("let")),
  item(
    words.toolbox.takeAValueApart,
    make("define_pattern", {}, {P: make("pattern_tuple", {items: 2}, {I0: named("a"), I1: named("b")})}),
  ),
  item(words.toolbox.haskellExpression, make("raw_expression", {text: ""})),
  item(words.toolbox.haskellPattern, make("raw_pattern", {text: ""})),
])

const lists = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.text, text("hello")),
  item(words.toolbox.oneCharacter, make("character", {value: "a"})),
  item(words.toolbox.list, make("list", {items: 2})),
  item(words.toolbox.emptyList, make("list", {items: 0})),
  item(words.toolbox.fromOneToAnotherRange, make("range", {}, {A: num("1"), B: num("4")})),
  item(
    words.toolbox.listMadeFromOtherLists,
    make("comprehension", {}, {B: ref("x"), S: make("step_bind", {}, {P: named("x")})}),
  ),
  item(words.toolbox.putTogether, infix("++")),
  item(words.toolbox.oneMoreInFront, infix(":")),
  item(words.toolbox.showAsText, call("show", 1)),
  item(words.toolbox.mapChangeEveryItem, call("map", 2)),
  item(words.toolbox.filterKeepSomeItems, call("filter", 2)),
  item(words.toolbox.lengthHowMany, call("length", 1)),
  item(words.toolbox.sumOfAll, call("sum", 1)),
  item(words.toolbox.togetherTuple, make("tuple", {items: 2})),
  item(words.toolbox.togetherPattern, make("pattern_tuple", {items: 2}, {I0: named("a"), I1: named("b")})),
  item(words.toolbox.firstAndRestPattern, make("pattern_infix", {op: ":"}, {L: named("x"), R: named("xs")})),
  item(words.toolbox.listPattern, make("pattern_list", {items: 0})),
  item(words.toolbox.wholeAndPartsPattern, make("pattern_as", {name: "whole"})),
  item(words.toolbox.exactlyThisTextPattern, make("pattern_text", {value: ""})),
  item(words.toolbox.exactlyThisCharacterPattern, make("pattern_character", {value: "a"})),
])

const random = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.aRandomNumberInARange,
    call("randomR", 2, make("tuple", {items: 2}, {I0: num("0"), I1: ref("pi")})),
  ),
  item(words.toolbox.aRandomValue, call("random", 1)),
])

const category = (
  name: string,
  family: ToolboxCategory["family"],
  items: readonly ToolboxItem[],
): ToolboxCategory => ({
  name,
  family,
  items,
})

const categories = perLanguage(() => ({
  ready: category(
    words.toolbox.readyMade,
    "task",
    [...readyTasks(), ...readyReactions()].map(found => item(found.label, found.block)),
  ),
  reactions: category(
    words.toolbox.readyMade,
    "event",
    [...readyReactions(), ...readyTasks()].map(found => item(found.label, found.block)),
  ),
  senses: category(words.toolbox.whenItSenses, "event", senses()),
  states: category(words.toolbox.howIt, "state", states()),
  commands: category(words.toolbox.tellTheRobot, "command", commands()),
  memory: category(words.toolbox.memory, "memory", memory()),
  tasks: category(words.toolbox.tasks, "task", taskItems()),
  numbers: category(words.toolbox.numbers, "number", [...numbers(), ...random()]),
  choices: category(words.toolbox.choices, "choice", decide()),
  types: category(words.toolbox.ownTypes, "own", types()),
  functions: category(words.toolbox.functions, "own", functionItems()),
  lists: category(words.toolbox.textAndLists, "own", lists()),
}))

export function toolbox(level: Level): ToolboxCategory[] {
  const all = categories()
  switch (level) {
    case "tasks":
      return [
        all.ready,
        all.tasks,
        all.commands,
        all.senses,
        all.numbers,
        all.choices,
        {...all.functions, items: functionItems().slice(0, 3)},
      ]
    case "reactions":
      return [
        all.reactions,
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
        all.reactions,
      ]
  }
}
