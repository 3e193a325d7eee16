/// Replies of the robot's own programs in the console: the first word is whose reply it is.

import type {Words} from "../../../editor/src/words/index.ts"

export const replies: Words["replies"] = {
  answered: "respondeu:",
  Feedback: "ainda em andamento",
  Succeeded: "pronto",
  Rejected: "recusado",
  Aborted: "desistiu",
  Cancelled: "parado",
  Unavailable: "ninguém aqui sabe fazer isso",
  succeeded: {dock: "na base", navigateTo: "chegou"},
  reasons: {
    "no dock is in sight": "nenhuma base à vista",
    "something is in the way": "há algo no caminho",
    "it took too long": "demorou demais",
    "no way leads there": "nenhum caminho leva até lá",
  },
}
