/// Replies of the robot's own programs in the console: the first word is whose reply it is.

import type {Words} from "../../../editor/src/words/index.ts"

export const replies: Words["replies"] = {
  answered: "a répondu :",
  Feedback: "encore en cours",
  Succeeded: "terminé",
  Rejected: "refusé",
  Aborted: "abandonné",
  Cancelled: "arrêté",
  Unavailable: "personne ne sait le faire ici",
  succeeded: {dock: "dans la station", navigateTo: "arrivé"},
  reasons: {
    "no dock is in sight": "aucune station en vue",
    "something is in the way": "quelque chose est sur le chemin",
    "it took too long": "cela a duré trop longtemps",
    "no way leads there": "aucun chemin n’y mène",
  },
}
