/// Every sentence and label of the page, in one place, so that it can be translated. What the program, the
/// compiler and the blocks say comes from them.

import type {Notice, PageState} from "../state/page.ts"
import {isActive} from "../state/run.ts"

export const words = {
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
  forward: "One step (0.02 s)",
  standing: "Paused",
  lookBack: "Look back in the run",
  lookingBack: "Looking back",
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
    bumperLeft: "Left bumper",
    bumperCenter: "Centre bumper",
    bumperRight: "Right bumper",
    cliffLeft: "Left cliff",
    cliffCenter: "Centre cliff",
    cliffRight: "Right cliff",
    wheelLeft: "Left wheel",
    wheelRight: "Right wheel",
    button0: "Button 0",
    button1: "Button 1",
    button2: "Button 2",
    believedX: "Believed x",
    believedY: "Believed y",
    believedHeading: "Believed heading",
  } as Readonly<Record<string, string>>,
  /// What 1 and 0 mean, per kind of sensor.
  senses: {
    bumper: ["pressed", "released"],
    cliff: ["hole", "floor"],
    wheel: ["in the air", "on the ground"],
    button: ["pressed", "released"],
  } as Readonly<Record<string, readonly [string, string]>>,
  led: (n: number) => `LED ${n}`,
  speed: "Speed",
  fastest: "fastest",
  examples: "Examples",
  undo: "Undo",
  redo: "Redo",
  menu: "More",
  programName: "Name of the program",
  unnamed: "my program",
  yourProgram: "Your program",
  saved: {saved: "saved", changed: "saving…", failed: "not saved"},
  view: "View",
  views: {blocks: "Blocks", both: "Blocks + Haskell", haskell: "Haskell"},
  regions: {blocks: "Blocks", haskell: "Haskell", room: "Room"},
  region: "Show",
  borders: {haskell: "Width of the Haskell pane", room: "Width of the room", canvas: "Height of the room"},
  room: "Room",
  worldName: "Room to drive in",
  ownWorld: "own room",
  soundOn: "Sound is on",
  soundOff: "Sound is off",
  clock: "Time of the run",
  tabs: {console: "Console", charts: "Charts", sensors: "Values", problems: "Problems"},
  emptyConsole: "What the robot senses and says appears here.",
  noProblems: "No problems.",
  times: (n: number) => `×${n}`,
  plays: "plays",
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
  readMore: "Read more",
  fromToolbox: "From the toolbox",
  writeType: (signature: string) => `Write its type: ${signature}`,
  compilerSays: "What the compiler said",
  givenInputs: "It was given",
  atTime: (seconds: number) => `at ${seconds.toFixed(2)} s`,
  close: "Close",
  newProgram: "New program",
  openFile: "Open a file…",
  saveFile: "Save as a file",
  saveHaskell: "Save the Haskell",
  driveByHand: "Drive by hand (ROS)",
  theme: "Colours",
  themes: {auto: "As the system", light: "Light", dark: "Dark"},
  galleryTitle: "Examples",
  galleryLead: "Open one, run it, change it. Your own program is kept.",
  galleryLoading: "Looking for the examples…",
  galleryFailed: "The examples could not be loaded. Rosy's service does not answer; try again in a moment.",
  moreAbout: (title: string) => `What ${title} teaches`,
  again: "Try again",
  yourPrograms: "Your programs",
  invite: ["Change", "0.5", ", and run again."] as const,
  haskellPane: "The program in Haskell",
  haskellKeys: "Escape, then Tab leaves the text. F8 goes to the next problem.",
  blocksPane: "The program in blocks",
  emptyHaskell: "The Haskell of your blocks appears here.",
  link: {
    connecting: "Looking for the robot…",
    lost: "The connection to Rosy is lost. It comes back by itself; your program is kept.",
  },
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
    `The room ${world} from above, with the robot in it. While it runs, the arrow keys move the robot, comma and full stop turn it, and B takes a thing to push instead; plus and minus zoom, F follows it.`,
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
    free: "nobody has it",
    has: (who: string) => `${who} has it`,
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
    safetyOffHint: "Whoever started Rosy has switched that off for this robot: watch its way.",
    backing: "Backing off…",
    limits: (speed: number) => `at most ${speed.toFixed(1)} m/s`,
    estop: "Emergency stop",
    estopHint: "Stop the robot at once (Space)",
    stopped: "Emergency stop: it stands.",
    letDrive: "Let it drive again",
    region: (name: string) => `The robot ${name}`,
    floor: (name: string) => `The way of the robot ${name}, as it measures it itself; plus and minus zoom.`,
  },
  goals: "Goals",
  goalStates: {open: "open", done: "done", missed: "missed"},
  hands: "Touch the robot",
  robotButton: (n: number) => `Press button ${n} of the robot`,
  holdsThing: (kind: "box" | "drum", n: number) =>
    `${kind === "box" ? "Box" : "Drum"} ${n}: the arrow keys push it. Escape takes the robot again.`,
  lift: "Lift",
  liftHint: "Lift the robot off the floor, and put it down again",
} as const

/// What the run is doing, in one or two words.
export function runWords(state: PageState): string {
  const {run} = state
  if (state.room.lookedAt !== null) return words.lookingBack
  if (state.clock === "standing" && isActive(run)) return words.standing
  switch (run.kind) {
    case "ready":
      return "Ready"
    case "waiting":
      return "Waiting"
    case "queued":
      return "Waiting"
    case "compiling":
      return "Starting"
    case "running":
      return "Running"
    case "ended":
      return {
        done: "Finished",
        error: "Ended by a problem",
        stuck: "Ended by a problem",
        stopped: "Stopped",
        time: "Time is up",
        refused: "Not started",
        lost: "Connection lost",
      }[run.how]
  }
}

const sentence = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

/// What the page itself has to say: first what, then what to do.
export function noticeWords(notice: Notice): {readonly message: string; readonly hint: string} {
  switch (notice.kind) {
    case "unreadable-file":
      return {message: `${notice.name}: ${notice.message}`, hint: notice.hint}
    case "not-text":
      return {
        message: `${notice.name} does not hold text.`,
        hint: "Rosy opens programs: files that end in .rosy or .hs.",
      }
    case "unreadable-world":
      return {
        message: `${notice.name} is not a room Rosy can use.`,
        hint: notice.path === "" ? sentence(notice.why) : `${notice.path}: ${notice.why}`,
      }
    case "example-missing":
      return {message: `There is no example ${notice.name}.`, hint: "Examples, above, shows those there are."}
    case "refusal":
      return {message: notice.message, hint: notice.hint}
    case "no-film":
      return {message: "The film is empty.", hint: "Start it while the robot drives, and end it later."}
    case "no-reader":
      return {message: "A part of the page is missing.", hint: "Reload the page; nothing of yours is lost."}
    case "not-formatted":
      return {
        message:
          notice.left === 1
            ? "One definition was left as it is."
            : `${notice.left} definitions were left as they are.`,
        hint: "They are not finished, or laying them out would have lost something.",
      }
    case "not-saved":
      return {
        message: "This browser has no room to keep your program.",
        hint: "Save it as a file with the menu at the top right.",
      }
    case "robot-gone":
      return {
        message: `You no longer have ${notice.name}.`,
        hint: notice.why === "" ? "Take it again when you need it." : notice.why,
      }
    case "out-of-sight":
      return {
        message: `${notice.name} was stopped because nobody saw this page.`,
        hint: "Keep the page in view while a real robot drives.",
      }
    case "opened-elsewhere":
      return {
        message: "This program is open in another tab too.",
        hint: "Changes here are kept as a copy.",
      }
  }
}
