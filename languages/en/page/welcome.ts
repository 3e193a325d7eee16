/// The choices of a new learner, and the demonstration.

export const welcome = {
  title: "How do you want to begin?",
  show: {name: "Show me", description: "Watch a program being built: 20 seconds."},
  lesson: {name: "Lesson 1", description: "Do it yourself, step by step."},
  example: {name: "Start with an example", description: "Open a program that works and change it."},
  empty: {name: "Empty program", description: "Build something of your own."},
  /// Name of the program that the demonstration builds.
  demonstration: "Show me",
  /// What each step of the demonstration shows.
  steps: [
    "This is an empty program. simulate will run what is put into it.",
    "A block says how fast to drive: Velocity, 0.3 metres in a second. On the right it is Haskell.",
    "Now it lies in simulate, so it will run.",
    "Run: the robot drives.",
    "Another number: now it turns as well, and drives in a circle.",
  ],
  stop: "Stop showing",
} as const
