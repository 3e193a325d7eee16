/// Words of the run tree: runs of a program in a room, what was changed between them, and their comparison.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds, count} = measuresOf("fr")

export const runs = {
  show: "Montrer les exécutions dans cette salle",
  empty: "Lance le programme : chaque exécution est gardée ici, avec une image de son chemin.",
  choose: "Choisis une exécution pour la revoir.",
  isRunning: "Arrête le programme pour voir une autre exécution.",
  run: (number: number) => `Exécution ${number}`,
  goOn: (number: number) => `Reprendre l’exécution ${number}`,
  otherProgram: (number: number) => `L’exécution ${number} avait un autre programme.`,
  showProgram: "Montrer son programme",
  continued: (run: number, at: number) => `continue l’exécution ${run} à ${seconds(at, 2)}`,
  changes: {
    same: "le même programme",
    layout: "seulement des commentaires ou la mise en page",
    value: (name: string, before: string, after: string) => `${name} : ${before} → ${after}`,
    added: {
      function: (name: string) => `nouvelle fonction ${name}`,
      type: (name: string) => `nouveau type ${name}`,
    },
    removed: (name: string) => `sans ${name}`,
    changed: (name: string) => `${name} a changé`,
    renamed: (before: string, after: string) => `${before} s’appelle maintenant ${after}`,
    more: (n: number) => count(n, {one: "et encore un changement", other: n => `et encore ${n} changements`}),
  },
  goals: (done: number, all: number) => `${done} buts sur ${all}`,
  compare: "Comparer avec",
  none: "aucune autre",
  compared: "comparée",
  paused: "en pause",
  /// How the path of each of two runs is drawn.
  lines: {shown: "trait continu", compared: "pointillés"},
  both: "Les deux exécutions",
  length: "Durée",
  way: "Chemin parcouru",
  goalStates: {
    open: "à faire",
    done: (at: number) => `réussi à ${seconds(at, 1)}`,
    missed: (at: number) => `manqué à ${seconds(at, 1)}`,
  },
  dropped: (n: number) =>
    count(n, {
      one: "Une exécution plus ancienne n’est plus gardée.",
      other: n => `${n} exécutions plus anciennes ne sont plus gardées.`,
    }),
} as const
