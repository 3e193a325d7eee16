/// The preview of a change: where the robot would drive.

export const preview = {
  dragNumber: "Drag to change the number",
  show: "Show where a change leads",
  /// `what` are the parts below.
  sentence: (what: string) => `With this change the robot would ${what}.`,
  and: (first: string, second: string) => `${first} and ${second}`,
  samePlace: "end in the same place",
  samePlaceAt: (time: string) => `be in the same place after ${time}`,
  end: (where: string) => `end ${where}`,
  beAt: (where: string, time: string) => `be ${where} after ${time}`,
  further: (distance: string, side: string) => `${distance} further ${side}`,
  sides: {
    left: "left",
    right: "right",
    up: "up",
    down: "down",
    "up left": "up and to the left",
    "up right": "up and to the right",
    "down left": "down and to the left",
    "down right": "down and to the right",
  },
  bump: (n: number) => (n === 1 ? "bump once" : n === 2 ? "bump twice" : `bump ${n} times`),
  goals: (done: number, all: number) => (all === 1 ? "reach the goal" : `reach ${done} of ${all} goals`),
  noGoal: (all: number) => (all === 1 ? "miss the goal" : "reach no goal"),
  unrepeatable: "Too much was done by hand in this run to show where a change leads. Run it again.",
  /// The preview is shorter than the run.
  cut: (time: string) => `Only the first ${time} are shown: more takes too long to compute.`,
  fails: (time: string) => `stop with a mistake after ${time}`,
  fixes: "Ways to mend it",
  /// What the robot does in a fix's preview, below its picture.
  outcome: {
    trembles: (n: number) => `trembles at the wall: ${n} bumps`,
    stands: "stands still",
    turns: "turns on the spot",
    drives: (distance: string) => `drives ${distance} without a bump`,
    bumps: (n: number) => (n === 1 ? "bumps once" : n === 2 ? "bumps twice" : `bumps ${n} times`),
    stays: "stays there",
    onward: {
      left: "drives on to the left",
      right: "drives on to the right",
      up: "drives on upwards",
      down: "drives on downwards",
    },
    goals: (n: number) => (n === 1 ? "reaches a goal" : `reaches ${n} goals`),
    fails: (time: string) => `stops with a mistake after ${time}`,
    /// A fix that was offered before its run was known.
    noBetter: "no better than now",
    trying: "is being tried …",
  },
  /// All ready-made fixes were tried.
  noneBetter: "Rosy has tried the ready-made way out in this room: it is no better.",
} as const
