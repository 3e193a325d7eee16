/// One example for each name of the library that the toolbox shows, for its tooltip.

const samples: {readonly [name: string]: string} = {
  pi: "Velocity 0 pi turns half round in a second",
  degreesToOrientation: "degreesToOrientation 90 is a quarter turn to the left",
  orientationToDegrees: "orientationToDegrees (Orientation pi) is 180",
  normOrientation: "normOrientation (goal - here) is the shorter way round",
  positionToVec: "positionToVec (Position 3 4) is an arrow of length 5",
  vecToPosition: "vecToPosition (positionToVec here) is here again",
  magnitudeVec: "magnitudeVec (positionToVec (Position 3 4)) is 5",
  doubleToSeconds: "now + doubleToSeconds 2 is two seconds later",
  centimetersToMeters: "centimetersToMeters 50 is 0.5",
  abs: "abs (-2) is 2",
  min: "min 2 3 is 2",
  max: "max 2 3 is 3",
  fromIntegral: "fromIntegral (length xs) / 2",
  not: "not True is False",
  randomR: "randomR (0, pi) gen is an angle and the generator for the next one",
  random: "random gen is a value and the generator for the next one",
  show: "show 3 is “3”",
  map: "map (… * 2) (list 1 2) is list 2 4",
  filter: "filter (… > 1) (list 1 2) is list 2",
  length: "length (list 5 6) is 2",
  sum: "sum (list 1 2 3) is 6",
  task: "task start run begins with start and reacts with run until Done",
  once: "once (Led1 Red) sends it one time",
  parallel: "parallel left right does both and waits for both",
  race: "race drive (wait 5) ends after 5 seconds at the latest",
}

/// An example of a name with `args` inputs; for names that nobody has written one for, how it is called.
export function exampleOf(name: string, args: number): string {
  return samples[name] ?? [name, ..."abcdefghi".slice(0, args)].join(" ")
}
