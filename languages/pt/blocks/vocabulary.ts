/// Rosy's own constructors and types, and an example for each name of the library that the toolbox shows, in Portuguese.
/// Constructors keep their Haskell names.

import type {Words} from "../../../codegen/src/words/index.ts"
import {robot} from "./robot.generated.ts"

export const vocabulary: Pick<
  Words,
  "constructors" | "charts" | "actuators" | "makesAValue" | "valueLabels" | "whats" | "anyOf" | "samples"
> = {
  constructors: {
    ...robot.constructors,
    Seconds: {parts: ["segundos"], tooltip: "Um tempo em segundos. Exemplo: Seconds 2."},
    Clock: {
      parts: ["horas", "minutos", "segundos", "milissegundos"],
      tooltip: "A hora do dia. Exemplo: Clock 8 30 0 0 é oito e meia.",
    },
    Just: {
      parts: ["valor"],
      tooltip: "Existe um valor, e é este. Em Haskell isso se chama Just. Exemplo: só 3.",
      word: "só",
    },
    Nothing: {
      parts: [],
      tooltip: "Não existe valor. Em Haskell isso se chama Nothing. Exemplo: envie nada.",
      word: "nada",
    },
    Left: {
      parts: ["valor"],
      tooltip: "A primeira de duas possibilidades, em Haskell Left. Exemplo: esquerda (Velocity 0.5 0).",
      word: "esquerda",
    },
    Right: {
      parts: ["valor"],
      tooltip: "A segunda de duas possibilidades, em Haskell Right. Exemplo: direita (Done ()).",
      word: "direita",
    },
    Memory: {
      parts: ["valor"],
      tooltip: "O que o programa lembra. Como entrada é lido, como saída é escrito. Exemplo: Memory True.",
    },
    Param: {
      parts: ["valor"],
      tooltip: "O que todas as tarefas do programa lembram juntas. Exemplo: Param 0.",
    },
    Done: {parts: ["resultado"], tooltip: "Termina a tarefa com um resultado. Exemplo: Done ()."},
  },
  charts: robot.charts,
  actuators: robot.actuators,
  makesAValue: name => `Faz um valor com ${name || "um construtor"}. Exemplo: ${name || "Go"}.`,
  valueLabels: robot.values,
  whats: {
    ...robot.whats,
    Bool: "sim ou não",
    Ordering: "ordem",
  },
  anyOf: {thing: "qualquer coisa", side: "qualquer lado", "bumper event": "qualquer evento"},
  samples: {
    pi: "Velocity 0 pi dá meia volta em um segundo",
    degreesToOrientation: "degreesToOrientation 90 é um quarto de volta para a esquerda",
    orientationToDegrees: "orientationToDegrees (Orientation pi) é 180",
    normOrientation: "normOrientation (goal - here) é o giro mais curto",
    positionToVec: "positionToVec (Position 3 4) é uma seta de comprimento 5",
    vecToPosition: "vecToPosition (positionToVec here) é here de novo",
    magnitudeVec: "magnitudeVec (positionToVec (Position 3 4)) é 5",
    doubleToSeconds: "now + doubleToSeconds 2 é dois segundos depois",
    centimetersToMeters: "centimetersToMeters 50 é 0.5",
    abs: "abs (-2) é 2",
    min: "min 2 3 é 2",
    max: "max 2 3 é 3",
    fromIntegral: "fromIntegral (length xs) / 2",
    not: "not True é False",
    randomR: "randomR (0, pi) gen é um ângulo e o gerador para a próxima vez",
    random: "random gen é um valor e o gerador para a próxima vez",
    show: "show 3 é “3”",
    map: "map (… * 2) (lista 1 2) é lista 2 4",
    filter: "filter (… > 1) (lista 1 2) é lista 2",
    length: "length (lista 5 6) é 2",
    sum: "sum (lista 1 2 3) é 6",
    task: "task start run começa com start e reage com run até Done",
    once: "once (Led1 Red) envia isso uma única vez",
    parallel: "parallel left right faz os dois e espera pelos dois",
    race: "race drive (wait 5) termina em no máximo 5 segundos",
  },
}
