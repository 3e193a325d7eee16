/// All that the page knows, as one value without a DOM, and everything that can happen to it.

import type {WorldEdit, WorldEditor} from "../worlds/editor.ts"
import type {World, WorldFile} from "../worlds/world.ts"
import {type Arrangement, firstArrangement, type Region, type View} from "./arrangement.ts"
import {type Changer, type Document, emptyDocument, emptyHistory, type History} from "./history.ts"
import type {
  Declared,
  Hand,
  PageMessage,
  ServiceMessage,
  Speed,
  TypesAtPlaces,
  WorkerState,
} from "./messages.ts"
import type {BlockId, Finding} from "./program.ts"
import {noRobots, type RobotsState} from "./robots.ts"
import {type ConsoleLine, emptyRoom, type RoomState, type TrailStyle} from "./room.ts"
import type {RunState} from "./run.ts"

/// How much room the window has: all regions, two of them, or one at a time.
export type Size = "wide" | "tablet" | "phone"
export type Tab = "console" | "charts" | "sensors" | "problems"
/// Seconds that a strip chart shows, or all of the run.
export type ChartSpan = 20 | 60 | "all"
export type Theme = "auto" | "light" | "dark"

export interface Example {
  readonly name: string
  readonly title: string
  readonly teaches: string
}

export type Gallery =
  | {readonly kind: "unasked"}
  | {readonly kind: "asked"}
  | {readonly kind: "there"; readonly examples: readonly Example[]}
  | {readonly kind: "failed"}

/// Something the page itself has to say; `words.ts` has the sentences.
export type Notice =
  | {readonly kind: "unreadable-file"; readonly name: string; readonly message: string; readonly hint: string}
  | {readonly kind: "not-text"; readonly name: string}
  /// Text, but neither a program nor a room.
  | {readonly kind: "not-program"; readonly name: string}
  | {readonly kind: "too-large"; readonly name: string}
  /// `path` is empty when it is about the whole file.
  | {readonly kind: "unreadable-world"; readonly name: string; readonly path: string; readonly why: string}
  | {readonly kind: "example-missing"; readonly name: string}
  | {readonly kind: "refusal"; readonly message: string; readonly hint: string}
  | {readonly kind: "no-film"}
  | {readonly kind: "no-reader"}
  | {readonly kind: "not-saved"}
  /// So many definitions were left as they are when the text was laid out.
  | {readonly kind: "not-formatted"; readonly left: number}
  | {readonly kind: "opened-elsewhere"}
  | {readonly kind: "robot-gone"; readonly name: string; readonly why: string}
  | {readonly kind: "out-of-sight"; readonly name: string}

export interface Opened {
  readonly name: string
  readonly world: string | WorldFile | null
  readonly document: Document
  /// The steps of undo that were kept.
  readonly history: History
  /// A newcomer's program: Run pulses once, and after the first run a line invites to change a number.
  readonly welcome: boolean
}

