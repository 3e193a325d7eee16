/// Items of the toolbox for the language: memory, tasks, numbers, choices, types, functions, lists.

import type {ToolboxItem} from "../../api.ts"
import {perLanguage, words} from "../../words/index.ts"
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
  stacked,
  text,
} from "./block_builders.ts"
import {ownEventReaction} from "./own_events.ts"
import {item} from "./toolbox_item.ts"

export const memory = perLanguage((): readonly ToolboxItem[] => [
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

/// The library's ready-made tasks as steps, and what joins them.
export const motionItems = perLanguage((): readonly ToolboxItem[] => {
  const {motion} = words.toolbox
  const untilButton = make(
    "lambda",
    {inputs: 1},
    {P0: pat("ButtonZero", anything("status")), B: con("Done", make("tuple", {items: 0}))},
  )
  return [
    item(motion.drive, make("step_drive", {}, {X: num("50")})),
    item(motion.turn, make("step_turn", {}, {X: num("90")})),
    item(words.toolbox.repeatANumberOfTimes, make("step_repeat", {}, {N: num("4")})),
    item(
      motion.square,
      make(
        "step_repeat",
        {},
        {
          N: num("4"),
          S: stacked([make("step_drive", {}, {X: num("50")}), make("step_turn", {}, {X: num("90")})]),
        },
      ),
    ),
    item(motion.driveUntilBump, make("step_drive_until_bump")),
    item(motion.driveUntil, make("step_drive_until", {}, {X: untilButton})),
    item(motion.driveBack, make("step_drive_back", {}, {X: num("1")})),
    item(motion.keepBack, make("step_forever", {}, {S: make("step_drive_back", {}, {X: num("1")})})),
    item(motion.turnBetween, make("step_turn_between", {}, {X: num("-180"), Y: num("180")})),
    item(motion.goTo, make("step_go_to", {}, {X: num("1"), Y: num("0.5")})),
    item(motion.curve, make("step_curve_until_obstacle", {}, {X: num("-20")})),
    item(
      motion.eitherOr,
      make("step_either_or", {}, {X: call("turn", 1, num("90")), Y: call("turn", 1, num("-90"))}),
    ),
    item(
      motion.randomNumber,
      make("step_bind", {}, {P: named("number"), X: call("randomNumber", 2, num("10"), num("100"))}),
    ),
    item(motion.dice, make("step_bind", {}, {P: named("number"), X: call("dice", 1, num("6"))})),
    item(words.toolbox.waitSomeSeconds, make("step_wait", {}, {X: num("1")})),
    item(motion.blink, make("step_blink", {}, {X: pick("LedColor", "Red")})),
    item(motion.beep, make("step_beep")),
    item(motion.penDown, make("step_pen_down")),
    item(motion.penUp, make("step_pen_up")),
    item(motion.penColor, make("step_pen_color", {}, {X: pick("PenColor", "RedInk")})),
    item(motion.penWidth, make("step_pen_width", {}, {X: num("5")})),
  ]
})

export const taskItems = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.aTaskOfSeveralSteps,
    reaction("myTask", "task", [], make("do", {}, {S: make("step_say", {}, {X: text("go")})})),
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

/// What the robot's own programs do: actions of ROS.
export const robotActionItems = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.motion.dock, make("step_dock")),
  item(words.toolbox.motion.undock, make("step_undock")),
  item(
    words.toolbox.motion.navigateTo,
    make("step_navigate_to", {}, {X: num("2"), Y: num("1"), Z: num("0")}),
  ),
  item(words.toolbox.motion.dockOutcome, make("step_bind", {}, {P: named("outcome"), X: ref("dock")})),
])

export const numbers = perLanguage((): readonly ToolboxItem[] => [
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

/// The first goes before the second for a second after its last command: long enough to see, short enough to go on.
export const priorityForASecond = () => make("priority", {}, {T: num("1")})

/// The first keeps its actuator for an hour, longer than anyone watches a run.
export const priorityForGood = () => make("priority", {}, {T: num("3600")})

export const decide = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.firstThisOtherwiseThat, priorityForASecond()),
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

export const types = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.ownEventData,
    make("data", {name: "Knock", constructors: [{name: "Knock", fields: []}]}),
  ),
  item(words.toolbox.whenAnOwnEventHappens, ownEventReaction()),
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

export const functionItems = perLanguage((): readonly ToolboxItem[] => [
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

export const lists = perLanguage((): readonly ToolboxItem[] => [
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

export const random = perLanguage((): readonly ToolboxItem[] => [
  item(
    words.toolbox.aRandomNumberInARange,
    call("randomR", 2, make("tuple", {items: 2}, {I0: num("0"), I1: ref("pi")})),
  ),
  item(words.toolbox.aRandomValue, call("random", 1)),
])
