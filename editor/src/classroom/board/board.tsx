/// Teacher's board: the page with its tools, the hand-ins and the pupils; the key, the invitation, "eyes up", and a pupil's program to look at.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "../../styles/tokens.css"
import "../../styles/page.css"
import "../../styles/controls.css"
import "../../styles/share.css"
import "../../styles/class.css"
import "../../styles/room_tests.css"
import "../../styles/board.css"
import {render, type VNode} from "preact"
import {useState} from "preact/hooks"
import {applyColourScheme} from "../../browser/colour_scheme.ts"
import {chosenLanguage} from "../../browser/preferences.ts"
import {teachersPage} from "../../help/help_links.ts"
import type {LessonDraft} from "../../lesson_files/draft.ts"
import {draftsKey, readDrafts} from "../../lesson_files/draft_storage.ts"
import {openBrowserStorage, tryToStore} from "../../storage/browser_storage.ts"
import {openProgramStore, type ProgramStore} from "../../storage/program_store.ts"
import {words} from "../../words/index.ts"
import {languageFor, loadLanguage} from "../../words/language_choice.ts"
import {dayAndTime} from "../common/day_and_time.ts"
import {Invitation} from "../common/invitation.tsx"
import {KeyForm} from "../common/key_form.tsx"
import {uncheckedCount} from "../messages/hand_in_checks.ts"
import {CheckForm} from "./board_check.tsx"
import {type BoardConnection, openBoardConnection} from "./board_connection.ts"
import {LessonTable} from "./board_lessons.tsx"
import {ResultTable} from "./board_results.tsx"
import {RosterTool} from "./board_roster.tsx"
import {SendTool} from "./board_send.tsx"
import {board, change, rooms} from "./board_state.ts"
import {HandIns, TaskTool} from "./board_tasks.tsx"
import {Pupils, PupilsInNeed} from "./pupil_cards.tsx"
import {PupilOverview} from "./pupil_overview.tsx"
import {ShownProgramDialog} from "./shown_program.tsx"
import {ProjectorTool} from "./tools/projector_tool.tsx"
import {StudyTool} from "./tools/study_tool.tsx"

/// Storage key: the board was an overview when it was shown last.
const overviewKey = "rosy.board.overview"

function open(): void {
  const storage = openBrowserStorage(window)
  change({isOverview: storage.shared.getItem(overviewKey) !== null})
  board.subscribe(({isOverview}) => {
    if (isOverview) tryToStore(storage.shared, overviewKey, "yes")
    else storage.shared.removeItem(overviewKey)
  })
  const programs = openProgramStore(storage.shared, storage.tab)
  const host = document.getElementById("board")
  if (host === null) throw new Error("expected #board in board.html, found nothing")
  document.title = words.classroom.board.title
  applyColourScheme(() => {
    // As other rooms: each miniature is drawn again.
    rooms.value = new Map([...rooms.value].map(([pupil, world]) => [pupil, {...world}]))
  })
  const ownLessons = () => readDrafts(storage.shared.getItem(draftsKey))
  render(<BoardPage {...openBoardConnection(storage)} programs={programs} ownLessons={ownLessons} />, host)
}

interface BoardProps extends BoardConnection {
  readonly programs: ProgramStore
  readonly ownLessons: () => readonly LessonDraft[]
}

