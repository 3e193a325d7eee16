/// The page's state as one value without a DOM, and its first value.

import type {Confusable, NodePlaces} from "@rosy/codegen"
import type {OlderEncoding, TextFile} from "@rosy/codegen/text-file"
import type {BlockComment} from "../program/block_comments.ts"
import {
  type Document,
  emptyDocument,
  emptyHistory,
  type History,
  type NumberDrag,
} from "../program/history.ts"
import type {BlockId, Finding} from "../program/program.ts"
import type {OwnTopic, ProgramPart} from "../program/program_graph.ts"
import type {UnreadText} from "../program/unread_texts.ts"
import type {Declaration, TypesAtPlaces} from "../wire/worker.generated.ts"
import type {WorldEditor} from "../worlds/editor_value.ts"
import type {World, WorldFile} from "../worlds/world.ts"
import {type Arrangement, firstArrangement, type Region} from "./arrangement.ts"
import {type LessonsState, noLessons} from "./lesson_state.ts"
import type {OfferedFixes} from "./messages/fix_previews.ts"
import type {RecordedFile, Speed, WorkerState} from "./messages/messages.ts"
import {noQuestion, type WhyState} from "./messages/why_state.ts"
import {noRobots, type RobotsState, type SafetyRules} from "./robots.ts"
import type {Companion} from "./runs/companions.ts"
import {type ConsoleLine, emptyRoom, type RoomState, type TrailStyle} from "./runs/room_state.ts"
import type {RunState} from "./runs/run_state.ts"
import {noRuns, type RunTree} from "./runs/run_tree.ts"

/// How much room the window has: all regions, two of them, or one at a time.
export type Size = "wide" | "tablet" | "phone"
export type Tab = "console" | "charts" | "runs" | "sensors" | "problems"
/// Seconds that a strip chart shows, or all of the run.
export type ChartSpan = 20 | 60 | "all"
export type Theme = "auto" | "light" | "dark"

export interface Example {
  readonly name: string
  readonly title: string
  readonly teaches: string
  /// The name of its group in the gallery; empty for an example without one.
  readonly level: string
}

export type Gallery =
  | {readonly kind: "unasked"}
  | {readonly kind: "asked"}
  | {readonly kind: "there"; readonly examples: readonly Example[]}
  | {readonly kind: "failed"}

/// What others need to open the program.
/// Who can open a link: all that reach the page, others on the network of this computer by another address than the page's, or this computer alone.
export type Reach = "page" | "network" | "computer"

export interface Shared {
  readonly link: string
  /// The link as a QR code; `null` when it is too long for one.
  readonly code: {readonly size: number; readonly path: string} | null
  /// Markup for a page elsewhere.
  readonly embed: string
  readonly reach: Reach
}

/// Characters that look right and are not, as they were found in a text. There is at least one.
export interface FoundConfusables {
  readonly text: string
  readonly found: readonly [Confusable, ...Confusable[]]
}

