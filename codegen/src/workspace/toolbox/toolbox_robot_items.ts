/// Items of the toolbox for the robot: what it senses, its states, and commands.

import type {ToolboxItem} from "../../api.ts"
import {choices, exampleNameOf} from "../../blocks/spec/constructor_labels.ts"
import {perLanguage, words} from "../../words/index.ts"
import {
  anything,
  con,
  make,
  match,
  named,
  num,
  pat,
  pick,
  reaction,
  sometimes,
  text,
} from "./block_builders.ts"
import {bumper, cliff, firstButton, leftBumper, wheel} from "./event_patterns.ts"
import {item} from "./toolbox_item.ts"
import {examples} from "./toolbox_robot_examples.ts"

const drive = con("Velocity", num("0.5"), num("0"))

export const senses = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.whenTheBumperIsPressed, sometimes("onBump", bumper("Pressed"))),
  item(words.toolbox.whenTheLeftBumperIsPressed, sometimes("onLeftBump", leftBumper)),
  item(
    words.toolbox.atAnyBumperEvent,
    make(
      "define",
      {name: "onAnyBump", as: "event", arity: 1, equations: [{}], signature: "Bumper -> Maybe Sound"},
      {P0_0: anything("bumper event"), E0_0: con("Just", pick("Sound", "ButtonSound"))},
    ),
  ),
  item(words.toolbox.whenThereIsAHole, sometimes("onCliff", cliff("Hole"))),
  item(words.toolbox.whenAWheelLeavesTheGround, sometimes("onLift", wheel)),
  item(words.toolbox.whenAButtonIsPressed, sometimes("onButton", firstButton)),
  item(words.toolbox.bumperEvent, bumper("Pressed")),
  item(words.toolbox.cliffEvent, cliff("Hole")),
  item(words.toolbox.wheelEvent, wheel),
  item(words.toolbox.buttonEvent, firstButton),
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
      words.toolbox.pattern2(exampleNameOf(type), type, choices[type]?.options.join(" ") ?? ""),
      match(type, choices[type]?.options[0] ?? ""),
    ),
  ),
  ...examples("event"),
  item(words.toolbox.anyWhatever, anything("thing")),
])

export const states = perLanguage((): readonly ToolboxItem[] => [
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
  ...examples("state"),
  item(words.toolbox.aNameForWhat, named("x")),
])

export const commands = perLanguage((): readonly ToolboxItem[] => [
  item(words.toolbox.sendAlwaysDriveOn, reaction("move", "command", [], drive)),
  item(words.toolbox.velocityDriveAndTurn, drive),
  item(words.toolbox.led1FirstLight, con("Led1", pick("LedColor", "Orange"))),
  item(words.toolbox.led2SecondLight, con("Led2", pick("LedColor", "Orange"))),
  item(words.toolbox.soundPlayASound, pick("Sound", "ErrorSound")),
  item(words.toolbox.saySpeechBubble, con("Say", text("hello"))),
  ...examples("command"),
  item(words.toolbox.colourOfALight, pick("LedColor", "Red")),
  item(words.toolbox.severalAtOnceTuple, make("tuple", {items: 2})),
  item(words.toolbox.threeAtOnceTuple, make("tuple", {items: 3})),
  item(words.toolbox.nothingToSend, make("tuple", {items: 0})),
])
