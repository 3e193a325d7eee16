/// The preview of a change: where the robot would drive.

export const preview = {
  dragNumber: "Ziehen ändert die Zahl",
  show: "Zeigen, wohin eine Änderung führt",
  sentence: (what: string) => `Mit dieser Änderung würde der Roboter ${what}.`,
  and: (first: string, second: string) => `${first} und ${second}`,
  samePlace: "am selben Ort ankommen",
  samePlaceAt: (time: string) => `nach ${time} am selben Ort sein`,
  end: (where: string) => `${where} ankommen`,
  beAt: (where: string, time: string) => `nach ${time} ${where} sein`,
  further: (distance: string, side: string) => `${distance} weiter ${side}`,
  sides: {
    left: "links",
    right: "rechts",
    up: "oben",
    down: "unten",
    "up left": "oben links",
    "up right": "oben rechts",
    "down left": "unten links",
    "down right": "unten rechts",
  },
  bump: (n: number) => (n === 1 ? "einmal anstoßen" : n === 2 ? "zweimal anstoßen" : `${n}-mal anstoßen`),
  goals: (done: number, all: number) =>
    all === 1 ? "das Ziel erreichen" : `${done} von ${all} Zielen erreichen`,
  noGoal: (all: number) => (all === 1 ? "das Ziel verfehlen" : "kein Ziel erreichen"),
  unrepeatable:
    "In diesem Lauf wurde zu viel von Hand bewegt. Starte neu, um zu sehen, wohin eine Änderung führt.",
  /// The preview is shorter than the run.
  cut: (time: string) => `Nur die ersten ${time} sind zu sehen: Mehr auszurechnen dauert zu lange.`,
  fails: (time: string) => `nach ${time} mit einem Fehler stehen bleiben`,
  fixes: "Auswege",
  outcome: {
    trembles: (n: number) => `zittert an der Wand: stößt ${n}-mal an`,
    stands: "steht still",
    turns: "dreht sich auf der Stelle",
    drives: (distance: string) => `fährt ${distance}, ohne anzustoßen`,
    bumps: (n: number) => (n === 1 ? "stößt einmal an" : n === 2 ? "stößt zweimal an" : `stößt ${n}-mal an`),
    stays: "bleibt dort",
    onward: {
      left: "fährt nach links weiter",
      right: "fährt nach rechts weiter",
      up: "fährt nach oben weiter",
      down: "fährt nach unten weiter",
    },
    goals: (n: number) => (n === 1 ? "erreicht ein Ziel" : `erreicht ${n} Ziele`),
    fails: (time: string) => `bleibt nach ${time} mit einem Fehler stehen`,
    noBetter: "nicht besser als jetzt",
    trying: "wird ausprobiert …",
  },
  noneBetter: "Rosy hat den fertigen Ausweg in diesem Raum ausprobiert: Er ist nicht besser.",
} as const
