/// Worksheets of the first eight lessons, an activity without a computer for each, and two written tests, in English. The build of the guide reads it; it is Markdown.

export interface SheetWords {
  readonly tasks: readonly {readonly say: string; readonly answer: string}[]
  readonly unplugged: {readonly title: string; readonly steps: readonly string[]}
}

export interface QuestionWords {
  readonly ask: string
  readonly answers?: readonly string[]
  readonly why: string
}

export interface WorksheetWords {
  readonly labels: {
    readonly sheet: (lesson: string) => string
    readonly slides: (course: string) => string
    readonly name: string
    readonly answer: string
    readonly forTeachers: string
    readonly unplugged: (title: string) => string
    readonly test: (number: number) => string
    readonly testLead: string
    readonly marking: string
  }
  readonly cards: {readonly title: string; readonly lead: string}
  readonly poster: {
    readonly title: string
    readonly lead: string
    /// Before the robots' types.
    readonly roles: {readonly event: string; readonly state: string; readonly command: string}
  }
  readonly sheets: Readonly<Record<string, SheetWords>>
  /// The right answers are in `examples/written-tests.json`.
  readonly tests: Readonly<Record<string, readonly QuestionWords[]>>
}

export const worksheets: WorksheetWords = {
  labels: {
    sheet: lesson => `Worksheet: ${lesson}`,
    slides: course => `Slides: ${course}`,
    name: "Name:",
    answer: "Your answer:",
    forTeachers: "For the teacher: answers",
    unplugged: title => `Without a computer: ${title}`,
    test: number => `Test ${number}`,
    testLead:
      "20 minutes, on paper, without a computer. One point for each question. Tick one answer, or write a number.",
    marking:
      "Type the answers into a table with a name, the test and the answers in order, and save it as CSV. `./rosy class marks answers.csv -o marks.csv` adds the points. A number may differ a little where the key says so.",
  },
  cards: {
    title: "Cards of blocks",
    lead: "Cards for the blocks of the toolbox: in words, in the colour of their family, and in Haskell. Blocks that only stand inside others, and large examples, have none. Printed, eight of them fill a sheet; choose the sheets you need and cut them. Pupils lay a program with them, read each other's, and type it.",
  },
  poster: {
    title: "The language on one sheet",
    lead: "The blocks of the cards with their Haskell, for the wall. It fills a sheet of A3 across; let the printer make it smaller for A4.",
    roles: {
      event: "Happens at one moment:",
      state: "Always has a value:",
      command: "Is sent to the robot:",
    },
  },
  sheets: {
    "hello-robot": {
      tasks: [
        {say: "The robot shall be 3 metres ahead after 10 seconds. Which number?", answer: "0.3"},
        {
          say: "Draw where `Velocity (-0.2) 0` is after 5 seconds, and after 10.",
          answer: "1 metre and 2 metres behind the start",
        },
      ],
      unplugged: {
        title: "the robot that never stops",
        steps: [
          "One pupil is the robot and stands at a line. Another one is the program, and holds a card: 1 step in a second.",
          "The class counts seconds aloud. The robot does what the card says, as long as there is a card.",
          "The program shows another card: 2 steps, or 1 step backwards. Ask: when does the robot stop? (When a card says 0.)",
        ],
      },
    },
    "turn-on-the-spot": {
      tasks: [
        {
          say: "How long does a whole turn take with `Velocity 0 0.5`? A whole turn is 6.28.",
          answer: "about 12.6 seconds",
        },
        {say: "Which second number turns right by a quarter (1.57) in 2 seconds?", answer: "about −0.79"},
      ],
      unplugged: {
        title: "radians with a string",
        steps: [
          "Pairs draw a circle with a string that is fixed in the middle, on the floor with chalk.",
          "They lay the same string along the circle, and mark how often it fits: a bit more than six times.",
          "One string length along the circle is one radian. Stand in the middle and turn by one, then by three.",
        ],
      },
    },
    "round-the-box": {
      tasks: [
        {say: "Which radius has the circle of `Velocity 0.4 0.2`?", answer: "2 metres (0.4 divided by 0.2)"},
        {
          say: "Find two other numbers for the same circle, driven at half the speed.",
          answer: "`Velocity 0.2 0.1`",
        },
      ],
      unplugged: {
        title: "walk a circle",
        steps: [
          "A pupil takes one step ahead, then turns a little to the left, again and again. Others mark the way.",
          "Now the turns are smaller. Is the circle larger or smaller?",
          "Now step and turn happen at the same time: that is what the robot does.",
        ],
      },
    },
    "light-and-motion": {
      tasks: [
        {
          say: "Write the value for: drive backwards with 0.1, first light orange.",
          answer: "`(Velocity (-0.1) 0, Led1 Orange)`",
        },
        {
          say: "A program has `Led1 Red` and `Led1 Green` side by side. What is odd about it?",
          answer: "Two values for one light: they replace each other.",
        },
      ],
      unplugged: {
        title: "an orchestra",
        steps: [
          "Three pupils get one card each: clap, tap a foot, hum. All begin when you say “run”.",
          "Let them stand in another order and run again. What has changed? (Nothing.)",
          "Give two cards to one pupil that cannot be done together: sit, stand. What happens?",
        ],
      },
    },
    faster: {
      tasks: [
        {
          say: "The speed is 0 and 0.01 is added 50 times in a second. What is it after 1 second?",
          answer: "0.5 metres in a second",
        },
        {say: "Fill in: `slower (Velocity vl va) = Velocity (vl ___ 0.01) va`", answer: "`-`"},
      ],
      unplugged: {
        title: "a machine for numbers",
        steps: [
          "A pupil behind a table is a machine: a number goes in on a note, and comes out plus 2.",
          "What comes out goes in again. The class guesses the number after five times.",
          "Other rules: double it, take one away. Which one gets large fastest?",
        ],
      },
    },
    "stop-in-time": {
      tasks: [
        {say: "What does `go` give for x = 0.5, for x = 0.99 and for x = 1?", answer: "0.3, 0.3 and 0"},
        {
          say: "Add a line: between 1 and 1.5 it drives with 0.1.",
          answer: "`| x < 1.5 = Velocity 0.1 0` as the second line",
        },
      ],
      unplugged: {
        title: "the class decides",
        steps: [
          "One pupil walks. After each step the pupil says aloud how many steps it were.",
          "The class is the function and answers each time: “less than 5: go, otherwise: stand”.",
          "Carry on after the pupil was put back by two steps. What does the class answer now?",
        ],
      },
    },
    bump: {
      tasks: [
        {say: "The bumper is pressed 3 times and let go 3 times. How many events?", answer: "6"},
        {
          say: "Event or state: a bump, the speed, a button, the position?",
          answer: "event, state, event, state",
        },
      ],
      unplugged: {
        title: "clap or nothing",
        steps: [
          "You lift a card and take it down. Both are events. The class answers each with a clap.",
          "New rule: clap when the card goes up, nothing when it goes down. “Nothing” is an answer, too.",
          "Who claps while the card stays up has taken an event for a state.",
        ],
      },
    },
    "which-side": {
      tasks: [
        {
          say: "Cases in this order: any side, left side. When is the second one used?",
          answer: "Never: the first fits everything.",
        },
        {say: "Write the pattern for: the right bumper is let go.", answer: "`Bumper RightBumper Released`"},
      ],
      unplugged: {
        title: "the post office",
        steps: [
          "Boxes stand in a row: “red letters”, “letters to Ada”, “all others”. A letter goes into the first box that fits.",
          "Sort ten letters. Where does a red letter to Ada go?",
          "Put “all others” first, and sort again. What is in the other boxes?",
        ],
      },
    },
  },
  tests: {
    "1": [
      {
        ask: "How far does the robot come in 5 seconds, in centimetres?",
        why: "0.3 metres in each of 5 seconds.",
      },
      {
        ask: "When does it stop by itself?",
        answers: ["After 1 metre", "After 5 seconds", "Never"],
        why: "A velocity holds until another one comes.",
      },
      {
        ask: "Which value drives in a circle to the right?",
        answers: ["`Velocity 0.3 0`", "`Velocity 0 (-0.3)`", "`Velocity 0.3 (-0.3)`"],
        why: "It drives and turns to the right at once.",
      },
      {
        ask: "What does this program do?",
        answers: ["It drives, then the light comes", "Both from the start", "Only the light"],
        why: "Values stand side by side.",
      },
      {
        ask: "How often is it asked whether `x < 1`?",
        answers: ["Once, at the start", "At every report of the robot", "When it arrives"],
        why: "A function of a state is asked again and again.",
      },
      {
        ask: "The robot bumps 3 times, and is free again each time. How many sounds?",
        why: "Pressed and released are two events, three times.",
      },
      {
        ask: "What does the robot do at the wall?",
        answers: ["It goes on pushing", "It drives back", "It stops"],
        why: "`go` is sent again and again, and replaces what `back` sent.",
      },
      {
        ask: "When does `back` answer?",
        answers: [
          "When a bump and a hole have both happened",
          "At each bump and at each change of the floor",
          "Only at the first that comes",
        ],
        why: "`Either` is one or the other, each time.",
      },
    ],
    "2": [
      {
        ask: "The bumper is pressed 3 times. Which number is in the memory then?",
        why: "It begins with 0, and 2 is added at each press.",
      },
      {
        ask: "What does the robot do after a bump?",
        answers: ["It drives back", "It stops", "It drives ahead as before"],
        why: "`drive` does not look at the memory.",
      },
      {
        ask: "What does the robot do at the start?",
        answers: ["It drives ahead", "It drives back", "It turns"],
        why: "The memory begins with the first case.",
      },
      {
        ask: "What does the program do in the second after a bump?",
        answers: ["It waits for a second", "It compares the clock again and again", "Nothing"],
        why: "Nothing waits; the clock decides.",
      },
      {
        ask: "A program with `StdGen` runs twice with the same seed. What is different?",
        answers: ["Nothing", "Everything", "Only the first turn"],
        why: "The same seed gives the same numbers.",
      },
      {
        ask: "When does `turn 90` begin?",
        answers: ["At the same time as `drive`", "When `drive 100` has ended", "After one second"],
        why: "Steps of a task come one after another.",
      },
      {
        ask: "How many corners has the figure that the robot drives?",
        why: "Five times 72 degrees is a whole turn.",
      },
      {
        ask: "When is this program over?",
        answers: ["After 5 metres", "When both tasks have ended", "After 4 seconds"],
        why: "`race` ends with the first one; 5 metres take longer.",
      },
    ],
  },
}
