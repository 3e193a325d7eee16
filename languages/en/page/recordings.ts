/// Recordings of runs on real robots.

export const recordings = {
  open: "Open a recording…",
  openHint: "A run on a real robot, as an MCAP file on this computer",
  again: "Look at this run again",
  where: (file: string) => `This run is recorded on the computer of Rosy: ${file}`,
  run: (number: number) => `Run ${number}, recorded`,
  on: (robot: string) => `on the robot ${robot}`,
  tooLarge: (name: string) => `${name} is too large for a recording of a run.`,
  notSent: (name: string) => `${name} could not be sent to Rosy. Try it again.`,
  notConnected: "Rosy cannot be reached. Open the recording when it is back.",
  driving: "A robot is driving. Stop it, and open the recording then.",
  refused: "The program of this recording is of another version of Rosy, so the run cannot be shown.",
} as const