/// Something the page itself has to say; `words` has the sentences.
export type Notice =
  | {readonly kind: "unreadable-file"; readonly name: string; readonly message: string; readonly hint: string}
  | {readonly kind: "not-text"; readonly name: string}
  | ({readonly kind: "older-encoding"; readonly name: string; readonly text: string} & OlderEncoding)
  | {readonly kind: "empty-file"; readonly name: string}
  /// `name` is what the characters came with: a file, or the pasted text.
  | ({readonly kind: "confusable"; readonly name: string} & FoundConfusables)
  /// A folder or an archive with several programs, one of which can be opened; `unread` more could not be read.
  | {
      readonly kind: "several-programs"
      readonly name: string
      readonly programs: readonly {readonly name: string; readonly content: TextFile}[]
      readonly unread: number
    }
  | {readonly kind: "no-programs"; readonly name: string}
  /// More files or letters than are read at once.
  | {readonly kind: "too-many-files"; readonly name: string}
  | {readonly kind: "damaged-archive"; readonly name: string}
  /// Text, but neither a program nor a room.
  | {readonly kind: "not-program"; readonly name: string}
  | {readonly kind: "too-large"; readonly name: string}
  /// `path` is empty when it is about the whole file.
  | {readonly kind: "unreadable-world"; readonly name: string; readonly path: string; readonly why: string}
  | {readonly kind: "example-missing"; readonly name: string}
  | {readonly kind: "lesson-missing"; readonly name: string}
  /// `at` is the place of the mistake in the lesson's file.
  | {readonly kind: "damaged-lesson"; readonly name: string; readonly at: string}
  /// The version of the file's format, and the newest that this page reads.
  | {readonly kind: "newer-lesson"; readonly name: string; readonly version: number; readonly newest: number}
  | {readonly kind: "refusal"; readonly message: string; readonly hint: string}
  /// A film from now on, or one of a run.
  | {readonly kind: "no-film"; readonly isLive: boolean}
  | {readonly kind: "no-reader"}
  | {readonly kind: "backpack"; readonly result: BackpackResult}
  /// `gone` are names of deleted programs that were removed for good to make room.
  | {readonly kind: "not-saved"; readonly gone: readonly string[]}
  | {readonly kind: "made-way"; readonly gone: readonly string[]}
  | {readonly kind: "progress-not-saved"}
  /// So many definitions were left as they are when the text was laid out.
  | {readonly kind: "not-formatted"; readonly left: number}
  /// An edit of blocks was taken back: the text of these definitions, read again, would not be the tree of their blocks.
  | {readonly kind: "other-meaning"; readonly names: readonly string[]}
  /// An edit of blocks was taken back: the compiler groups the new text of these definitions in another way than the blocks.
  | {readonly kind: "grouped-otherwise"; readonly names: readonly string[]}
  /// An edit of blocks was taken back: the compiler cannot read the new text of these definitions, and could read the text before.
  | {readonly kind: "unreadable-edit"; readonly names: readonly string[]}
  /// An edit of blocks would have lost what is unfinished in the text of these definitions.
  | {readonly kind: "unfinished-text"; readonly names: readonly string[]}
  /// Two tabs changed the same program; this tab's version is stored as the copy.
  | {readonly kind: "became-two"; readonly name: string; readonly copy: string}
  /// The browser keeps nothing for this page.
  | {readonly kind: "no-storage"}
  | {readonly kind: "damaged-link"}
  /// A changed program that goes on from a moment differs from the last run before that moment; seconds of the run.
  | {readonly kind: "diverged"; readonly time: number}
  /// After this time, it is not known whether it differs: the commands of the run before are no longer kept.
  | {readonly kind: "uncompared"; readonly time: number}
  | {readonly kind: "robot-gone"; readonly name: string; readonly why: string}
  | {readonly kind: "out-of-sight"; readonly name: string}

/// The learner's own room, while the page shows a room of a test in its place.
export interface ReplacedRoom {
  /// The name of the room of the test.
  readonly by: string
  readonly own: string | WorldFile
}

/// What became of a definition on its way into the backpack or out of it.
export type BackpackResult =
  /// `others` came along.
  | {readonly kind: "packed"; readonly name: string; readonly others: readonly string[]}
  | {readonly kind: "not-packed"; readonly name: string}
  | {readonly kind: "full"}
  /// What was added, which of it has another name now, and what the program had already.
  | {
      readonly kind: "unpacked"
      readonly added: readonly string[]
      readonly renamed: readonly {readonly from: string; readonly to: string}[]
      readonly present: readonly string[]
    }
  | {readonly kind: "not-unpacked"; readonly name: string; readonly why: string}

/// A film of the room from now on, or one of the recorded run: how much of it is done, and how many times faster than the run it is.
export type FilmInTheMaking =
  | {readonly kind: "live"}
  | {readonly kind: "run"; readonly percent: number; readonly pace: number}

