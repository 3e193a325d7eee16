/// Replies of the robot's own programs in the console: the first word is whose reply it is.

import type {Words} from "../../../editor/src/words/index.ts"

export const replies: Words["replies"] = {
  answered: "respondió:",
  Feedback: "aún en ello",
  Succeeded: "terminado",
  Rejected: "rechazado",
  Aborted: "abandonado",
  Cancelled: "detenido",
  Unavailable: "aquí nadie sabe hacerlo",
  succeeded: {dock: "en la base", navigateTo: "ha llegado"},
  reasons: {
    "no dock is in sight": "no se ve ninguna base",
    "something is in the way": "algo está en el camino",
    "it took too long": "tardó demasiado",
    "no way leads there": "ningún camino lleva allí",
  },
}
