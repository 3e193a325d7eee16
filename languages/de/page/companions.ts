/// Mehrere Roboter in einem Raum.

import type {Words} from "../../../editor/src/words/index.ts"

export const companions: Words["companions"] = {
  more: "Mehr Roboter",
  hint: "Bis zu drei weitere Roboter in diesem Raum, jeder mit einem eigenen Programm. Sie stoßen aneinander.",
  lead: "Jeder fährt nach seinem eigenen Programm; sie sehen einander und stoßen aneinander. Zieh sie im Raum an ihre Plätze. Sie starten mit dem nächsten Lauf.",
  about: "Spur, Stift, Kurven und die Fragen nach dem Warum gelten dem ersten Roboter.",
  none: "Der erste Roboter ist allein in diesem Raum.",
  robot: n => `Roboter ${n}`,
  one: "Noch ein Roboter",
  program: n => `Programm von Roboter ${n}`,
  openProgram: "Das offene Programm",
  takeAway: n => `Roboter ${n} wegnehmen`,
  place: n => `Platz von Roboter ${n}`,
  full: most => `Es können höchstens ${most} weitere Roboter da sein.`,
  noPlace: "In diesem Raum ist kein freier Boden für noch einen Roboter.",
  taken: "Dort ist kein Platz für einen Roboter. Er bleibt, wo er war.",
  said: (n, text) => `Roboter ${n}: ${text}`,
  ended: n => `Roboter ${n} ist mit seinem Programm fertig und steht still.`,
  failed: (n, why) => `Roboter ${n} steht still: ${why}`,
  noPreview:
    "Mit mehr Robotern im Raum gibt es keine Vorschau: Wohin einer fährt, hängt von den anderen ab. Drück auf Start.",
}
