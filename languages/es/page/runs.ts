/// Words of the run tree: runs of a program in a room, what was changed between them, and their comparison.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds, count} = measuresOf("es")

export const runs = {
  show: "Mostrar las ejecuciones en esta sala",
  empty: "Ejecuta el programa: cada ejecución se guarda aquí, con una imagen de su camino.",
  choose: "Elige una ejecución para verla otra vez.",
  isRunning: "Detén el programa para ver otra ejecución.",
  run: (number: number) => `Ejecución ${number}`,
  goOn: (number: number) => `Seguir con la ejecución ${number}`,
  otherProgram: (number: number) => `La ejecución ${number} tenía otro programa.`,
  showProgram: "Mostrar su programa",
  continued: (run: number, at: number) => `sigue la ejecución ${run} a los ${seconds(at, 2)}`,
  changes: {
    same: "el mismo programa",
    layout: "solo comentarios o disposición",
    value: (name: string, before: string, after: string) => `${name}: ${before} → ${after}`,
    added: {
      function: (name: string) => `función nueva ${name}`,
      type: (name: string) => `tipo nuevo ${name}`,
    },
    removed: (name: string) => `sin ${name}`,
    changed: (name: string) => `${name} cambió`,
    renamed: (before: string, after: string) => `${before} ahora se llama ${after}`,
    more: (n: number) => count(n, {one: "y un cambio más", other: n => `y ${n} cambios más`}),
  },
  goals: (done: number, all: number) => `${done} de ${all} objetivos`,
  compare: "Comparar con",
  none: "ninguna otra",
  compared: "comparada",
  paused: "en pausa",
  /// How the path of each of two runs is drawn.
  lines: {shown: "línea continua", compared: "línea punteada"},
  both: "Las dos ejecuciones",
  length: "Duración",
  way: "Camino recorrido",
  goalStates: {
    open: "no logrado",
    done: (at: number) => `logrado a los ${seconds(at, 1)}`,
    missed: (at: number) => `no logrado a los ${seconds(at, 1)}`,
  },
  dropped: (n: number) =>
    count(n, {
      one: "Una ejecución más antigua ya no se guarda.",
      other: n => `${n} ejecuciones más antiguas ya no se guardan.`,
    }),
} as const
