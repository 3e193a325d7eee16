/// Rosy's own constructors and types, and an example for each name of the library that the toolbox shows in English.

import {robot} from "./robot.generated.ts"

export const vocabulary = {
  constructors: {
    ...robot.constructors,
    Seconds: {parts: ["seconds"], tooltip: "A time in seconds. Example: Seconds 2."},
    Clock: {
      parts: ["hours", "minutes", "seconds", "milliseconds"],
      tooltip: "The time of day. Example: Clock 8 30 0 0 is half past eight.",
    },
    Just: {parts: ["value"], tooltip: "There is a value, and this is it. Example: just 3.", word: "just"},
    Nothing: {parts: [], tooltip: "There is no value. Example: send nothing.", word: "nothing"},
    Left: {
      parts: ["value"],
      tooltip: "The first of two possibilities. Example: left (Velocity 0.5 0).",
      word: "left",
    },
    Right: {
      parts: ["value"],
      tooltip: "The second of two possibilities. Example: right (Done ()).",
      word: "right",
    },
    Memory: {
      parts: ["value"],
      tooltip:
        "What the program remembers. As an input it is read, as an output it is written. Example: Memory True.",
    },
    Param: {parts: ["value"], tooltip: "What all tasks of the program remember together. Example: Param 0."},
    Done: {parts: ["result"], tooltip: "Ends the task with a result. Example: Done ()."},
  },
  charts: robot.charts,
  actuators: robot.actuators,
  makesAValue: (name: string) => `Makes a value with ${name || "a constructor"}. Example: ${name || "Go"}.`,
  valueLabels: robot.values,
  whats: {
    ...robot.whats,
    Bool: "yes or no",
    Ordering: "order",
  },
  anyOf: {thing: "any thing", side: "any side", "bumper event": "any bumper event"},
  samples: {
    pi: "Velocity 0 pi turns half round in a second",
    degreesToOrientation: "degreesToOrientation 90 is a quarter turn to the left",
    orientationToDegrees: "orientationToDegrees (Orientation pi) is 180",
    normOrientation: "normOrientation (goal - here) is the shorter way round",
    positionToVec: "positionToVec (Position 3 4) is an arrow of length 5",
    vecToPosition: "vecToPosition (positionToVec here) is here again",
    magnitudeVec: "magnitudeVec (positionToVec (Position 3 4)) is 5",
    doubleToSeconds: "now + doubleToSeconds 2 is two seconds later",
    centimetersToMeters: "centimetersToMeters 50 is 0.5",
    abs: "abs (-2) is 2",
    min: "min 2 3 is 2",
    max: "max 2 3 is 3",
    fromIntegral: "fromIntegral (length xs) / 2",
    not: "not True is False",
    randomR: "randomR (0, pi) gen is an angle and the generator for the next one",
    random: "random gen is a value and the generator for the next one",
    show: "show 3 is “3”",
    map: "map (… * 2) (list 1 2) is list 2 4",
    filter: "filter (… > 1) (list 1 2) is list 2",
    length: "length (list 5 6) is 2",
    sum: "sum (list 1 2 3) is 6",
    task: "task start run begins with start and reacts with run until Done",
    once: "once (Led1 Red) sends it one time",
    parallel: "parallel left right does both and waits for both",
    race: "race drive (wait 5) ends after 5 seconds at the latest",
  },
} as const
