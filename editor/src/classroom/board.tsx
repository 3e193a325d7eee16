/// Teacher's board: who is in the class, who needs help, every room in miniature, a pupil's program to look at, "eyes up", and a program for all.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "../styles/tokens.css"
import "../styles/page.css"
import "../styles/controls.css"
import "../styles/share.css"
import "../styles/class.css"
import "../styles/room_tests.css"
import "../styles/board.css"
import {type Signal, signal} from "@preact/signals"
import {render, type VNode} from "preact"
import {useEffect, useLayoutEffect, useRef, useState} from "preact/hooks"
import {openBrowserStorage} from "../browser/browser_storage.ts"
import {downloadBlob} from "../browser/local_files.ts"
import {chosenLanguage} from "../browser/preferences.ts"
import {openProgramStore, type ProgramStore} from "../browser/program_store.ts"
import {type QrCode, qrCodeOf} from "../browser/qr_code.ts"
import {fragmentOf} from "../browser/share_link.ts"
import {drawThumbnail} from "../room/world_drawing.ts"
import {words} from "../words/index.ts"
import {languageFor, loadLanguage} from "../words/language_choice.ts"
import type {World} from "../worlds/world.ts"
import {CheckForm, ResultTable} from "./board_check.tsx"
import {
  type BoardMessage,
  type BoardRequest,
  type BoardTask,
  type Place,
  type PupilOnBoard,
  readBoardMessage,
} from "./board_messages.ts"
import {HandIns, TaskTool} from "./board_tasks.tsx"
import {openClassSocket} from "./class_socket.ts"
import {dayAndTime} from "./day_and_time.ts"
import {type Checking, projectInRoom, type Results, type RunInRoom, uncheckedCount} from "./hand_in_checks.ts"
import {teacherKey} from "./membership.ts"

interface Board {
  readonly link: "connecting" | "open" | "lost"
  readonly class: {readonly code: string; readonly addresses: readonly string[]} | null
  readonly refused: string | null
  readonly attention: string | null
  readonly pupils: readonly PupilOnBoard[]
  /// A pupil's program to look at: its link for an embedded page.
  readonly shown: {readonly nickname: string; readonly name: string; readonly address: string} | null
  readonly tasks: readonly BoardTask[]
  /// Why the last task was not opened, or the last change not stored.
  readonly taskRefused: string | null
  readonly checking: Checking
  /// By task.
  readonly results: ReadonlyMap<number, Results>
  readonly checkRefused: string | null
  /// What the last command did.
  readonly said: string
}

const board: Signal<Board> = signal({
  link: "connecting",
  class: null,
  refused: null,
  attention: null,
  pupils: [],
  shown: null,
  tasks: [],
  taskRefused: null,
  checking: {number: 0, task: null, done: 0, of: 0, rooms: 0},
  results: new Map(),
  checkRefused: null,
  said: "",
})
/// Rooms and robots change ten times a second; each miniature reads its own.
const rooms = signal<ReadonlyMap<number, World>>(new Map())
const places = signal<ReadonlyMap<number, Place>>(new Map())
const change = (to: Partial<Board>) => {
  board.value = {...board.value, ...to}
}

