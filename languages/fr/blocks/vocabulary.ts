/// Rosy's own constructors and types, and an example for each name of the library that the toolbox shows, in French.
/// Constructors keep their Haskell names.

import type {Words} from "../../../codegen/src/words/index.ts"
import {robot} from "./robot.generated.ts"

export const vocabulary: Pick<
  Words,
  "constructors" | "charts" | "actuators" | "makesAValue" | "valueLabels" | "whats" | "anyOf" | "samples"
> = {
  constructors: {
    ...robot.constructors,
    Seconds: {parts: ["secondes"], tooltip: "Un temps en secondes. Exemple : Seconds 2."},
    Clock: {
      parts: ["heures", "minutes", "secondes", "millisecondes"],
      tooltip: "L’heure de la journée. Exemple : Clock 8 30 0 0 est huit heures et demie.",
    },
    Just: {
      parts: ["valeur"],
      tooltip: "Il y a une valeur, et la voici. En Haskell, cela s’appelle Just. Exemple : juste 3.",
      word: "juste",
    },
    Nothing: {
      parts: [],
      tooltip: "Il n’y a pas de valeur. En Haskell, cela s’appelle Nothing. Exemple : envoyer rien.",
      word: "rien",
    },
    Left: {
      parts: ["valeur"],
      tooltip: "La première de deux possibilités, en Haskell Left. Exemple : gauche (Velocity 0.5 0).",
      word: "gauche",
    },
    Right: {
      parts: ["valeur"],
      tooltip: "La seconde de deux possibilités, en Haskell Right. Exemple : droite (Done ()).",
      word: "droite",
    },
    Memory: {
      parts: ["valeur"],
      tooltip:
        "Ce que le programme retient. Comme entrée, il est lu ; comme sortie, il est écrit. Exemple : Memory True.",
    },
    Param: {
      parts: ["valeur"],
      tooltip: "Ce que toutes les tâches du programme retiennent ensemble. Exemple : Param 0.",
    },
    Done: {parts: ["résultat"], tooltip: "Termine la tâche avec un résultat. Exemple : Done ()."},
  },
  charts: robot.charts,
  actuators: robot.actuators,
  makesAValue: name => `Fabrique une valeur avec ${name || "un constructeur"}. Exemple : ${name || "Go"}.`,
  valueLabels: robot.values,
  whats: {
    ...robot.whats,
    Bool: "oui ou non",
    Ordering: "ordre",
  },
  anyOf: {
    thing: "n’importe quoi",
    side: "n’importe quel côté",
    "bumper event": "n’importe quel événement",
  },
  samples: {
    pi: "Velocity 0 pi fait un demi-tour en une seconde",
    degreesToOrientation: "degreesToOrientation 90 est un quart de tour à gauche",
    orientationToDegrees: "orientationToDegrees (Orientation pi) donne 180",
    normOrientation: "normOrientation (goal - here) est le tour le plus court",
    positionToVec: "positionToVec (Position 3 4) est une flèche de longueur 5",
    vecToPosition: "vecToPosition (positionToVec here) est de nouveau here",
    magnitudeVec: "magnitudeVec (positionToVec (Position 3 4)) donne 5",
    doubleToSeconds: "now + doubleToSeconds 2 est deux secondes plus tard",
    centimetersToMeters: "centimetersToMeters 50 donne 0.5",
    abs: "abs (-2) donne 2",
    min: "min 2 3 donne 2",
    max: "max 2 3 donne 3",
    fromIntegral: "fromIntegral (length xs) / 2",
    not: "not True donne False",
    randomR: "randomR (0, pi) gen donne un angle et le générateur pour la fois suivante",
    random: "random gen donne une valeur et le générateur pour la fois suivante",
    show: "show 3 donne “3”",
    map: "map (… * 2) (liste 1 2) donne liste 2 4",
    filter: "filter (… > 1) (liste 1 2) donne liste 2",
    length: "length (liste 5 6) donne 2",
    sum: "sum (liste 1 2 3) donne 6",
    task: "task start run commence avec start et réagit avec run jusqu’à Done",
    once: "once (Led1 Red) l’envoie une seule fois",
    parallel: "parallel left right fait les deux et attend les deux",
    race: "race drive (wait 5) se termine au plus tard après 5 secondes",
  },
}
