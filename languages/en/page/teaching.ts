/// What the pages for teachers say besides the lessons' own texts, in English. The build of the guide reads it; it is Markdown.

export const teaching = {
  labels: {
    about: (minutes: number, week: number) => `About ${minutes} minutes · week ${week}`,
    optional: (minutes: number, week: number) => `About ${minutes} minutes · as an option, from week ${week}`,
    aims: "Pupils know afterwards",
    steps: "What is asked",
    step: "step",
    rightAnswer: "right answer, or what is checked",
    begins: "The lesson begins with this program",
    ask: "Questions to ask",
    wrong: "What goes wrong",
    nearMisses: "Some attempts that do not pass, with the lines that matter and what the page says of them:",
    says: (check: string, seen: string) => `“${check}” is not done. ${seen}`,
    solutions: "Solutions that pass",
    others: "Others that pass as well:",
  },
  plan: {
    title: "Twelve weeks",
    lead: "A plan for a term with one meeting of 45 minutes a week. Pupils do the lessons of the page alone or in pairs; the rest of the time is for talking, for paper and for projects. With two meetings a week the second one belongs to a project.",
    columns: ["week", "lessons", "what it is about", "prepare", "together and on paper"],
    handbook: "45 minutes together",
    weeks: [
      "Start the class; three words for each pupil. Print the worksheet.",
      "A box or a bag on the floor, to walk round.",
      "A metre of tape on the floor.",
      "Nothing; pupils clap.",
      "The projector, for **Why?**.",
      "A real toy to lift, if you have one. Choose the projects.",
      "Test 1 on paper, 20 minutes. A note and a pencil for “memory”.",
      "Three cards: Go, Back, Turn.",
      "A die for each pair.",
      "A recipe from a kitchen.",
      "Two pupils who do things at the same time.",
      "Test 2, the competition, and the projects are shown.",
    ],
    strand: (page: string, week: number) =>
      `**With mathematics:** from week ${week} the strand [Algebra](${page}) can be added, or be taught in mathematics lessons:`,
    after: (projects: string) =>
      `**If time is short:** leave out the third lesson of weeks 6, 8, 9 and 11. **If a class is fast:** begin the [projects](${projects}) in week 5. A lesson that was not finished is opened at the same step next time.`,
  },
  curricula: {
    title: "What schools must teach",
    lead: "Statements of curricula, in their own words and language, and the lessons of the page in which pupils do what they ask for. *In part* means that the lessons do not teach all of it. Only what could be cited is here, and the choice of lessons is ours: no authority has checked it. Curricula change: compare a statement with the edition that is in force before you rely on it.",
    columns: ["where", "statement", "lessons"],
    part: "in part",
    all: "every lesson",
    incomplete: "What this document says of programming in each year could not be cited; it is missing here.",
    places: {
      csta: "USA",
      england: "England",
      kmk: "Germany",
      "baden-7": "Germany: Baden-Württemberg, year 7",
      baden: "Germany: Baden-Württemberg, Gymnasium",
      "cycle-4": "France: years 7 to 9 (cycle 4)",
      snt: "France: year 10 (seconde)",
      spain: "Spain",
      portugal: "Portugal",
    },
  },
  lessons: {
    "hello-robot": {
      often:
        "Pupils wait for the end of the program. There is none: a velocity holds until another one comes.",
      ask: [
        "How far is it after 10 seconds?",
        "When does it stop?",
        "Which number do you change to be twice as far?",
      ],
    },
    "turn-on-the-spot": {
      often: "The second number is read as degrees. It is radians in a second: 3.14 is half a turn.",
      ask: [
        "Is left yours or the robot's?",
        "How long does a whole turn take with 0.5?",
        "What does a minus do?",
      ],
    },
    "round-the-box": {
      often: "Pupils expect a corner: first ahead, then the turn. Both numbers are in force at once.",
      ask: [
        "What makes the circle larger?",
        "Two pairs of numbers, the same circle: which?",
        "What is the circle with 0 as second number?",
      ],
    },
    "light-and-motion": {
      often: "The second value is taken for a second step. Side by side means at the same time.",
      ask: [
        "Does the order matter?",
        "What does a program with two velocities do?",
        "What can the robot do at the same time as you?",
      ],
    },
    faster: {
      often: "`vl + 0.02` looks like a speed of 0.02. It is what is added, 50 times in a second.",
      ask: [
        "What does the function get, and what does it give?",
        "How often is it asked?",
        "What would `vl - 0.02` do?",
      ],
    },
    "stop-in-time": {
      often: "The choice is thought to be made once, at the start. It is made again at every report.",
      ask: ["What is `x` now, and now?", "What happens if you carry the robot back?", "Why not `x == 2`?"],
    },
    bump: {
      often: "One bump is two events, pressed and released, so there are two sounds.",
      ask: [
        "How many events were there?",
        "What does `Nothing` send?",
        "What is the difference between `Nothing` and black light?",
      ],
    },
    "which-side": {
      often: "A case that fits everything stands first, and the others are never used.",
      ask: ["Which case does this event fit?", "What if two cases fit?", "What does `_` mean here?"],
    },
    "two-wills": {
      often: "Pupils swap the functions: the later one is said to win. What counts is who sends last.",
      ask: [
        "Who sent what the robot does now?",
        "How often does each of them send?",
        "How would you decide between two friends who both give orders?",
      ],
    },
    "remote-control": {
      often: "The robot is expected to stop when the button is let go. Nobody told it so.",
      ask: [
        "Which event is letting go?",
        "What would a remote be like that drives only while you press?",
        "What does the robot do with no command?",
      ],
    },
    "one-or-the-other": {
      often: "`Either` is read as “when both have happened”. It answers each of them when it comes.",
      ask: [
        "Which of the two was it?",
        "How does the function see the difference?",
        "What would be different with two functions?",
      ],
    },
    "lift-me": {
      often: "Only the light is changed in the air. The wheels need a command of their own.",
      ask: [
        "What must never happen?",
        "Who may switch the wheels on again?",
        "Which machines at home stop when they are opened?",
      ],
    },
    "wire-a-reflex": {
      often:
        "A second wire to the same actuator is expected to win. Both send; something must say which goes first.",
      ask: [
        "Which sensors reach the wheels?",
        "What is in the diagram, and what only in the function?",
        "Where would a third wire to `Velocity` start, and who should go first then?",
      ],
    },
    "stop-before-the-wall": {
      often: "The distance ahead is mixed up with the way driven. One gets smaller, the other larger.",
      ask: [
        "Which way does the number go?",
        "What if the wall moves?",
        "Where do you stand 10 cm before a wall, from any start?",
      ],
    },
    "count-the-bumps": {
      often:
        "Releases are counted, too, or the new number is expected at once. The function reads the old value and sends the new one.",
      ask: [
        "What is in the memory before the first bump?",
        "What does it read at the third bump?",
        "Why is 2, 4, 6 said?",
      ],
    },
    "there-and-back": {
      often: "`bump` is expected to turn the robot round itself. It only writes; `drive` must read.",
      ask: [
        "Who writes, who reads?",
        "Do the two know each other?",
        "What does `drive` do before anything was written?",
      ],
    },
    "a-mode-of-my-own": {
      often: "A new case is added to the type, and one of the functions does not know it.",
      ask: [
        "In which places do you meet each mode?",
        "Draw the modes as circles: which arrows are there?",
        "Is `Mode` a value or a list of values?",
      ],
    },
    "for-one-second": {
      often: "Pupils look for a command that waits. Nothing waits; the clock is compared again and again.",
      ask: [
        "What is remembered: a time or a duration?",
        "What happens at a bump during that second?",
        "How would you make it half a second?",
      ],
    },
    "three-states": {
      often: "The state is looked for in a function. It is in the memory; functions read it and write it.",
      ask: [
        "Which arrow is missing in the machine?",
        "Draw the three states as circles: which sensor is at which arrow?",
        "What does the button do in `Go`?",
      ],
    },
    "my-own-event": {
      often:
        "The answer is written twice, once for each sensor. One event with two senders needs one answer.",
      ask: [
        "Who sends `Blocked`, and who takes it?",
        "What changes when a third sensor is added?",
        "What is the name of your event?",
      ],
    },
    chance: {
      often:
        "Random is expected to be different each time. The same seed gives the same run, so it can be looked at again.",
      ask: [
        "Why is it good that a run can be repeated?",
        "What does the function do with the generator it gets back?",
        "In which room is a fixed rule better?",
      ],
    },
    "a-recipe": {
      often: "Metres are typed where centimetres are meant: `drive 1` is one centimetre.",
      ask: [
        "When does the second step begin?",
        "When is the program over?",
        "What is different from two functions side by side?",
      ],
    },
    "four-times": {
      often:
        "The steps are copied four times, and one copy is changed. A named piece is changed in one place.",
      ask: ["What is repeated?", "How much does it turn in all?", "Which angle makes a triangle?"],
    },
    "look-inside": {
      often: "`Done` is expected to stop the robot. It ends the task; the last velocity holds.",
      ask: [
        "What starts, what watches, what ends?",
        "Who stops the wheels?",
        "What would never send `Done`?",
      ],
    },
    "a-task-that-answers": {
      often: "The text “distance” is said instead of the number, or metres instead of centimetres.",
      ask: [
        "Where does the result come from?",
        "Can it change later?",
        "How would you get the area of the room?",
      ],
    },
    "at-the-same-time": {
      often: "`parallel` is used where one should give up: it waits for both.",
      ask: [
        "Which of the two ends first?",
        "What happens to the other one?",
        "When do you want the first, when both?",
      ],
    },
    "the-papers-robot": {
      often:
        "Safety and curiosity send to the wheels at the same time. What matters more must hold the other back.",
      ask: ["What must win always?", "For how long?", "Try it in another room: what was luck?"],
    },
    "a-machine-for-numbers": {
      often: "The letter is taken for one number. `x` stands for each place on the way, one after another.",
      ask: [
        "Which output belongs to the input 2?",
        "Which input gives 0?",
        "Can two inputs have the same output? Can one input have two?",
      ],
    },
    "where-the-graph-meets-zero": {
      often:
        "The graph is taken for the robot’s path. To the right is the place, up is the speed; the path is in the room.",
      ask: [
        "Which equation did the robot solve?",
        "What does a steeper graph do?",
        "Carry the robot beyond the zero: where does it drive?",
      ],
    },
    "a-graph-in-pieces": {
      often:
        "The conditions are read as if each stood alone. `x < 2` holds at 0.5 as well; it does not count there, because an earlier case fits.",
      ask: [
        "For which `x` does each rule hold?",
        "Where do two pieces meet, and where is a leap?",
        "Is there an input without an output?",
      ],
    },
    "machines-in-a-row": {
      often:
        "`speed . distance` is read from the left. The right machine works first: `speed (distance here)`, as in f(g(x)).",
      ask: [
        "What travels between the two machines?",
        "Can they be exchanged? What do their types say?",
        "Which machine must change when the ring moves?",
      ],
    },
    "a-family-of-functions": {
      often:
        "`a` and `x` are both letters and are mixed up. `x` changes while the robot drives; `a` is chosen once and stays.",
      ask: [
        "What have all members of the family in common?",
        "What happens with a negative `a`?",
        "Which of the letters is the input, and which are parameters?",
      ],
    },
    "rate-of-change": {
      often:
        "Position and speed are read off the same curve. A level position means speed 0; a level speed means that the position rises evenly.",
      ask: [
        "How do you see from the position when it was fastest?",
        "What is a position that falls?",
        "What does the area below the speed say?",
      ],
    },
  },
}

export type TeachingWords = typeof teaching