function open(): void {
  const storage = openBrowserStorage(window)
  const programs = openProgramStore(storage.shared, storage.tab)
  const brought = new URLSearchParams(window.location.hash.slice(1)).get("key")
  // Out of the address, so that it is not on the projector.
  if (brought !== null) window.history.replaceState(null, "", window.location.pathname)
  const tabs = openRunTabs()
  let key = brought ?? storage.tab.getItem(teacherKey)
  const socket = openClassSocket<BoardRequest, BoardMessage>("api/board", readBoardMessage, {
    opened() {
      change({link: "open"})
      if (key !== null) socket.send({op: "unlock", key})
    },
    lost: () => change({link: "lost"}),
    received(message) {
      if (message.op === "board") {
        storage.tab.setItem(teacherKey, key ?? "")
        storage.shared.setItem(teacherKey, "yes")
        change({class: message, attention: message.attention, refused: null, results: new Map()})
      } else if (message.op === "refused") {
        if (message.reason === "key" || message.reason === "attempts") {
          storage.tab.removeItem(teacherKey)
          change({refused: words.classroom.refused[message.reason], class: null})
        } else if (message.reason === "deadline" || message.reason === "tasks" || message.reason === "disk")
          change({taskRefused: words.classroom.board.refused[message.reason]})
        else if (message.reason === "rooms") change({checkRefused: words.classroom.board.check.refused})
      } else if (message.op === "pupils") change({pupils: message.pupils})
      else if (message.op === "room") rooms.value = new Map([...rooms.value, [message.pupil, message.world]])
      else if (message.op === "places")
        places.value = new Map([
          ...places.value,
          ...message.places.map(place => [place.pupil, place] as const),
        ])
      else if (message.op === "tasks") change({tasks: message.tasks, taskRefused: null})
      else if (message.op === "sent") change({said: words.classroom.board.sent(message.pages)})
      else if (message.op === "checking") change({checking: message})
      else if (message.op === "result") change({results: withResult(board.value.results, message)})
      else if (message.op === "run") void tabs.fill(message)
      else void show(message)
    },
  })
  const send = (request: BoardRequest) => {
    if (request.op === "check-all") change({checkRefused: null})
    if (!socket.send(request)) change({link: "lost"})
  }
  const unlock = (typed: string) => {
    key = typed.trim()
    send({op: "unlock", key})
  }
  const host = document.getElementById("board")
  if (host === null) throw new Error("expected #board in board.html, found nothing")
  document.title = words.classroom.board.title
  const download = (task: BoardTask) => downloadHandIns(task, key ?? "")
  const openRun = (task: number, pupil: number) => {
    tabs.open(pupil)
    send({op: "open-run", task, pupil})
  }
  render(
    <BoardPage send={send} unlock={unlock} download={download} programs={programs} openRun={openRun} />,
    host,
  )
}

/// The results after a message; `null` takes one away.
function withResult(
  results: ReadonlyMap<number, Results>,
  {task, pupil, result}: BoardMessage & {readonly op: "result"},
): ReadonlyMap<number, Results> {
  const changed = new Map(results.get(task))
  if (result === null) changed.delete(pupil)
  else changed.set(pupil, result)
  return new Map([...results, [task, changed]])
}

/// Tabs for pupils' programs in their worst rooms. A browser lets a page open one only while a click is served, so it is empty until the program arrives.
function openRunTabs() {
  const waiting = new Map<number, Window | null>()
  return {
    open(pupil: number) {
      waiting.get(pupil)?.close()
      waiting.set(pupil, window.open("", "_blank"))
    },
    async fill({pupil, name, text, world, seed}: RunInRoom) {
      const tab = waiting.get(pupil)
      waiting.delete(pupil)
      if (text === null) return tab?.close()
      const nickname = board.value.pupils.find(one => one.id === pupil)?.nickname ?? ""
      const project = projectInRoom(text, words.classroom.board.programOf(nickname, name), world)
      const address = new URL(`./?seed=${seed}&run${await fragmentOf(project)}`, window.location.href)
      tab?.location.replace(address.href)
    },
  }
}

/// The programs of a task and a table of them, as a ZIP file; whether there was one.
async function downloadHandIns(task: BoardTask, key: string): Promise<boolean> {
  try {
    const answer = await fetch(`api/hand-ins/${task.id}`, {headers: {"X-Rosy-Key": key}})
    if (!answer.ok) return false
    downloadBlob(`${task.title}.zip`, await answer.blob())
    return true
  } catch (fault) {
    // The service is away.
    if (fault instanceof TypeError) return false
    throw fault
  }
}

async function show(message: BoardMessage & {readonly op: "program"}): Promise<void> {
  const pupil = board.value.pupils.find(one => one.id === message.pupil)
  if (message.text === null || pupil === undefined) return
  const address = `./?embed${await fragmentOf(message.text)}`
  change({shown: {nickname: pupil.nickname, name: message.name, address}})
}

interface BoardProps {
  readonly send: (request: BoardRequest) => void
  readonly unlock: (key: string) => void
  readonly download: (task: BoardTask) => Promise<boolean>
  readonly programs: ProgramStore
  /// Opens a pupil's program for a task in its worst room.
  readonly openRun: (task: number, pupil: number) => void
}

