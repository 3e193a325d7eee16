/// Enregistrements d’exécutions sur de vrais robots.

import type {Words} from "../../../editor/src/words/index.ts"

export const recordings: Words["recordings"] = {
  open: "Ouvrir un enregistrement…",
  openHint: "Une exécution sur un vrai robot, en fichier MCAP sur cet ordinateur",
  again: "Revoir cette exécution",
  where: file => `Cette exécution est enregistrée sur l’ordinateur de Rosy : ${file}`,
  run: number => `Exécution ${number}, enregistrée`,
  on: robot => `sur le robot ${robot}`,
  tooLarge: name => `${name} est trop grand pour l’enregistrement d’une exécution.`,
  notSent: name => `${name} n’est pas arrivé à Rosy. Essaie encore une fois.`,
  notConnected: "Rosy est injoignable. Ouvre l’enregistrement quand il sera revenu.",
  driving: "Un robot roule. Arrête-le, puis ouvre l’enregistrement.",
  refused:
    "Le programme de cet enregistrement vient d’une autre version de Rosy ; l’exécution ne peut donc pas être montrée.",
}
