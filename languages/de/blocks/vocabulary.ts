/// Rosy's own constructors and types, and an example for each name of the library that the toolbox shows, in German.
/// Constructors keep their Haskell names.

import type {Words} from "../../../codegen/src/words/index.ts"
import {robot} from "./robot.generated.ts"

export const vocabulary: Pick<
  Words,
  "constructors" | "charts" | "actuators" | "makesAValue" | "valueLabels" | "whats" | "anyOf" | "samples"
> = {
  constructors: {
    ...robot.constructors,
    Seconds: {parts: ["Sekunden"], tooltip: "Eine Zeit in Sekunden. Beispiel: Seconds 2."},
    Clock: {
      parts: ["Stunden", "Minuten", "Sekunden", "Millisekunden"],
      tooltip: "Die Uhrzeit. Beispiel: Clock 8 30 0 0 ist halb neun.",
    },
    Just: {
      parts: ["Wert"],
      tooltip: "Es gibt einen Wert, und das ist er. In Haskell heißt das Just. Beispiel: nur 3.",
      word: "nur",
    },
    Nothing: {
      parts: [],
      tooltip: "Es gibt keinen Wert. In Haskell heißt das Nothing. Beispiel: sende nichts.",
      word: "nichts",
    },
    Left: {
      parts: ["Wert"],
      tooltip: "Die erste von zwei Möglichkeiten, in Haskell Left. Beispiel: links (Velocity 0.5 0).",
      word: "links",
    },
    Right: {
      parts: ["Wert"],
      tooltip: "Die zweite von zwei Möglichkeiten, in Haskell Right. Beispiel: rechts (Done ()).",
      word: "rechts",
    },
    Memory: {
      parts: ["Wert"],
      tooltip:
        "Was sich das Programm merkt. Als Eingabe wird es gelesen, als Ausgabe geschrieben. Beispiel: Memory True.",
    },
    Param: {
      parts: ["Wert"],
      tooltip: "Was sich alle Aufgaben des Programms zusammen merken. Beispiel: Param 0.",
    },
    Done: {parts: ["Ergebnis"], tooltip: "Beendet die Aufgabe mit einem Ergebnis. Beispiel: Done ()."},
  },
  charts: robot.charts,
  actuators: robot.actuators,
  makesAValue: name => `Macht einen Wert mit ${name || "einem Konstruktor"}. Beispiel: ${name || "Go"}.`,
  valueLabels: robot.values,
  whats: {
    ...robot.whats,
    Bool: "Ja oder Nein",
    Ordering: "Reihenfolge",
  },
  anyOf: {thing: "egal was", side: "egal welche Seite", "bumper event": "egal welches Ereignis"},
  samples: {
    pi: "Velocity 0 pi dreht in einer Sekunde halb herum",
    degreesToOrientation: "degreesToOrientation 90 ist eine Vierteldrehung nach links",
    orientationToDegrees: "orientationToDegrees (Orientation pi) ist 180",
    normOrientation: "normOrientation (goal - here) ist der kürzere Weg herum",
    positionToVec: "positionToVec (Position 3 4) ist ein Pfeil der Länge 5",
    vecToPosition: "vecToPosition (positionToVec here) ist wieder here",
    magnitudeVec: "magnitudeVec (positionToVec (Position 3 4)) ist 5",
    doubleToSeconds: "now + doubleToSeconds 2 ist zwei Sekunden später",
    centimetersToMeters: "centimetersToMeters 50 ist 0.5",
    abs: "abs (-2) ist 2",
    min: "min 2 3 ist 2",
    max: "max 2 3 ist 3",
    fromIntegral: "fromIntegral (length xs) / 2",
    not: "not True ist False",
    randomR: "randomR (0, pi) gen ist ein Winkel und der Zufall für das nächste Mal",
    random: "random gen ist ein Wert und der Zufall für das nächste Mal",
    show: "show 3 ist “3”",
    map: "map (… * 2) (Liste 1 2) ist Liste 2 4",
    filter: "filter (… > 1) (Liste 1 2) ist Liste 2",
    length: "length (Liste 5 6) ist 2",
    sum: "sum (Liste 1 2 3) ist 6",
    task: "task start run beginnt mit start und reagiert mit run bis Done",
    once: "once (Led1 Red) sendet es ein einziges Mal",
    parallel: "parallel left right tut beides und wartet auf beides",
    race: "race drive (wait 5) endet spätestens nach 5 Sekunden",
  },
}
