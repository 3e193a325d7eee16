/// Ready-made pieces: whole definitions that work as they are, for the things that learners want first. Each needs
/// only its name in `simulate`; a test compiles them all.

import type {ToolboxItem} from "../../api.ts"
import type {SavedBlock} from "../../serialized_blocks.ts"
import {perLanguage, words} from "../../words/index.ts"
import {
  answers,
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
import {bumper, cliff, firstButton} from "./event_patterns.ts"

/// A definition that answers one event with a command, and another one with nothing.
function answersOnly(name: string, when: SavedBlock, command: SavedBlock, otherwise: SavedBlock): SavedBlock {
  return answers(name, [
    {when, answer: con("Just", command)},
    {when: otherwise, answer: nothing},
  ])
}

/// A task that does its steps one after the other.
function task(name: string, ...steps: readonly SavedBlock[]): SavedBlock {
  return make(
    "define",
    {name, as: "task", arity: 0, equations: [{}], signature: "Task ()"},
    {E0_0: make("do", {}, {S: stacked(steps)})},
  )
}

const drive = (speed: string, turning: string) => con("Velocity", num(speed), num(turning))
const line = (place: string) => match("LineSensor", place)
const nothing = con("Nothing")
const forever = (...steps: readonly SavedBlock[]) => make("step_forever", {}, {S: stacked(steps)})
const curve = (degrees: string) => make("step_curve_until_obstacle", {}, {X: num(degrees)})
const say = (what: string) => make("step_say", {}, {X: text(what)})
const wait = (seconds: string) => make("step_wait", {}, {X: num(seconds)})
const send = (what: SavedBlock) => make("step_do", {}, {X: call("once", 1, what)})

/// Functions that react.
export const readyReactions = perLanguage((): readonly ToolboxItem[] => {
  const w = words.toolbox.ready
  const item = (label: string, block: SavedBlock): ToolboxItem => ({label, block})
  return [
    item(w.driveOn, reaction("driveOn", "command", [], drive("0.2", "0"))),
    item(w.backOff, answersOnly("backOff", bumper("Pressed"), drive("-0.2", "0"), bumper("Released"))),
    item(
      w.complain,
      answersOnly("complain", bumper("Pressed"), pick("Sound", "ErrorSound"), bumper("Released")),
    ),
    item(w.stopAtEdge, answersOnly("stopAtEdge", cliff("Hole"), drive("0", "0"), cliff("Floor"))),
    item(
      w.edgeLight,
      answers("edgeLight", [
        {when: cliff("Hole"), answer: con("Led1", pick("LedColor", "Red"))},
        {when: cliff("Floor"), answer: con("Led1", pick("LedColor", "Black"))},
      ]),
    ),
    item(
      w.followLine,
      answers(
        "followLine",
        [
          {when: line("LineAhead"), answer: drive("0.2", "0")},
          {when: line("LineLeft"), answer: drive("0.1", "1")},
          {when: line("LineRight"), answer: drive("0.1", "-1")},
          {when: line("NoLine"), answer: drive("0", "0.5")},
        ],
        "state",
      ),
    ),
    item(
      w.buttonSound,
      answersOnly("buttonSound", firstButton, pick("Sound", "ButtonSound"), anything("thing")),
    ),
    item(
      w.buttonLight,
      answersOnly("buttonLight", firstButton, con("Led1", pick("LedColor", "Green")), anything("thing")),
    ),
    item(
      w.blink,
      make(
        "define",
        {name: "blinkLight", as: "state", arity: 1, equations: [{guards: 1, otherwise: true}]},
        {
          P0_0: pat("Clock", anything("thing"), anything("thing"), named("second"), anything("thing")),
          C0_0: call("even", 1, ref("second")),
          E0_0: con("Led1", pick("LedColor", "Orange")),
          O0: con("Led1", pick("LedColor", "Black")),
        },
      ),
    ),
    item(
      w.faster,
      reaction(
        "faster",
        "state",
        [pat("Velocity", named("speed"), named("turning"))],
        con("Velocity", infix("+", ref("speed"), num("0.1")), ref("turning")),
      ),
    ),
    item(
      w.countBumps,
      make(
        "define",
        {
          name: "countBumps",
          as: "event",
          arity: 2,
          equations: [{}, {}],
          signature: "Bumper -> Memory Int -> Memory Int",
        },
        {
          P0_0: bumper("Pressed"),
          P0_1: pat("Memory", named("n")),
          E0_0: con("Memory", infix("+", ref("n"), num("1"))),
          P1_0: bumper("Released"),
          P1_1: pat("Memory", named("n")),
          E1_0: con("Memory", ref("n")),
        },
      ),
    ),
  ]
})

/// Tasks, step by step.
export const readyTasks = perLanguage((): readonly ToolboxItem[] => {
  const w = words.toolbox.ready
  const item = (label: string, block: SavedBlock): ToolboxItem => ({label, block})
  return [
    item(
      w.wander,
      task(
        "wander",
        forever(
          make("step_drive_until_bump"),
          make("step_drive_back", {}, {X: num("1")}),
          make("step_turn_between", {}, {X: num("90"), Y: num("270")}),
        ),
      ),
    ),
    item(
      w.followWall,
      task(
        "followWall",
        curve("0"),
        forever(
          make("step_drive_back", {}, {X: num("0.5")}),
          make("step_turn", {}, {X: num("40")}),
          // The wall is on the right: left of it would be a turn to the right and a curve to the left.
          curve("-20"),
        ),
      ),
    ),
    item(
      w.goToPlace,
      task("goToPlace", make("step_go_to", {}, {X: num("1"), Y: num("0.5")}), say("here I am")),
    ),
    item(w.thisThenThat, task("thisThenThat", say("one"), wait("1"), say("two"))),
    item(w.driveThenStop, task("driveThenStop", send(drive("0.2", "0")), wait("2"), send(drive("0", "0")))),
    item(
      w.walkAndTurn,
      task("walkAndTurn", forever(send(drive("0.2", "0")), wait("3"), send(drive("0", "1")), wait("1.5"))),
    ),
    item(w.everySecond, task("everySecond", forever(say("tick"), wait("1")))),
    item(
      w.lightShow,
      task(
        "lightShow",
        make(
          "step_repeat",
          {},
          {
            N: num("5"),
            S: stacked([
              send(con("Led1", pick("LedColor", "Red"))),
              wait("0.5"),
              send(con("Led1", pick("LedColor", "Black"))),
              wait("0.5"),
            ]),
          },
        ),
      ),
    ),
  ]
})
