/// The sentences and labels of the page in English.

import type {OlderEncoding} from "@rosy/codegen/text-file"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

interface NamedCharacter {
  readonly character: string
  readonly plain: string
  readonly name: string
}

const {short, seconds, count} = measuresOf("en")

export const page = {
  rosy: "Rosy",
  run: "Run",
  stop: "Stop",
  runHint: "Run (Ctrl+Enter)",
  stopHint: "Stop (Space)",
  reset: "Reset",
  resetHint: "Put the robot back to the start",
  sameAgain: "The same run again",
  sameAgainHint: "The same run again: the same luck with dice and slipping wheels",
  pause: "Pause",
  resume: "Go on",
  continueHere: "Continue from here",
  continueHint: "Run on from this moment, with the program as it is now",
  forward: "One step (0.02 s)",
  stepBefore: "Step before: where a function began",
  stepAfter: "Next step: where a function begins",
  lookBack: "Look back in the run",
  saveTable: "Save as a table (CSV)",
  noRun: "Run the program to see its values.",
  chartedValues: "Values to draw",
  chartSpan: "Time to draw",
  chartSpans: {20: "20 s", 60: "1 min", all: "All"},
  remembers: "The program remembers",
  robotValues: "The robot",
  time: "Time",
  quantities: {
    speed: "Speed",
    turning: "Turning",
    x: "x",
    y: "y",
    heading: "Heading",
    believedX: "Believed x",
    believedY: "Believed y",
    believedHeading: "Believed heading",
  },
  /// The robot as a screen reader finds it.
  readout: {
    time: "time",
    heading: "heading",
    speed: "speed",
    bumpers: "bumpers",
    cliffs: "cliffs",
    wheels: "wheels",
    led1: "LED 1",
    led2: "LED 2",
  },
  sides: {left: "left", centre: "centre", right: "right"},
  /// What 1 and 0 mean, per kind of sensor.
  senses: {
    bumper: ["pressed", "released"],
    cliff: ["hole", "floor"],
    wheel: ["in the air", "on the ground"],
    button: ["pressed", "released"],
  },
  led: (n: number) => `LED ${n}`,
  speed: "Speed",
  fastest: "max",
  examples: "Examples",
  undo: "Undo",
  redo: "Redo",
  menu: "More",
  programName: "Name of the program",
  unnamed: "my program",
  yourProgram: "Your program",
  saved: {saved: "saved", changed: "saving…", failed: "not saved"},
  view: "View",
  views: {blocks: "Blocks", both: "Blocks + Haskell", haskell: "Haskell", diagram: "Diagram"},
  regions: {blocks: "Blocks", haskell: "Haskell", diagram: "Diagram", room: "Room"},
  region: "Show",
  canvasHeight: "Height of the room",
  arrange: {
    title: "Arrange",
    hint: "Put blocks, Haskell and room where you like",
    choices: "Where things are",
    beside: (one: string, other: string) => `${one} beside ${other}`,
    below: (one: string, other: string) => `${one} above ${other}`,
    shown: "What you see",
    reset: "As at first",
    how: "Drag the dots at the top of a part, or a border between two.",
    move: (region: string) => `Move ${region}`,
    moveHint: "Drag it to another place. The arrow keys move it to that side.",
    hide: (region: string) => `Hide ${region}`,
    border: (one: string, other: string) => `Border between ${one} and ${other}`,
  },
  room: "Room",
  worldName: "Room to drive in",
  ownWorld: "own room",
  soundOn: "Sound is on",
  soundOff: "Sound is off",
  clock: "Time of the run",
  tabs: {console: "Console", charts: "Charts", runs: "Runs", sensors: "Values", problems: "Problems"},
  emptyConsole: "What the robot senses and says appears here.",
  moreEvents: (n: number) => count(n, {one: "Show one more event", other: k => `Show ${k} more events`}),
  fewerEvents: "Show only the most important events",
  noProblems: "No problems.",
  times: (n: number) => `×${n}`,
  plays: "plays",
  pastedText: "The pasted text",
  newName: (old: string) => `New name for ${old}`,
  rename: "Rename",
  format: "Lay out the Haskell",
  /// CodeMirror's words, by its own English ones.
  editor: {
    Find: "Find",
    Replace: "Put instead",
    next: "Next",
    previous: "Back",
    all: "Select all",
    "match case": "Aa counts",
    "by word": "Whole words",
    regexp: "Pattern",
    replace: "Put instead",
    "replace all": "All",
    close: "Close",
    "current match": "found here",
    "replaced $ matches": "changed $ places",
    "replaced match on line $": "changed a place in line $",
    "on line": "in line",
    Diagnostics: "Problems",
    "No diagnostics": "No problems",
    Completions: "What fits here",
    "Control character": "Invisible character",
  },
  showIt: "Show it",
  nothingToRun: "Nothing runs yet. Choose a block for `simulate`, then press Run.",
  nothingRuns: (name: string) => `Nothing runs yet. Run \`${name}\`?`,
  runIt: (name: string) => `Run ${name}`,
  readMore: "Read more",
  fromToolbox: "From the toolbox",
  writeType: (signature: string) => `Write its type: ${signature}`,
  compilerSays: "What the compiler said",
  givenInputs: "It was given",
  atTime: (time: number) => `at ${seconds(time, 2)}`,
  close: "Close",
  newProgram: "New program",
  openFile: "Open a file…",
  saveFile: "Save as a file",
  saveHaskell: "Save the Haskell",
  share: {
    menu: "Share or print…",
    title: "Share",
    lead: "The link contains the whole program and its room. Nothing is uploaded.",
    making: "Making the link…",
    /// About a link whose page has an address of this computer alone.
    reach: {
      network:
        "The address of this page leads to this computer alone. The link has its address on the network instead: others there can open it while Rosy runs here.",
      computer:
        "This link leads to this computer alone. For others save the program as a file, or start Rosy with `--host 0.0.0.0` and share again.",
    },
    link: "Link",
    copy: "Copy",
    copied: "Copied.",
    notCopied: "Press Ctrl+C to copy it.",
    code: "The link as a QR code",
    codeHint: "The QR code contains the program and its room, but not the places of the blocks.",
    noCode: "This program is too long for a QR code. The link has room for it.",
    embed: "To put it into a page of your own",
    page: "Save a page that works everywhere",
    pageHint:
      "One file with the blocks, the Haskell and the film of the last run. It opens without Rosy, from a disk or a website.",
    pageWithoutFilm:
      "One file with the blocks and the Haskell. Run the program first, and it has the film of the run as well.",
    print: "Print blocks and Haskell",
    openInRosy: "Open in Rosy",
  },
  /// In the file that *Share* saves.
  sharedPage: {
    film: "The last run",
    noFilm: "The program had not run when this page was made.",
    olderFilm: "The film shows the program before its last changes.",
    play: "Play",
    reach: {
      network:
        "The link works for others on the same network, while Rosy runs on the computer where this page was made.",
      computer: "The link works only on the computer where this page was made, while Rosy runs there.",
    },
    made: (version: string) => `Made with Rosy ${version}`,
  },
  driveByHand: "Drive by hand (ROS)",
  /// The page that help links to Haskell's own names lead to.
  help: {
    title: "Haskell's own names",
    lead: "Every Haskell program knows these. Each stands with its type and an example.",
  },
  /// The guide, a site of its own (`plugins/guide`), and its part for teachers.
  guide: {
    menu: "Guide",
    teachers: "For teachers",
    isEnglish: "This page of the guide is in English only.",
    /// Of a lesson, a problem, or a part of the page.
    more: "Read more in the guide",
  },
  about: (version: string) => `About Rosy ${version}: licences`,
  language: "Language",
  theme: "Colours",
  themes: {auto: "As the system", light: "Light", dark: "Dark"},
  galleryTitle: "Examples",
  galleryLead: "Open one, run it, change it. Your own program is kept.",
  galleryLoading: "Looking for the examples…",
  galleryFailed: "The examples could not be loaded. Rosy's service does not answer; try again in a moment.",
  exampleLevels: {
    start: "First steps",
    react: "React and remember",
    tasks: "One thing after another",
    large: "Larger programs",
  },
  otherExamples: "More examples",
  moreAbout: (title: string) => `What ${title} teaches`,
  again: "Try again",
  myPrograms: {
    title: "My programs",
    lead: "This browser keeps every program that you change.",
    none: "Change an example or begin a new program, and it is kept here.",
    open: "open now",
    rename: (name: string) => `Rename ${name}`,
    newName: (name: string) => `New name for ${name}`,
    duplicate: (name: string) => `Duplicate ${name}`,
    remove: (name: string) => `Delete ${name}`,
    removed: (name: string) => `${name} is deleted.`,
    undo: "Undo",
    deleted: "Deleted programs",
    restore: (name: string) => `Restore ${name}`,
    restoreShort: "Restore",
  },
  /// An experiment with the first program: a text of the program, and what to put instead.
  invite: {
    change: "Change",
    from: "+",
    to: "to",
    into: "-",
    after: "and run again. Which way does the robot drive now?",
  },
  haskellPane: "The program in Haskell",
  haskellKeys: "Escape, then Tab leaves the text. F8 goes to the next problem.",
  blocksPane: "The program in blocks",
  link: {
    connecting: "Looking for the robot…",
    lost: "The connection to Rosy is lost. It comes back by itself; your program is kept.",
  },
  programComing: "The blocks are on their way. The first time takes longest; your browser keeps them.",
  worker: {
    starting: "The helper that reads Haskell is starting.",
    restarting:
      "The helper that reads Haskell is restarting. Your program is kept; run it again in a moment.",
  },
  queued: (place: number) =>
    place === 1
      ? "The room is full. Your program is the next to run."
      : place === 2
        ? "The room is full. One program is before yours."
        : `The room is full. ${place - 1} programs are before yours.`,
  roomLabel: (world: string) =>
    `The room ${world} from above, with the robot in it. While it runs, the arrow keys move the robot, comma and full stop turn it, and B takes a thing to push instead; plus and minus zoom, F follows it. W asks why it moves like this, and P why it is there.`,
  sight: "How to see the room",
  follow: "Follow the robot",
  followHint: "Follow the robot (F)",
  closer: "Closer",
  further: "Further away",
  wholeRoom: "All of the room",
  sightMenu: "Trail, picture and film",
  trail: "Trail",
  trails: {plain: "One colour", speed: "Speed", time: "Time"},
  trailEnds: {speed: ["slow", "fast"], time: ["start", "now"]},
  savePicture: "Save a picture",
  startFilm: "Start a film",
  endFilm: "End the film",
  robots: {
    title: "Which robot?",
    lead: "The same program runs on each of them.",
    choose: "Choose a robot",
    simulated: "Simulated robot",
    simulatedShort: "Simulated",
    simulatedHint: "It lives in the room of this page, and nothing can break.",
    free: "free",
    has: (who: string) => `${who} has it`,
    domain: (domain: number) => `ROS 2 domain ${domain}`,
    charge: (percent: number) => `battery ${percent}%`,
    volts: (volts: number) => `battery ${short(volts, 1)} V`,
    several: "several robots on the same topics: give each a namespace",
    discovers: "A robot on ROS 2 that is switched on in this network appears here by itself.",
    yours: "you have it",
    who: "Your name, for the others to see",
    locked: "The robots are locked. The person who started Rosy can tell you the code.",
    code: "Code",
    unlock: "Open",
    take: "Take it",
    leave: "Let go",
    leaveHint: "The robot stands, and others may have it",
    link: {connecting: "Looking for it…", connected: "Connected", lost: "Lost, looking for it…"},
    safetyOn: "Backs off by itself",
    safetyOnHint: "It backs off from walls and holes before your program may drive again.",
    safetyOff: "Does not back off",
    safetyOffHint:
      "The safety rules are switched off: watch its way. The shield above the room switches them on.",
    backing: "Backing off…",
    limits: (speed: number) => `at most ${short(speed, 2)} m/s`,
    estop: "Emergency stop",
    estopHint: "Stop the robot at once (Space)",
    stopped: "It was stopped and stands.",
    letDrive: "Let it drive again",
    region: (name: string) => `The robot ${name}`,
    floor: (name: string) => `The way of the robot ${name}, as it measures it itself; plus and minus zoom.`,
  },
  topics: {
    title: "Messages by hand",
    send: "Send",
    runFirst: "Press Run first: only a running program gets messages",
    ofRobot: (topic: string) => `The robot itself sends the messages on ${topic}.`,
    computed: (type: string) =>
      `The program works out the name of the topic of ${type}, so there is no form for it: write the name as one text.`,
  },
  safety: {
    name: "Safety rules",
    on: "Safety rules are on: the robot backs off from walls and holes before your program drives on, here and on real robots",
    off: "Safety rules are off: only your program drives, here and on real robots",
    overrides: "Safety rules: backing off…",
    tookOver: "The safety rules take over: backing off",
  },
  blocked: {
    pushes: "The robot pushes against something and cannot drive on.",
    withBumper: "A function with Bumper as its input can turn it away.",
    withoutBumper: "It has no bumper on that side: drive it another way.",
  },
  goals: "Goals",
  goalStates: {open: "open", done: "done", missed: "missed"},
  hands: "Touch the robot",
  robotButton: (n: number) => `Press button ${n} of the robot`,
  holdsThing: (kind: "box" | "drum", n: number) =>
    `${kind === "box" ? "Box" : "Drum"} ${n}: the arrow keys push it. Escape takes the robot again.`,
  lift: "Lift",
  liftHint: "Lift the robot off the floor, and put it down again",
  /// What the run is doing, in one or two words.
  doing: {
    lookingBack: "Looking back",
    standing: "Paused",
    ready: "Ready",
    waiting: "Waiting",
    queued: "Waiting",
    compiling: "Starting",
    running: "Running",
  },
  ended: {
    done: "Finished",
    error: "Ended by a problem",
    stuck: "Ended by a problem",
    hole: "Stopped at an empty place",
    stopped: "Stopped",
    time: "Time is up",
    refused: "Not started",
    lost: "Connection lost",
  },
  /// What the page itself has to say: first what, then what to do.
  notices: {
    diverged: {
      message: (time: string) => `Your changed program does something else from ${time} on.`,
      hint: "It ran from the start to the moment that you chose.",
    },
    uncompared: {
      message: (time: string) =>
        `After ${time}, it is not known whether your changed program does something else.`,
      hint: "The commands of a run are kept for about an hour.",
    },
    notText: {
      message: (name: string) => `${name} does not hold text.`,
      hint: "Rosy opens programs: files that end in .rosy or .hs.",
    },
    olderEncoding: {
      message: ({name, encoding, number, line}: OlderEncoding & {readonly name: string}) =>
        `${name} is in the encoding ${encoding}, not in UTF-8: see line ${number}, “${line.trim()}”.`,
      hint: "If the line is right, read the file so. Rosy saves it in UTF-8.",
      readAs: (encoding: string) => `Read it as ${encoding}`,
    },
    emptyFile: {
      message: (name: string) => `${name} is empty.`,
      hint: "There is no program in it to open.",
    },
    confusable: {
      message: (name: string, n: number, {character, plain, name: called}: NamedCharacter) =>
        `${count(n, {one: `${name} has one character that looks right and is not`, other: k => `${name} has ${k} characters that look right and are not. The first`})}: ${plain.trim() === "" ? `one that cannot be seen (${called})` : `‘${character}’ (${called}) for ‘${plain}’`}.`,
      hint: "Comments and texts in quotation marks stay as they are.",
      repair: "Repair",
    },
    severalPrograms: {
      message: (name: string, n: number) => `${name} has ${n} programs.`,
      hint: (unread: number) =>
        unread === 0
          ? "Choose one."
          : `Choose one. ${count(unread, {one: "One more", other: n => `${n} more`})} could not be read.`,
    },
    noPrograms: (name: string) => `There are no programs in ${name}.`,
    tooManyFiles: {
      message: (name: string) => `${name} has too much in it.`,
      hint: "Rosy looks at 2,000 files and 20 million letters at most. Drop the folder that your program is in.",
    },
    damagedArchive: {
      message: (name: string) => `${name} cannot be unpacked.`,
      hint: "It is damaged or has a password. Unpack it on your computer and drop the folder.",
    },
    notProgram: (name: string) => `${name} is not a program.`,
    tooLarge: {
      message: (name: string) => `${name} is too large.`,
      hint: "A program has at most 200,000 letters. Yours is still open.",
    },
    notWorld: (name: string) => `${name} is not a room Rosy can use.`,
    exampleMissing: {
      message: (name: string) => `There is no example ${name}.`,
      hint: "Examples, above, shows those there are.",
    },
    noFilm: {
      message: "The film is empty.",
      hint: "Start it while the robot drives, and end it later.",
    },
    filmFailed: {
      message: "The film could not be made.",
      hint: "Run the program for a while, or try the other kind of film.",
    },
    noReader: {
      message: "A part of the page is missing.",
      hint: "Reload the page; nothing of yours is lost.",
    },
    notFormatted: {
      message: (left: number) =>
        count(left, {
          one: "One definition was left as it is.",
          other: n => `${n} definitions were left as they are.`,
        }),
      hint: "They are not finished, or laying them out would have lost something.",
    },
    otherMeaning: {
      message: (name: string) =>
        `The Haskell text of ${name} cannot say this change of the blocks exactly. The change was not made.`,
      hint: "Make the change in the Haskell text, or build this place in another way.",
    },
    groupedOtherwise: {
      message: (name: string) =>
        `After this change, the compiler groups the Haskell text of ${name} differently from the blocks. The program is again as it was before.`,
    },
    unreadableEdit: {
      message: (name: string) =>
        `The compiler cannot read the Haskell text of ${name} after this change. The program is again as it was before.`,
    },
    unfinishedText: {
      message: (name: string) =>
        `Not finished in the Haskell text: ${name}. This change of the blocks was not made.`,
      hint: "Finish the line in the text or press Undo, then change the blocks. Blocks that the text already says can be changed.",
    },
    progressNotSaved: {
      message: "This browser has no room to keep what you did in the lesson.",
      hint: "Delete programs in My programs, then do the next step. Your program is not affected.",
    },
    notSaved: {
      message: "This browser has no room to keep your program.",
      hint: "Delete programs in My programs, or save this one as a file with the menu at the top right.",
    },
    madeWay: {
      message: (names: string) =>
        `This browser is full, so Rosy removed these deleted programs for good: ${names}.`,
      hint: "Delete programs that you no longer need, and save as files what you want to keep.",
    },
    robotGone: {
      message: (name: string) => `You no longer have ${name}.`,
      hint: "Take it again when you need it.",
    },
    outOfSight: {
      message: (name: string) => `${name} was stopped because this page was not in view.`,
      hint: "Keep the page in view while a real robot drives.",
    },
    damagedLink: {
      message: "This link is damaged.",
      hint: "Copy the whole link and open it again.",
    },
    becameTwo: {
      message: (name: string) => `${name === "" ? "Your program" : name} was changed in two tabs at once.`,
      hint: (copy: string) => `Now there are two: this one is called ${copy}.`,
    },
    noStorage: {
      message: "This browser keeps nothing for this page.",
      hint: "Save your program as a file before you close the page.",
    },
  },
} as const