export interface PageState {
  readonly name: string
  readonly saved: "saved" | "changed" | "failed"
  readonly document: Document
  /// The text as it is being typed, until the document has it; `null` when there is no other.
  readonly pendingText: string | null
  readonly history: History
  readonly worldName: string | WorldFile | null
  /// `null` while the room is the learner's own. Another choice of room leaves it; then `by` is not the name of the room.
  readonly replacedRoom: ReplacedRoom | null
  readonly link: "connecting" | "open" | "lost"
  /// The name that ROS clients reach the robot by; `null` before the first connection.
  readonly session: string | null
  readonly worker: WorkerState
  /// Why the worker cannot start, in a sentence; empty unless it has failed.
  readonly workerFault: string
  readonly run: RunState
  /// The number of the newest run; each run takes the next.
  readonly runs: number
  /// The newest question to the compiler; an answer to an older one is dropped.
  readonly checks: number
  /// A number is being dragged.
  readonly numberDrag: NumberDrag
  /// The newest question for a preview; an answer to an older one is dropped.
  readonly previews: number
  /// The lists of fixes that can be seen.
  readonly offeredFixes: readonly OfferedFixes[]
  /// Whether previews are shown.
  readonly previewing: boolean
  /// Whether blocks and text show the values of the displayed moment.
  readonly valuesShown: boolean
  /// The random seed of the newest run: runs with the same seed are equal to the last bit. `null` before the first.
  readonly seed: number | null
  /// The run's clock: it goes, or it stands at a step until it is let go.
  readonly clock: "going" | "standing"
  readonly speed: Speed
  /// The program's own names with the types that the compiler found.
  readonly declared: readonly Declaration[]
  /// The type of every piece of the text that the compiler has read last.
  readonly types: TypesAtPlaces & {readonly text: string}
  /// The texts that the compiler could parse, newest first.
  readonly parsed: readonly string[]
  /// What edits of blocks have written and the compiler has not read yet.
  readonly unread: readonly UnreadText[]
  /// What the newest program without mistakes runs, and its text; `null` before the first.
  readonly network: {readonly parts: readonly ProgramPart[]; readonly text: string} | null
  /// The topics that the program connects its types to itself, of its newest text that the compiler could read.
  readonly topics: readonly OwnTopic[]
  /// What the diagram region shows, how many drawings there have been, and the node of the newest one that was chosen last.
  readonly diagram: {
    readonly outcome: "waiting" | "drawn" | "empty" | "failed"
    readonly drawings: number
    readonly chosen: {readonly kind: string; readonly key: string} | null
    /// The pointer or the keyboard is in it: what functions took and gave last can be read there.
    readonly isPointedAt: boolean
    /// The nodes that the learner moved.
    readonly places: NodePlaces
  }
  readonly room: RoomState
  /// The other robots that start in the room with the next run.
  readonly companions: readonly Companion[]
  /// The runs in this room.
  readonly runTree: RunTree
  readonly robots: RobotsState
  /// The newest run on a real robot that is recorded, as long as the service knows it.
  readonly recorded: RecordedFile | null
  /// The newest run that shows a recording.
  readonly replay: number | null
  readonly safety: SafetyRules
  readonly lines: readonly ConsoleLine[]
  /// The console also shows the ends of events and the state of the robot's connection.
  readonly allEvents: boolean
  readonly findings: {
    readonly compiler: readonly Finding[]
    readonly run: readonly Finding[]
  }
  /// The compiler accepted the newest text it answered about. Then its answer replaces the findings of the blocks' inference,
  /// which does not support every library and extension that a program from elsewhere may use.
  readonly accepted: boolean
  /// The text that Run refused last and the sockets that were empty in it; `null` if no run of this program was refused.
  /// Only these empty sockets are problems.
  readonly refused: Refused | null
  readonly selected: BlockId | null
  /// Where the cursor is that chose it.
  readonly selectedIn: "blocks" | "haskell"
  /// The offset of the cursor in the text that selected it; `null` when it was selected elsewhere.
  readonly cursor: number | null
  readonly welcome: "fresh" | "ran" | "over"
  /// A new learner is asked how to begin.
  readonly welcoming: boolean
  /// The step of the demonstration that is shown; `null` while there is none.
  readonly demonstration: number | null
  readonly gallery: Gallery
  readonly dialog:
    | "gallery"
    | "lessons"
    | "challenges"
    | "programs"
    | "backpack"
    | "rooms"
    | "companions"
    | "menu"
    | "sight"
    | "robots"
    | "arrange"
    | "keys"
    | "share"
    | "room-tests"
    | null
  /// For the share dialog; `null` until it is made.
  readonly shared: Shared | null
  /// The page is part of another site: it shows and runs one program and stores nothing.
  readonly embedded: boolean
  readonly lessons: LessonsState
  readonly why: WhyState
  /// The rooms of the service, for their gallery; `null` until they have been read.
  readonly rooms: readonly World[] | null
  readonly notice: Notice | null
  /// The teacher's comments on the open program that the pupil has not dealt with.
  readonly blockComments: readonly BlockComment[]
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
  /// The function whose graph the charts show; `null` for none.
  readonly graphed: string | null
  /// Seconds that a curve shows, or all of the run.
  readonly chartSpan: ChartSpan
  readonly theme: Theme
  readonly muted: boolean
  /// What the colour and the width of the trail tell.
  readonly trail: TrailStyle
  /// The picture of the room goes with the robot.
  readonly follows: boolean
  /// The film that is being made; `null` when there is none.
  readonly film: FilmInTheMaking | null
  readonly worlds: readonly string[]
  readonly layout: Layout
  /// The room that is being changed; `null` while none is.
  readonly worldEditor: WorldEditor | null
}