function BoardPage({send, unlock, download, programs, openRun}: BoardProps): VNode {
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
  } = board.value
  const w = words.classroom.board
  if (opened === null) return <Lock unlock={unlock} />
  return (
    <>
      <header class="board-head">
        <h1>{w.title}</h1>
        <a href="./">{w.rosy}</a>
        {link === "lost" && <p role="status">{w.lost}</p>}
      </header>
      <main class="board">
        <section class="board-tools">
          <Invitation code={opened.code} addresses={opened.addresses} />
          <EyesUp send={send} />
          <SendProgram send={send} programs={programs} />
          <TaskTool tasks={tasks} pupils={pupils} send={send} refused={taskRefused} />
        </section>
        <HandIns
          tasks={tasks}
          pupils={pupils}
          send={send}
          download={download}
          connection={opened}
          check={({id, handedIn}) => (
            <>
              <CheckForm
                task={id}
                checking={checking}
                unchecked={uncheckedCount(handedIn, results.get(id) ?? new Map(), checking)}
                refused={checkRefused}
                own={programs}
                send={send}
              />
              <ResultTable
                pupils={pupils}
                results={results.get(id) ?? new Map()}
                open={pupil => openRun(id, pupil)}
              />
            </>
          )}
        />
        <Pupils send={send} />
      </main>
      {shown !== null && <ShownProgram />}
    </>
  )
}

function Lock({unlock}: Pick<BoardProps, "unlock">): VNode {
  const w = words.classroom.board
  const {refused, link} = board.value
  const [key, setKey] = useState("")
  return (
    <main class="board-lock">
      <form
        class="class-form"
        onSubmit={event => {
          event.preventDefault()
          unlock(key)
        }}
      >
        <h1>{w.title}</h1>
        <p class="quiet">{w.lead}</p>
        <label class="field">
          <span>{w.key}</span>
          <input
            type="password"
            value={key}
            required
            maxLength={60}
            autocomplete="off"
            onInput={event => setKey(event.currentTarget.value)}
          />
        </label>
        {link === "lost" ? (
          <p role="status">{w.lost}</p>
        ) : (
          refused !== null && (
            <p class="refused" role="alert">
              {refused}
            </p>
          )
        )}
        <button type="submit" class="primary">
          {w.open}
        </button>
      </form>
    </main>
  )
}

/// Modules of light around a code (ISO/IEC 18004, section 6.3.8).
const quietZone = 4

function Invitation({code, addresses}: {code: string; addresses: readonly string[]}): VNode {
  const w = words.classroom.board
  const [address] = addresses
  const drawing = address === undefined ? null : qrCodeOf(`${address}#class=${code}`)
  return (
    <div class="board-invitation">
      {drawing !== null && <Code drawing={drawing} />}
      <dl>
        <dt>{w.pupilsOpen}</dt>
        <dd>{addresses.length === 0 ? w.noNetwork : addresses.map(one => <div key={one}>{one}</div>)}</dd>
        <dt>{words.classroom.code}</dt>
        <dd class="board-code" data-testid="class-code">
          {code}
        </dd>
      </dl>
    </div>
  )
}

function Code({drawing}: {drawing: QrCode}): VNode {
  const side = drawing.size + 2 * quietZone
  return (
    <svg
      class="board-qr"
      role="img"
      aria-label={words.classroom.board.qr}
      viewBox={`${-quietZone} ${-quietZone} ${side} ${side}`}
    >
      <rect x={-quietZone} y={-quietZone} width={side} height={side} fill="#fff" />
      <path d={drawing.path} fill="#000" shape-rendering="crispEdges" />
    </svg>
  )
}

