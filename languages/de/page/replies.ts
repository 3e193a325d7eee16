/// Replies of the robot's own programs in the console: the first word is whose reply it is.

import type {Words} from "../../../editor/src/words/index.ts"

export const replies: Words["replies"] = {
  answered: "antwortet:",
  Feedback: "noch dabei",
  Succeeded: "fertig",
  Rejected: "abgelehnt",
  Aborted: "aufgegeben",
  Cancelled: "abgebrochen",
  Unavailable: "das kann hier niemand",
  succeeded: {dock: "angedockt", navigateTo: "angekommen"},
  reasons: {
    "no dock is in sight": "keine Ladestation in Sicht",
    "something is in the way": "etwas ist im Weg",
    "it took too long": "es hat zu lange gedauert",
    "no way leads there": "kein Weg führt dorthin",
  },
}
