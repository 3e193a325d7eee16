/// Plusieurs robots dans une salle.

import type {Words} from "../../../editor/src/words/index.ts"

export const companions: Words["companions"] = {
  more: "Plus de robots",
  hint: "Jusqu’à trois robots de plus dans cette salle, chacun avec son programme. Ils se heurtent.",
  lead: "Chacun roule selon son propre programme ; ils se voient et se heurtent. Glisse-les à leur place dans la salle. Ils partent à la prochaine exécution.",
  about: "La trace, le stylo, les courbes et les questions « pourquoi » concernent le premier robot.",
  none: "Le premier robot est seul dans cette salle.",
  robot: n => `Robot ${n}`,
  one: "Un robot de plus",
  program: n => `Programme du robot ${n}`,
  openProgram: "Le programme ouvert",
  takeAway: n => `Enlever le robot ${n}`,
  place: n => `Place du robot ${n}`,
  full: most => `Il peut y avoir au plus ${most} robots de plus.`,
  noPlace: "Il n’y a pas de sol libre pour un robot de plus dans cette salle.",
  taken: "Il n’y a pas de place pour un robot à cet endroit. Il reste où il était.",
  said: (n, text) => `Robot ${n} : ${text}`,
  ended: n => `Le robot ${n} a fini son programme et reste immobile.`,
  failed: (n, why) => `Le robot ${n} reste immobile : ${why}`,
  noPreview:
    "Avec plus de robots dans la salle, il n’y a pas d’aperçu : le chemin de chacun dépend des autres. Appuie sur Démarrer.",
}
