/// Teacher's board: the page with its tools, the hand-ins and the pupils; the key, the invitation, "eyes up", and a pupil's program to look at.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "../styles/tokens.css"
import "../styles/page.css"
import "../styles/controls.css"
import "../styles/share.css"
import "../styles/class.css"
import "../styles/room_tests.css"
import "../styles/board.css"
import {render, type VNode} from "preact"
import {useState} from "preact/hooks"
import {openBrowserStorage} from "../browser/browser_storage.ts"
import {applyColourScheme} from "../browser/colour_scheme.ts"
import {chosenLanguage} from "../browser/preferences.ts"
import {openProgramStore, type ProgramStore} from "../browser/program_store.ts"
import {teachersPage} from "../help/help_links.ts"
import {words} from "../words/index.ts"
import {languageFor, loadLanguage} from "../words/language_choice.ts"
import {CheckForm} from "./board_check.tsx"
import {type BoardConnection, openBoardConnection} from "./board_connection.ts"
import {ResultTable} from "./board_results.tsx"
import {SendTool} from "./board_send.tsx"
import {board, change, rooms} from "./board_state.ts"
import {HandIns, TaskTool} from "./board_tasks.tsx"
import {uncheckedCount} from "./hand_in_checks.ts"
import {Invitation} from "./invitation.tsx"
import {KeyForm} from "./key_form.tsx"
import {ProjectorTool} from "./projector_tool.tsx"
import {Pupils, PupilsInNeed} from "./pupil_cards.tsx"
import {ShownProgramDialog} from "./shown_program.tsx"

function open(): void {
  const storage = openBrowserStorage(window)
  const programs = openProgramStore(storage.shared, storage.tab)
  const host = document.getElementById("board")
  if (host === null) throw new Error("expected #board in board.html, found nothing")
  document.title = words.classroom.board.title
  applyColourScheme(() => {
    // As other rooms: each miniature is drawn again.
    rooms.value = new Map([...rooms.value].map(([pupil, world]) => [pupil, {...world}]))
  })
  render(<BoardPage {...openBoardConnection(storage)} programs={programs} />, host)
}

interface BoardProps extends BoardConnection {
  readonly programs: ProgramStore
}

function BoardPage({send, unlock, download, backUp, programs, openRun, openProjector}: BoardProps): VNode {
  const {
    class: opened,
    link,
    shown,
    tasks,
    pupils,
    taskRefused,
    checking,
    results,
    checkRefused,
    storeFault,
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
        <PupilsInNeed pupils={pupils} />
      </header>
      <main class="board">
        <section class="board-tools">
          <Invitation code={opened.code} addresses={opened.addresses} />
          <EyesUp send={send} />
          <SendTool send={send} programs={programs} />
          <ProjectorTool send={send} open={openProjector} />
          <BackupTool backUp={backUp} />
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
                task={shownTask.id}
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
        <Pupils send={send} />
      </main>
      {shown !== null && <ShownProgramDialog shown={shown} send={send} />}
    </>
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
