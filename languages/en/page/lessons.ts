/// Lessons: their panel and their list.

const seconds = (time: number | null) => (time === null ? "" : ` at ${time.toFixed(1)} s`)
const measure = (value: number | null) => Math.abs(value ?? 0).toFixed(2)

export const lessons = {
  title: "Lessons",
  lead: "Short lessons, one new idea each. You go on where you were.",
  loading: "Looking for the lessons…",
  failed: "The lessons could not be loaded. Rosy's service does not answer; try again in a moment.",
  missing: (name: string) => `There is no lesson called ${name}.`,
  damaged: (name: string, at: string) =>
    `${name} cannot be opened as a lesson: something is missing or wrong at ${at}.`,
  damagedHint: "Ask for the file again, or mend it there and open it once more.",
  newer: (name: string) => `${name} cannot be opened: it is a lesson of a newer Rosy.`,
  newerHint: (version: number, newest: number) =>
    `Its version is ${version}, and this Rosy reads up to ${newest}; update Rosy to open it.`,
  /// In place of a file's name.
  linked: "This link",
  link: "Link to this lesson",
  courses: {
    drive: "Drive: a program is a value",
    react: "React: things happen",
    remember: "Remember: what was",
    tasks: "Tasks: one thing after another",
    algebra: "Algebra: a function has a graph",
  },
  otherLessons: "More lessons",
  finished: "finished",
  stepsDone: (done: number, all: number) => `${done} of ${all} steps`,
  panel: "Lesson",
  number: (n: number) => `Lesson ${n}`,
  leave: "Leave the lesson",
  kinds: {predict: "Guess", run: "Run", investigate: "Look closely", modify: "Change", make: "Make"},
  yourGuess: (answer: string) => `Your guess: ${answer}`,
  done: "done",
  open: "still open",
  missed: "not yet",
  go: "Next step",
  nextLesson: "Next lesson",
  freePlay: "Play freely with this program",
  again: "Begin this step again",
  hint: "Give me a hint",
  moreHint: "One more hint",
  /// A hint about a function of the learner's.
  notRun: (name: string) => `\`${name}\` is defined, but nothing uses it yet. Does \`simulate\` run it?`,
  /// A hint about a type of the check that the program lacks.
  notTaken: (type: string) => `No function of yours takes a value of type \`${type}\` yet.`,
  notGiven: (type: string) => `Nothing in your program gives a value of type \`${type}\` yet.`,
  mendFirst: "The program has a mistake. Mend it first: a card says what to do.",
  pressRun: "Press Run, and the checks are made while it drives.",
  letItRun: (time: number) => `Let it run for ${time} seconds.`,
  learned: "What you have learned",
  wellDone: "Lesson finished!",
  /// What was seen in a run, by the word of the service (protocol §9).
  seen: {
    "goal-late": (_n: number | null, time: number | null, name: string) =>
      `“${name}” was done only${seconds(time)}.`,
    happened: (_n: number | null, time: number | null, name: string) =>
      `\`${name}\` happened${seconds(time)}.`,
    "goal-missed": (_n: number | null, time: number | null, name: string) =>
      `“${name}” was missed${seconds(time)}.`,
    "goal-open": (_n: number | null, time: number | null, name: string) =>
      `“${name}” was still open${seconds(time)}.`,
    away: (n: number | null, time: number | null) =>
      `It was ${measure(n)} metres away from it${seconds(time)}.`,
    turned: (n: number | null, time: number | null) =>
      `It looked ${Math.round(Math.abs(n ?? 0))} degrees too far to the ${(n ?? 0) > 0 ? "right" : "left"}${seconds(time)}.`,
    "too-short": (_n: number | null, time: number | null) => `The run ended before ${time ?? 0} s.`,
    moved: (_n: number | null, time: number | null) => `It was still moving${seconds(time)}.`,
    drove: (n: number | null) => `It drove ${measure(n)} metres.`,
    fastest: (n: number | null, time: number | null) =>
      `It was at most ${measure(n)} metres a second fast in ${time ?? 0} s.`,
    "fastest-back": (n: number | null, time: number | null) =>
      (n ?? 0) === 0
        ? "It did not drive backwards."
        : `Backwards it was at most ${measure(n)} metres a second fast in ${time ?? 0} s.`,
    "came-far": (n: number | null) => `It came ${measure(n)} metres away from its start.`,
    "not-back": (n: number | null) => `It ended ${measure(n)} metres from its start.`,
    "ends-far": (n: number | null) => `It ended ${measure(n)} metres from there.`,
    "not-faster": (_n: number | null, time: number | null, name: string) =>
      `\`${name}\` happened${seconds(time)}, and it did not get faster.`,
    varied: (n: number | null) => `${n ?? 0} different values were sent.`,
    "not-again": (n: number | null, _t: number | null, name: string) =>
      `\`${name}\` happened ${n ?? 0} times, and it was never as at first again.`,
    miscounted: (n: number | null, time: number | null, name: string) =>
      `It said ${name}${seconds(time)}, and it was number ${n ?? 0}.`,
    "not-measured": (n: number | null) =>
      `It drove ${Math.round(n ?? 0)} centimetres, and no such number was said.`,
    "goes-on": (_n: number | null, time: number | null) => `The program was not over${seconds(time)}.`,
    "not-said": (_n: number | null, _t: number | null, name: string) => `“${name}” was not said.`,
    "not-sent": (_n: number | null, _t: number | null, name: string) => `\`${name}\` was not sent.`,
    "not-happened": (n: number | null, _t: number | null, name: string) =>
      (n ?? 0) === 0 ? `\`${name}\` did not happen.` : `\`${name}\` happened only ${n} times.`,
    "no-answer": (_n: number | null, time: number | null, name: string) =>
      `\`${name}\` happened${seconds(time)}, and what should follow did not.`,
    answer: (_n: number | null, time: number | null, name: string) =>
      `\`${name}\` happened${seconds(time)}, and something followed that should not.`,
    functions: (n: number | null) => `The program has ${n ?? 0} functions of its own.`,
    "gives-not": (_n: number | null, _t: number | null, name: string) => `\`${name}\` does not send that.`,
    "no-function": (_n: number | null, _t: number | null, name: string) =>
      `No function is about \`${name}\`.`,
    "not-never-falls": (_n: number | null, time: number | null) =>
      `A wheel hung over a hole${seconds(time)}.`,
    "not-never-pushes": (n: number | null) => `It pushed against something for ${measure(n)} seconds.`,
    "not-reaches-goal": (_n: number | null, time: number | null) => `It was not at the goal${seconds(time)}.`,
    "not-returns-to-start": (n: number | null) => `It came back to ${measure(n)} metres from the start.`,
    "not-covers": (n: number | null) => `It was on ${Math.round(n ?? 0)} % of the floor.`,
    "not-room-goals": (_n: number | null, time: number | null) =>
      `A goal of the room was open${seconds(time)}.`,
  },
} as const