/// Where borders inside regions are: the share of the room's picture in its height.
export interface Layout {
  readonly canvas: number
}

export const initialState: PageState = {
  name: "",
  saved: "saved",
  document: emptyDocument,
  pendingText: null,
  history: emptyHistory,
  worldName: null,
  replacedRoom: null,
  link: "connecting",
  session: null,
  worker: "starting",
  workerFault: "",
  run: {kind: "ready"},
  runs: 0,
  checks: 0,
  numberDrag: null,
  previews: 0,
  offeredFixes: [],
  previewing: true,
  valuesShown: false,
  seed: null,
  clock: "going",
  speed: 1,
  declared: [],
  types: {text: "", names: [], at: []},
  parsed: [],
  unread: [],
  network: null,
  topics: [],
  diagram: {outcome: "waiting", drawings: 0, chosen: null, isPointedAt: false, places: {}},
  room: emptyRoom,
  companions: [],
  runTree: noRuns,
  robots: noRobots,
  recorded: null,
  replay: null,
  safety: {on: false, since: null},
  lines: [],
  allEvents: false,
  findings: {compiler: [], run: []},
  accepted: false,
  refused: null,
  selected: null,
  selectedIn: "blocks",
  cursor: null,
  welcome: "over",
  welcoming: false,
  demonstration: null,
  gallery: {kind: "unasked"},
  dialog: null,
  shared: null,
  embedded: false,
  lessons: noLessons,
  why: noQuestion,
  rooms: null,
  notice: null,
  blockComments: [],
  arrangement: firstArrangement,
  arranging: null,
  region: "blocks",
  size: "wide",
  tab: "console",
  charts: ["speed", "bumperCenter"],
  graphed: null,
  chartSpan: 20,
  theme: "auto",
  muted: false,
  trail: "plain",
  follows: false,
  film: null,
  worlds: [],
  layout: {canvas: 0.56},
  worldEditor: null,
}

/// The room of the page is a room of a test, which replaced the learner's own.
export function isTestRoomShown({replacedRoom, worldName}: PageState): boolean {
  if (replacedRoom === null || worldName === null) return false
  return replacedRoom.by === (typeof worldName === "string" ? worldName : worldName["name"])
}

/// The first program is still on its way: over a network that many share it takes a while.
export const awaitsProgram = (state: Pick<PageState, "document">): boolean => state.document === emptyDocument

export interface Refused {
  readonly text: string
  /// Keys of the empty sockets.
  readonly sockets: ReadonlySet<string>
}
