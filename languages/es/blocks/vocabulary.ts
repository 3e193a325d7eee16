/// Rosy's own constructors and types, and an example for each name of the library that the toolbox shows, in Spanish.
/// Constructors keep their Haskell names.

import type {Words} from "../../../codegen/src/words/index.ts"
import {robot} from "./robot.generated.ts"

export const vocabulary: Pick<
  Words,
  "constructors" | "charts" | "actuators" | "makesAValue" | "valueLabels" | "whats" | "anyOf" | "samples"
> = {
  constructors: {
    ...robot.constructors,
    Seconds: {parts: ["segundos"], tooltip: "Un tiempo en segundos. Ejemplo: Seconds 2."},
    Clock: {
      parts: ["horas", "minutos", "segundos", "milisegundos"],
      tooltip: "La hora del día. Ejemplo: Clock 8 30 0 0 son las ocho y media.",
    },
    Just: {
      parts: ["valor"],
      tooltip: "Hay un valor, y es este. En Haskell se llama Just. Ejemplo: solo 3.",
      word: "solo",
    },
    Nothing: {
      parts: [],
      tooltip: "No hay ningún valor. En Haskell se llama Nothing. Ejemplo: enviar nada.",
      word: "nada",
    },
    Left: {
      parts: ["valor"],
      tooltip: "La primera de dos posibilidades, en Haskell Left. Ejemplo: izquierda (Velocity 0.5 0).",
      word: "izquierda",
    },
    Right: {
      parts: ["valor"],
      tooltip: "La segunda de dos posibilidades, en Haskell Right. Ejemplo: derecha (Done ()).",
      word: "derecha",
    },
    Memory: {
      parts: ["valor"],
      tooltip:
        "Lo que el programa recuerda. Como entrada se lee; como salida se escribe. Ejemplo: Memory True.",
    },
    Param: {
      parts: ["valor"],
      tooltip: "Lo que todas las tareas del programa recuerdan juntas. Ejemplo: Param 0.",
    },
    Done: {parts: ["resultado"], tooltip: "Termina la tarea con un resultado. Ejemplo: Done ()."},
  },
  charts: robot.charts,
  actuators: robot.actuators,
  makesAValue: name => `Crea un valor con ${name || "un constructor"}. Ejemplo: ${name || "Go"}.`,
  valueLabels: robot.values,
  whats: {
    ...robot.whats,
    Bool: "verdadero o falso",
    Ordering: "orden",
  },
  anyOf: {thing: "cualquier cosa", side: "cualquier lado", "bumper event": "cualquier evento Bumper"},
  samples: {
    pi: "Velocity 0 pi da media vuelta en un segundo",
    degreesToOrientation: "degreesToOrientation 90 es un cuarto de vuelta a la izquierda",
    orientationToDegrees: "orientationToDegrees (Orientation pi) es 180",
    normOrientation: "normOrientation (goal - here) es el giro más corto",
    positionToVec: "positionToVec (Position 3 4) es una flecha de longitud 5",
    vecToPosition: "vecToPosition (positionToVec here) es otra vez here",
    magnitudeVec: "magnitudeVec (positionToVec (Position 3 4)) es 5",
    doubleToSeconds: "now + doubleToSeconds 2 es dos segundos después",
    centimetersToMeters: "centimetersToMeters 50 es 0.5",
    abs: "abs (-2) es 2",
    min: "min 2 3 es 2",
    max: "max 2 3 es 3",
    fromIntegral: "fromIntegral (length xs) / 2",
    not: "not True es False",
    randomR: "randomR (0, pi) gen es un ángulo y el generador para el siguiente",
    random: "random gen es un valor y el generador para el siguiente",
    show: "show 3 es “3”",
    map: "map (… * 2) (lista 1 2) es lista 2 4",
    filter: "filter (… > 1) (lista 1 2) es lista 2",
    length: "length (lista 5 6) es 2",
    sum: "sum (lista 1 2 3) es 6",
    task: "task start run empieza con start y reacciona con run hasta Done",
    once: "once (Led1 Red) lo envía una sola vez",
    parallel: "parallel left right hace las dos cosas y espera a las dos",
    race: "race drive (wait 5) termina como mucho a los 5 segundos",
  },
}
