/// Several robots in one room.

export const companions = {
  more: "More robots",
  hint: "Up to three more robots in this room, each with a program of its own. They bump into each other.",
  lead: "Each drives by its own program; they see and bump into each other. Drag them to their places in the room. They start with the next run.",
  about: "Trail, pen, charts and the questions why are about the first robot.",
  none: "The first robot is alone in this room.",
  robot: (n: number) => `Robot ${n}`,
  one: "One more robot",
  program: (n: number) => `Program of robot ${n}`,
  openProgram: "The open program",
  takeAway: (n: number) => `Take robot ${n} away`,
  place: (n: number) => `Place of robot ${n}`,
  full: (most: number) => `There can be at most ${most} more robots.`,
  noPlace: "There is no free floor for one more robot in this room.",
  taken: "There is no room for a robot there. It stays where it was.",
  said: (n: number, text: string) => `Robot ${n}: ${text}`,
  ended: (n: number) => `Robot ${n} has finished its program and stands still.`,
  failed: (n: number, why: string) => `Robot ${n} stands still: ${why}`,
  noPreview:
    "With more robots in the room no preview is shown: where they drive depends on each other. Press Run.",
} as const
