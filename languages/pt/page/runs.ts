/// Words of the run tree: runs of a program in a room, what was changed between them, and their comparison.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds, count} = measuresOf("pt")

export const runs = {
  show: "Mostrar as execuções nesta sala",
  empty: "Execute o programa: cada execução fica guardada aqui, com uma imagem do seu caminho.",
  choose: "Escolha uma execução para vê-la de novo.",
  isRunning: "Pare o programa para ver outra execução.",
  run: (number: number) => `Execução ${number}`,
  goOn: (number: number) => `Seguir com a execução ${number}`,
  otherProgram: (number: number) => `A execução ${number} tinha outro programa.`,
  showProgram: "Mostrar o programa dela",
  continued: (run: number, at: number) => `continua a execução ${run} em ${seconds(at, 2)}`,
  changes: {
    same: "o mesmo programa",
    layout: "só comentários ou disposição",
    value: (name: string, before: string, after: string) => `${name}: ${before} → ${after}`,
    added: {function: (name: string) => `nova função ${name}`, type: (name: string) => `novo tipo ${name}`},
    removed: (name: string) => `sem ${name}`,
    changed: (name: string) => `${name} mudou`,
    renamed: (before: string, after: string) => `${before} agora se chama ${after}`,
    more: (n: number) => count(n, {one: "e mais uma mudança", other: n => `e mais ${n} mudanças`}),
  },
  goals: (done: number, all: number) => `${done} de ${all} metas`,
  compare: "Comparar com",
  none: "nenhuma outra",
  compared: "comparada",
  paused: "em pausa",
  /// How the path of each of two runs is drawn.
  lines: {shown: "linha contínua", compared: "linha pontilhada"},
  both: "As duas execuções",
  length: "Duração",
  way: "Caminho percorrido",
  goalStates: {
    open: "não alcançada",
    done: (at: number) => `alcançada em ${seconds(at, 1)}`,
    missed: (at: number) => `perdida em ${seconds(at, 1)}`,
  },
  dropped: (n: number) =>
    count(n, {
      one: "Uma execução mais antiga não está mais guardada.",
      other: n => `${n} execuções mais antigas não estão mais guardadas.`,
    }),
} as const
