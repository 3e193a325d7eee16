/// The choices of a new learner, and the demonstration in French.

import type {Words} from "../../../editor/src/words/index.ts"

export const welcome: Words["welcome"] = {
  title: "Comment veux-tu commencer ?",
  show: {name: "Montre-moi", description: "Regarde un programme se construire : 20 secondes."},
  lesson: {name: "Leçon 1", description: "Fais-le toi-même, pas à pas."},
  example: {name: "Commencer par un exemple", description: "Ouvre un programme qui marche et change-le."},
  empty: {name: "Programme vide", description: "Construis quelque chose à toi."},
  demonstration: "Montre-moi",
  steps: [
    "Voici un programme vide. simuler lance ce qu’on y met.",
    "Un bloc dit à quelle vitesse rouler : Velocity, 0.3 mètre par seconde. À droite, c’est du Haskell.",
    "Maintenant il est dans simuler : il sera donc lancé.",
    "Démarrer : le robot roule.",
    "Un autre nombre : maintenant il tourne aussi et roule en cercle.",
  ],
  stop: "Ne plus montrer",
}