export interface PageState {
  readonly name: string
  readonly saved: "saved" | "changed" | "failed"
  readonly document: Document
  readonly history: History
  readonly worldName: string | WorldFile | null
  readonly link: "connecting" | "open" | "lost"
  /// The name that ROS clients reach the robot by; `null` before the first connection.
  readonly session: string | null
  readonly worker: WorkerState
  readonly run: RunState
  /// The number of the newest run; each run takes the next.
  readonly runs: number
  /// The newest question to the compiler; an answer to an older one is dropped.
  readonly checks: number
  /// The luck of the newest run: the same seed is the same run, to the last bit. `null` before the first.
  readonly seed: number | null
  /// The run's clock: it goes, or it stands at a step until it is let go.
  readonly clock: "going" | "standing"
  readonly speed: Speed
  /// The program's own names with the types that the compiler found.
  readonly declared: readonly Declared[]
  /// The type of every piece of the text that the compiler has read last.
  readonly types: TypesAtPlaces & {readonly text: string}
  readonly room: RoomState
  readonly robots: RobotsState
  readonly lines: readonly ConsoleLine[]
  readonly findings: {
    readonly compiler: readonly Finding[]
    readonly run: readonly Finding[]
  }
  /// The compiler took the newest text it answered about. Then it knows better than the blocks' own inference,
  /// which does not know every library and extension that a program from elsewhere may use.
  readonly accepted: boolean
  readonly selected: BlockId | null
  /// Where the cursor is that chose it.
  readonly selectedIn: "blocks" | "haskell"
  readonly welcome: "fresh" | "ran" | "over"
  readonly gallery: Gallery
  readonly dialog: "gallery" | "rooms" | "menu" | "sight" | "robots" | "arrange" | "keys" | null
  /// The rooms of the service, for their gallery; `null` until they have been read.
  readonly rooms: readonly World[] | null
  readonly notice: Notice | null
  /// Where the regions are, and which of them are hidden.
  readonly arrangement: Arrangement
  /// A region is being moved: what it would be like to let it fall where it is; `next` is `null` where nothing would change.
  readonly arranging: {readonly region: Region; readonly next: Arrangement | null} | null
  /// The one region that a phone shows.
  readonly region: Region
  readonly size: Size
  readonly tab: Tab
  /// The keys of the quantities that have a curve.
  readonly charts: readonly string[]
  /// Seconds that a curve shows, or all of the run.
  readonly chartSpan: ChartSpan
  readonly theme: Theme
  readonly muted: boolean
  /// What the colour and the width of the trail tell.
  readonly trail: TrailStyle
  /// The picture of the room goes with the robot.
  readonly follows: boolean
  /// A film of the room is being made.
  readonly films: boolean
  readonly worlds: readonly string[]
  readonly layout: Layout
  /// The room that is being changed; `null` while none is.
  readonly worldEditor: WorldEditor | null
}

/// Where borders inside regions are: the share of the room's picture in its height.
export interface Layout {
  readonly canvas: number
}

export const firstPage: PageState = {
  name: "",
  saved: "saved",
  document: emptyDocument,
  history: emptyHistory,
  worldName: null,
  link: "connecting",
  session: null,
  worker: "starting",
  run: {kind: "ready"},
  runs: 0,
  checks: 0,
  seed: null,
  clock: "going",
  speed: 1,
  declared: [],
  types: {text: "", names: [], at: []},
  room: emptyRoom,
  robots: noRobots,
  lines: [],
  findings: {compiler: [], run: []},
  accepted: false,
  selected: null,
  selectedIn: "blocks",
  welcome: "over",
  gallery: {kind: "unasked"},
  dialog: null,
  rooms: null,
  notice: null,
  arrangement: firstArrangement,
  arranging: null,
  region: "blocks",
  size: "wide",
  tab: "console",
  charts: ["speed", "bumperCenter"],
  chartSpan: 20,
  theme: "auto",
  muted: false,
  trail: "plain",
  follows: false,
  films: false,
  worlds: [],
  layout: {canvas: 0.56},
  worldEditor: null,
}