function EyesUp({send}: Pick<BoardProps, "send">): VNode {
  const w = words.classroom.board
  const {attention} = board.value
  const [message, setMessage] = useState<string>(words.classroom.eyesUp)
  const set = (to: string | null) => {
    send({op: "attention", message: to})
    change({attention: to})
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

function SendProgram({send, programs}: Pick<BoardProps, "send" | "programs">): VNode {
  const w = words.classroom.board
  const list = programs.programs()
  const [id, setId] = useState(programs.current()?.id ?? list[0]?.id ?? "")
  if (list.length === 0) return <p class="quiet board-tool">{w.sendNone}</p>
  return (
    <form
      class="board-tool"
      onSubmit={event => {
        event.preventDefault()
        const text = programs.read(id)
        const name = list.find(program => program.id === id)?.name ?? ""
        if (text !== null) send({op: "send", name, text})
      }}
    >
      <label class="field">
        <span>{w.send}</span>
        <select value={id} onChange={event => setId(event.currentTarget.value)}>
          {list.map(program => (
            <option key={program.id} value={program.id}>
              {program.name || words.unnamed}
            </option>
          ))}
        </select>
      </label>
      <button type="submit" class="plain">
        {w.send}
      </button>
      <p role="status" class="quiet">
        {board.value.said}
      </p>
    </form>
  )
}

function Pupils({send}: Pick<BoardProps, "send">): VNode {
  const {pupils} = board.value
  if (pupils.length === 0) return <p class="board-empty quiet">{words.classroom.board.empty}</p>
  return (
    <ul class="board-pupils">
      {pupils.map(pupil => (
        <PupilCard key={pupil.id} pupil={pupil} send={send} />
      ))}
    </ul>
  )
}

function PupilCard({pupil, send}: {pupil: PupilOnBoard} & Pick<BoardProps, "send">): VNode {
  const w = words.classroom.board
  const {id, nickname, online, running, program, changed, lesson, needs} = pupil
  const handedIn = board.value.tasks.find(task => task.open)?.handedIn.find(one => one.pupil === id)
  return (
    <li class={needs.length > 0 ? "needs-help" : online ? "" : "away"} data-testid={`pupil ${nickname}`}>
      <h2>
        <bdi>{nickname}</bdi>
      </h2>
      <p class="quiet">{online ? (running ? w.running : w.ready) : w.away}</p>
      <Miniature pupil={id} nickname={nickname} />
      {needs.map(need => (
        <p key={need} class="board-need">
          {w.needs[need]}
          {need === "hand" && (
            <button type="button" class="plain" onClick={() => send({op: "lower", pupil: id})}>
              {w.lower}
            </button>
          )}
        </p>
      ))}
      <p>
        {program === null ? (
          <span class="quiet">{w.noProgram}</span>
        ) : (
          <>
            <b>
              <bdi>{program || words.unnamed}</bdi>
            </b>{" "}
            <span class="quiet">{changed !== null && w.changed(age(changed))}</span>
          </>
        )}
      </p>
      {handedIn !== undefined && <p>{w.task.at(dayAndTime(handedIn.at))}</p>}
      {lesson !== null && <p class="quiet">{w.lesson(lesson.name, lesson.done, lesson.steps)}</p>}
      <details>
        <summary>{w.words}</summary>
        <p>{pupil.words}</p>
      </details>
      {program !== null && (
        <button
          type="button"
          class="plain"
          aria-label={w.lookAt(nickname)}
          onClick={() => send({op: "open", pupil: id, program: null})}
        >
          {w.look}
        </button>
      )}
    </li>
  )
}

function age(seconds: number): string {
  const w = words.classroom.board
  if (seconds < 60) return w.now
  if (seconds < 3600) return w.minutes(Math.floor(seconds / 60))
  return seconds < 86_400 ? w.hours(Math.floor(seconds / 3600)) : w.days(Math.floor(seconds / 86_400))
}

/// The room of a pupil's page with the robot where it is.
function Miniature({pupil, nickname}: {pupil: number; nickname: string}): VNode | null {
  const canvas = useRef<HTMLCanvasElement>(null)
  const world = rooms.value.get(pupil)
  const place = places.value.get(pupil)
  useEffect(() => {
    if (canvas.current !== null && world !== undefined)
      drawThumbnail(canvas.current, {...world, start: place ?? world.start})
  }, [world, place])
  if (world === undefined) return null
  return <canvas ref={canvas} role="img" aria-label={words.classroom.board.room(nickname)} />
}

function ShownProgram(): VNode | null {
  const w = words.classroom.board
  const {shown} = board.value
  const dialog = useRef<HTMLDialogElement>(null)
  useLayoutEffect(() => dialog.current?.showModal(), [])
  if (shown === null) return null
  const title = w.programOf(shown.nickname, shown.name)
  return (
    <dialog class="board-program" ref={dialog} aria-label={title} onClose={() => change({shown: null})}>
      <header>
        <h2>{title}</h2>
        <p class="quiet">{w.readOnly}</p>
        <button type="button" class="plain" onClick={() => change({shown: null})}>
          {w.close}
        </button>
      </header>
      <iframe src={shown.address} title={title} />
    </dialog>
  )
}

const fetched = loadLanguage(languageFor(window.location.search, chosenLanguage(), navigator.languages))
if (fetched === undefined) open()
else void fetched.then(open)