function BoardPage({
  send,
  unlock,
  download,
  backUp,
  exportStudy,
  programs,
  ownLessons,
  openRun,
  openProjector,
}: BoardProps): VNode {
  const {
    class: opened,
    link,
    shown,
    tasks,
    lessons,
    pupils,
    taskRefused,
    checking,
    results,
    checkRefused,
    storeFault,
    isOverview,
  } = board.value
  const w = words.classroom.board
  if (opened === null)
    return <KeyForm title={w.title} isLost={link === "lost"} refused={board.value.refused} unlock={unlock} />
  return (
    <>
      <header class="board-head">
        <h1>{w.title}</h1>
        <a href="./">{w.rosy}</a>
        <a href={teachersPage}>{words.guide.teachers}</a>
        <button
          type="button"
          class="plain"
          aria-pressed={isOverview}
          onClick={() => change({isOverview: !isOverview})}
        >
          {w.overview.title}
        </button>
        {isOverview && <EyesUp send={send} />}
        {link === "lost" && (
          <p class="refused" role="status">
            {w.lost}
          </p>
        )}
        {storeFault !== null && (
          <p class="refused" role="status" data-testid="store-fault">
            {w.store[storeFault]}
          </p>
        )}
        {board.value.door.locked && (
          <p class="refused" role="status" data-testid="door-locked">
            {w.roster.locked}
          </p>
        )}
        <Suspended />
        <PupilsInNeed pupils={pupils} />
      </header>
      {isOverview ? (
        <main class="board is-overview">
          <PupilOverview send={send} />
        </main>
      ) : (
        <main class="board">
          <section class="board-tools">
            <Invitation code={opened.code} addresses={opened.addresses} />
            <EyesUp send={send} />
            <SendTool send={send} programs={programs} ownLessons={ownLessons} />
            <ProjectorTool send={send} open={openProjector} />
            <RosterTool send={send} invitation={opened} />
            <BackupTool backUp={backUp} />
            <StudyTool send={send} exportStudy={exportStudy} />
            <TaskTool tasks={tasks} pupils={pupils} send={send} refused={taskRefused} />
          </section>
          <HandIns
            tasks={tasks}
            pupils={pupils}
            send={send}
            download={download}
            connection={opened}
            check={shownTask => (
              <>
                <CheckForm
                  key={shownTask.id}
                  task={shownTask.id}
                  handedIn={shownTask.handedIn}
                  checking={checking}
                  unchecked={uncheckedCount(shownTask, results.get(shownTask.id) ?? new Map(), checking)}
                  refused={checkRefused}
                  own={programs}
                  send={send}
                />
                <ResultTable
                  task={shownTask.id}
                  pupils={pupils}
                  results={results.get(shownTask.id) ?? new Map()}
                  send={send}
                  open={(pupil, room) => openRun(shownTask.id, pupil, room)}
                />
              </>
            )}
          />
          <LessonTable pupils={pupils} lessons={lessons} />
          <Pupils send={send} />
        </main>
      )}
      {shown !== null && <ShownProgramDialog shown={shown} send={send} />}
    </>
  )
}

/// That the teacher's computer slept explains why pupils' pages had no connection.
function Suspended(): VNode | null {
  const w = words.classroom.board.suspended
  const {suspended} = board.value
  if (suspended === null) return null
  const {at, seconds} = suspended
  const isShort = seconds < 120
  return (
    <p class="board-suspended" role="status" data-testid="suspended">
      {isShort
        ? w.seconds(Math.round(seconds), dayAndTime(at))
        : w.minutes(Math.round(seconds / 60), dayAndTime(at))}{" "}
      <button type="button" class="plain" onClick={() => change({suspended: null})}>
        {words.classroom.board.close}
      </button>
    </p>
  )
}

function BackupTool({backUp}: Pick<BoardProps, "backUp">): VNode {
  const w = words.classroom.board
  const [hasFailed, setFailed] = useState(false)
  return (
    <div class="board-tool" data-testid="backup-tool">
      <button type="button" class="plain" onClick={async () => setFailed(!(await backUp()))}>
        {w.backUp}
      </button>
      <p class="quiet">{w.backUpHint}</p>
      {hasFailed && (
        <p class="refused" role="alert">
          {w.task.downloadFailed}
        </p>
      )}
    </div>
  )
}

function EyesUp({send}: Pick<BoardProps, "send">): VNode {
  const w = words.classroom.board
  const {attention} = board.value
  const [message, setMessage] = useState<string>(words.classroom.eyesUp)
  const set = (to: string | null) => {
    if (send({op: "attention", message: to})) change({attention: to})
  }
  return (
    <form
      class="board-tool"
      onSubmit={event => {
        event.preventDefault()
        set(attention === null ? message : null)
      }}
    >
      <label class="field">
        <span>{w.message}</span>
        <input
          type="text"
          value={message}
          maxLength={200}
          onInput={event => setMessage(event.currentTarget.value)}
        />
      </label>
      <button type="submit" class="primary">
        {attention === null ? w.eyesUp : w.goOn}
      </button>
      {attention !== null && <p role="status">{w.areLooking}</p>}
    </form>
  )
}

const fetched = loadLanguage(languageFor(window.location.search, chosenLanguage(), navigator.languages))
if (fetched === undefined) open()
else void fetched.then(open)
