/// Events that change the page's state, grouped by the reducer that applies them.

import type {NodePlaces} from "@rosy/codegen"
import type {BlockComment} from "../program/block_comments.ts"
import type {ChangeOrigin, Document, History} from "../program/history.ts"
import type {BlockId} from "../program/program.ts"
import type {ChangeDesc} from "../program/text_changes.ts"
import type {WorldEdit} from "../worlds/editor_value.ts"
import type {Pose, World, WorldFile} from "../worlds/world.ts"
import type {Arrangement, Region, View} from "./arrangement.ts"
import type {LessonEvent} from "./lesson_state.ts"
import type {OfferedFixes} from "./messages/fix_previews.ts"
import type {Hand, ServiceMessage, Speed} from "./messages/messages.ts"
import type {WhyEvent} from "./messages/why_state.ts"
import type {
  ChartSpan,
  FilmInTheMaking,
  Gallery,
  Layout,
  Notice,
  PageState,
  ReplacedRoom,
  Shared,
  Size,
  Tab,
  Theme,
} from "./page_state.ts"
import type {Companion} from "./runs/companions.ts"
import type {TrailStyle} from "./runs/room_state.ts"

export type RunTreeEvent =
  /// A stored run is looked at again.
  | {readonly kind: "run-shown"; readonly run: number}
  /// A stored run is drawn over the shown one; `null` for none.
  | {readonly kind: "run-compared"; readonly run: number | null}

export interface Opened {
  readonly name: string
  readonly world: string | WorldFile | null
  readonly document: Document
  /// Nodes of the diagram that were moved.
  readonly places?: NodePlaces
  /// The steps of undo that were kept.
  readonly history: History
  /// The first program of a new learner: Run pulses once, and after the first run a line invites to change a number.
  readonly welcome: boolean
  /// There was no program on this page before: the learner is asked how to begin.
  readonly isFirstVisit?: boolean
  /// A new program: it opens at the usual speed.
  readonly isNew: boolean
  /// It belongs to the open lesson, which stays open.
  readonly inLesson?: boolean
  /// The first program of the page: a dialog that was opened before it arrived stays open.
  readonly isFirst?: boolean
  /// Stored with the program while its room is a room of a test.
  readonly replacedRoom?: ReplacedRoom | null
}

/// The connection to the service.
export type ConnectionEvent =
  | {readonly kind: "link-lost"}
  | {readonly kind: "heard"; readonly message: ServiceMessage}

/// Run, Stop, Reset, the clock of the run, and the learner's input in the room.
export type RunEvent =
  /// `seed` is a new random seed, chosen outside of the state; without it the run has the seed of the one before.
  | {readonly kind: "run-pressed"; readonly seed?: number}
  | {readonly kind: "stop-pressed"}
  | {readonly kind: "reset-pressed"}
  | {readonly kind: "pause-pressed"}
  | {readonly kind: "resume-pressed"}
  | {readonly kind: "forward-pressed"}
  | {readonly kind: "speed-chosen"; readonly speed: Speed}
  /// The learner looks at this time of the run; `null` is now.
  | {readonly kind: "looked-back"; readonly time: number | null}
  /// The run goes on from the moment that is looked at.
  | {readonly kind: "continue-pressed"}
  | {readonly kind: "hand"; readonly hand: Hand}
  | {readonly kind: "safety-switched"; readonly on: boolean}
  | {readonly kind: "values-shown"; readonly shown: boolean}
  /// The pointer or the keyboard came to the diagram, or left it.
  | {readonly kind: "diagram-pointed"; readonly isPointedAt: boolean}
  /// The graph of a function is opened in the charts; `null` closes it.
  | {readonly kind: "function-graphed"; readonly function: string | null}

/// The recording of this page's run `of` is looked at; `null` for that of the file that the page has sent.
export interface RecordingEvent {
  readonly kind: "recording-wanted"
  readonly of: number | null
}

/// Real robots.
export type RobotEvent =
  /// The learner gave the code of the real robots, or the page remembered it.
  | {readonly kind: "robots-unlocked"; readonly code: string}
  | {readonly kind: "robot-taken"; readonly robot: string; readonly who: string}
  | {readonly kind: "robot-left"}
  | {readonly kind: "estop-pressed"}
  | {readonly kind: "free-pressed"}
  /// Whether the program also drives the simulated robot beside the real one.
  | {readonly kind: "twin-switched"; readonly on: boolean}
  /// The page is seen no more, in a hidden tab or on a locked screen.
  | {readonly kind: "out-of-sight"}

/// The program, its name, and what is stored of it.
export type DocumentEvent =
  | {readonly kind: "opened"; readonly opened: Opened}
  /// Another tab changed and stored the open program; `at` is now, in milliseconds.
  | {
      readonly kind: "followed"
      readonly name: string
      readonly world: string | WorldFile | null
      readonly replacedRoom: ReplacedRoom | null
      readonly document: Document
      readonly places?: NodePlaces
      readonly at: number
    }
  /// Nodes of the diagram were moved; none has a place of its own after tidying up.
  | {readonly kind: "nodes-moved"; readonly places: NodePlaces}
  /// The learner has typed; the document follows with the next `program-changed`.
  | {readonly kind: "text-typed"; readonly text: string}
  /// The learner changed the program in one of its views, or by a command; `at` is now, in milliseconds.
  | {
      readonly kind: "program-changed"
      /// From the text before to the text of `document`; computed from the texts if absent.
      readonly changes?: ChangeDesc
      readonly document: Document
      readonly by: ChangeOrigin
      readonly at: number
    }
  /// Types were inferred for these blocks; `document` is the one before with what they tell.
  | {readonly kind: "analysed"; readonly before: Document; readonly document: Document}
  | {readonly kind: "undo-pressed"}
  | {readonly kind: "redo-pressed"}
  /// A drag of a number begins or ends.
  | {readonly kind: "number-drag"; readonly going: boolean}
  | {readonly kind: "renamed"; readonly name: string}
  | {readonly kind: "stored"; readonly ok: boolean}

