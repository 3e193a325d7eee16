/// Challenges: their list, and the stars of a run.

export const challenges = {
  title: "Challenges",
  lead: "One goal, up to three stars. Your best run counts.",
  loading: "Looking for the challenges…",
  failed: "The challenges could not be loaded. Rosy's service does not answer; try again in a moment.",
  number: (n: number) => `Challenge ${n}`,
  leave: "Leave the challenge",
  stars: (earned: number, all: number) => `${earned} of ${all} stars`,
  best: "Your best run:",
  thisRun: (earned: number, all: number) => `This run: ${earned} of ${all} stars.`,
  allStars: "That is all of them!",
  /// `text` is what is missing, as the challenge says it.
  next: (text: string) => `For one more star: ${text}.`,
  nextChallenge: "Next challenge",
} as const
