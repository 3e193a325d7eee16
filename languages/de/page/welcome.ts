/// The choices of a new learner, and the demonstration in German.

import type {Words} from "../../../editor/src/words/index.ts"

export const welcome: Words["welcome"] = {
  title: "Wie möchtest du anfangen?",
  show: {name: "Zeig es mir", description: "Sieh zu, wie ein Programm entsteht: 20 Sekunden."},
  lesson: {name: "Lektion 1", description: "Mach es selbst, Schritt für Schritt."},
  example: {name: "Mit einem Beispiel anfangen", description: "Öffne ein fertiges Programm und ändere es."},
  empty: {name: "Leeres Programm", description: "Baue etwas Eigenes."},
  demonstration: "Zeig es mir",
  steps: [
    "Das ist ein leeres Programm. simuliere führt aus, was darin liegt.",
    "Ein Block sagt, wie schnell gefahren wird: Velocity, 0.3 Meter in der Sekunde. Rechts steht es als Haskell.",
    "Jetzt liegt er in simuliere, also läuft er.",
    "Start: Der Roboter fährt.",
    "Eine andere Zahl: Jetzt dreht er sich auch und fährt im Kreis.",
  ],
  stop: "Nicht weiter zeigen",
}