/// The room, its editor, and its files.
export type WorldEvent =
  | {readonly kind: "world-chosen"; readonly world: string}
  /// A room with another robot than its own.
  | {readonly kind: "world-taken"; readonly world: World}
  /// A room of a test takes the place of the learner's own, and the learner's own comes back.
  | {readonly kind: "test-room-opened"; readonly world: World}
  | {readonly kind: "own-room-restored"}
  /// The room has these robots besides the first one. Ends a run, as another room does.
  | {readonly kind: "companions-chosen"; readonly companions: readonly Companion[]}
  /// The programs of some of them are stored anew; a run goes on.
  | {readonly kind: "companions-stored"; readonly companions: readonly Companion[]}
  /// A hand takes one of them to another place before a run; where it has no room it stays where it was, which is said when it is dropped there.
  | {
      readonly kind: "companion-placed"
      readonly companion: number
      readonly place: Pose
      readonly isDropped: boolean
    }
  | {readonly kind: "world-editor-opened"}
  | {readonly kind: "world-edited"; readonly edit: WorldEdit}
  /// The edited room becomes the room of the page, or is discarded.
  | {readonly kind: "world-editor-closed"; readonly keep: boolean}
  /// The room as a file: to be asked for, to be handed out, and as it was read (`null` when it holds no text).
  | {readonly kind: "world-file-wanted"}
  | {readonly kind: "world-file-made"}
  | {readonly kind: "world-file-read"; readonly name: string; readonly text: string}

/// What the page shows, and the learner's settings.
export type ViewEvent =
  /// The keyboard takes hold of a movable thing, or of the robot again.
  | {readonly kind: "held"; readonly thing: number | null}
  /// `at` is the offset of the cursor, when that chose the block.
  | {
      readonly kind: "selected"
      readonly block: BlockId | null
      readonly in: "blocks" | "haskell"
      readonly at?: number
    }
  | {readonly kind: "charted"; readonly quantities: readonly string[]}
  | {readonly kind: "chart-span"; readonly span: ChartSpan}
  | {readonly kind: "tab"; readonly tab: Tab}
  | {readonly kind: "region"; readonly region: Region}
  | {readonly kind: "size"; readonly size: Size}
  | {readonly kind: "view"; readonly view: View}
  | {readonly kind: "arranged"; readonly arrangement: Arrangement}
  | {readonly kind: "arranging"; readonly arranging: PageState["arranging"]}
  | {readonly kind: "layout"; readonly layout: Layout}
  /// A new diagram was drawn with these nodes, or could not be. The chosen node stays chosen if it is among them.
  | {
      readonly kind: "diagram"
      readonly outcome: PageState["diagram"]["outcome"]
      readonly nodes?: readonly {readonly kind: string; readonly key: string}[]
    }
  /// The learner chose a node of the diagram.
  | {readonly kind: "node-chosen"; readonly node: PageState["diagram"]["chosen"]}
  | {readonly kind: "dialog"; readonly dialog: PageState["dialog"]}
  | {readonly kind: "shared"; readonly shared: Shared | null}
  | {readonly kind: "notice"; readonly notice: Notice | null}
  | {readonly kind: "gallery"; readonly gallery: Gallery}
  | {readonly kind: "rooms-read"; readonly rooms: readonly World[]}
  | {readonly kind: "worlds-listed"; readonly worlds: readonly string[]}
  | {readonly kind: "theme"; readonly theme: Theme}
  | {readonly kind: "muted"; readonly muted: boolean}
  | {readonly kind: "trail"; readonly trail: TrailStyle}
  | {readonly kind: "all-events"; readonly allEvents: boolean}
  | {readonly kind: "previewing"; readonly previewing: boolean}
  | {readonly kind: "welcoming"; readonly welcoming: boolean}
  /// The demonstration shows another step, or has ended.
  | {readonly kind: "demonstration"; readonly step: number | null}
  /// A list of fixes can be seen, or can no longer be: then it has no texts.
  | {readonly kind: "fixes-offered"; readonly offered: OfferedFixes}
  /// A while has passed since this question for a preview.
  | {readonly kind: "preview-late"; readonly id: number}
  | {readonly kind: "follows"; readonly follows: boolean}
  | {readonly kind: "film"; readonly film: FilmInTheMaking | null}
  /// The teacher's comments on the open program, to be shown at their places.
  | {readonly kind: "block-comments"; readonly comments: readonly BlockComment[]}

export type PageEvent =
  | ConnectionEvent
  | RunEvent
  | RunTreeEvent
  | RecordingEvent
  | RobotEvent
  | DocumentEvent
  | WorldEvent
  | ViewEvent
  | {readonly kind: "lesson"; readonly event: LessonEvent}
  | {readonly kind: "why"; readonly event: WhyEvent}