export type PageEvent =
  | {readonly kind: "link-lost"}
  | {readonly kind: "heard"; readonly message: ServiceMessage}
  /// `seed` is new luck, thrown outside of the state; without it the run has the luck of the one before.
  | {readonly kind: "run-pressed"; readonly seed?: number}
  | {readonly kind: "stop-pressed"}
  | {readonly kind: "reset-pressed"}
  | {readonly kind: "pause-pressed"}
  | {readonly kind: "resume-pressed"}
  | {readonly kind: "forward-pressed"}
  /// The learner looks at this time of the run; `null` is now.
  | {readonly kind: "looked-back"; readonly time: number | null}
  | {readonly kind: "charted"; readonly quantities: readonly string[]}
  | {readonly kind: "chart-span"; readonly span: ChartSpan}
  | {readonly kind: "hand"; readonly hand: Hand}
  /// The keyboard takes hold of a movable thing, or of the robot again.
  | {readonly kind: "held"; readonly thing: number | null}
  /// The learner gave the code of the real robots, or the page remembered it.
  | {readonly kind: "robots-unlocked"; readonly code: string}
  | {readonly kind: "robot-taken"; readonly robot: string; readonly who: string}
  | {readonly kind: "robot-left"}
  | {readonly kind: "estop-pressed"}
  | {readonly kind: "free-pressed"}
  /// The page is seen no more, in a hidden tab or on a locked screen.
  | {readonly kind: "out-of-sight"}
  | {readonly kind: "speed-chosen"; readonly speed: Speed}
  | {readonly kind: "opened"; readonly opened: Opened}
  /// The learner changed the program in one of its views, or by a command; `at` is now, in milliseconds.
  | {
      readonly kind: "program-changed"
      readonly document: Document
      readonly by: Changer
      readonly at: number
    }
  /// Types were inferred for these blocks; `document` is the one before with what they tell.
  | {readonly kind: "analysed"; readonly before: Document; readonly document: Document}
  | {readonly kind: "undo-pressed"}
  | {readonly kind: "redo-pressed"}
  | {readonly kind: "selected"; readonly block: BlockId | null; readonly in: "blocks" | "haskell"}
  | {readonly kind: "renamed"; readonly name: string}
  | {readonly kind: "stored"; readonly ok: boolean}
  | {readonly kind: "world-chosen"; readonly world: string}
  | {readonly kind: "world-editor-opened"}
  | {readonly kind: "world-edited"; readonly edit: WorldEdit}
  /// The room as it was drawn is the room now, or the drawing is thrown away.
  | {readonly kind: "world-editor-closed"; readonly keep: boolean}
  /// The room as a file: to be asked for, to be handed out, and as it was read (`null` when it holds no text).
  | {readonly kind: "world-file-wanted"}
  | {readonly kind: "world-file-made"}
  | {readonly kind: "world-file-read"; readonly name: string; readonly text: string | null}
  | {readonly kind: "rooms-read"; readonly rooms: readonly World[]}
  | {readonly kind: "worlds-listed"; readonly worlds: readonly string[]}
  | {readonly kind: "gallery"; readonly gallery: Gallery}
  | {readonly kind: "dialog"; readonly dialog: PageState["dialog"]}
  | {readonly kind: "notice"; readonly notice: Notice | null}
  | {readonly kind: "view"; readonly view: View}
  | {readonly kind: "arranged"; readonly arrangement: Arrangement}
  | {readonly kind: "arranging"; readonly arranging: PageState["arranging"]}
  | {readonly kind: "region"; readonly region: Region}
  | {readonly kind: "size"; readonly size: Size}
  | {readonly kind: "tab"; readonly tab: Tab}
  | {readonly kind: "theme"; readonly theme: Theme}
  | {readonly kind: "layout"; readonly layout: Layout}
  | {readonly kind: "muted"; readonly muted: boolean}
  | {readonly kind: "trail"; readonly trail: TrailStyle}
  | {readonly kind: "follows"; readonly follows: boolean}
  | {readonly kind: "films"; readonly films: boolean}

/// What a step of the page asks of the world outside: messages to send, sounds to play.
export type Order =
  | {readonly kind: "send"; readonly message: PageMessage}
  | {readonly kind: "play"; readonly sound: number}
  /// A file of a room: let the learner pick one, or hand one out.
  | {readonly kind: "pick-world"}
  | {readonly kind: "save-world"; readonly name: string; readonly text: string}

export interface Step {
  readonly state: PageState
  readonly orders: readonly Order[]
}

/// The first program is still on its way: over a network that many share it takes a while.
export const awaitsProgram = (state: Pick<PageState, "document">): boolean => state.document === emptyDocument

/// What the blocks find wrong and is to be believed: once the compiler has taken the text, only what is not in the
/// text at all, empty sockets and loose blocks.
export function believed(state: Pick<PageState, "document" | "accepted">): readonly Finding[] {
  const {findings} = state.document
  return state.accepted ? findings.filter(f => f.kind === "hole" || f.kind === "loose") : findings
}
