/// Page for the projector: the room of the pupil whom the teacher has chosen on the board, large, with the nickname and the program if the teacher wants them; or the standings of a task; without a choice the address and the code with which pupils join.

import "@fontsource/inter/400.css"
import "@fontsource/inter/600.css"
import "@fontsource/jetbrains-mono/400.css"
import "../../styles/tokens.css"
import "../../styles/page.css"
import "../../styles/controls.css"
import "../../styles/class.css"
import "../../styles/board.css"
import "../../styles/projector.css"
import {type Signal, signal} from "@preact/signals"
import {render, type VNode} from "preact"
import {useEffect, useRef} from "preact/hooks"
import {applyColourScheme} from "../../browser/colour_scheme.ts"
import {chosenLanguage} from "../../browser/preferences.ts"
import type {Frame} from "../../state/messages/messages.ts"
import {addFrame, clearRoom, emptyRoom, type RoomState} from "../../state/runs/room_state.ts"
import {openBrowserStorage, tryToStore} from "../../storage/browser_storage.ts"
import {openRoom} from "../../views/room/room_view.ts"
import type {
  Invitation as Invited,
  Projected,
  UnlockProjector,
} from "../../wire/classroom/projector_messages.generated.ts"
import {words} from "../../words/index.ts"
import {languageFor, loadLanguage} from "../../words/language_choice.ts"
import {Invitation} from "../common/invitation.tsx"
import {KeyForm} from "../common/key_form.tsx"
import {openClassSocket} from "../messages/class_socket.ts"
import {teacherKey} from "../messages/membership.ts"
import {type ProjectorMessage, readProjectorMessage} from "../messages/projector_messages.ts"
import {StandingsTable} from "./standings_table.tsx"

interface Screen {
  readonly isLost: boolean
  readonly refused: string | null
  /// `null` before the key fits.
  readonly projected: Projected | null
  /// Shown while no pupil is.
  readonly invitation: Invited | null
}

function open(): void {
  const host = document.getElementById("projector")
  if (host === null) throw new Error("expected #projector in projector.html, found nothing")
  document.title = words.classroom.projector.title
  applyColourScheme(() => {
    colours.value += 1
  })
  const screen = signal<Screen>({isLost: false, refused: null, projected: null, invitation: null})
  const room = signal<RoomState>(emptyRoom)
  render(<ProjectorPage screen={screen} room={room} unlock={connect(screen, room)} />, host)
}

/// Connects with the key of the address, or with the one that this tab had before. The result tries another key.
function connect(screen: Signal<Screen>, room: Signal<RoomState>): (key: string) => void {
  const {tab} = openBrowserStorage(window)
  const brought = new URLSearchParams(window.location.hash.slice(1)).get("key")
  // Out of the address, so that nobody reads it from the projector.
  if (brought !== null) window.history.replaceState(null, "", window.location.pathname)
  let key = brought ?? tab.getItem(teacherKey)
  const change = (to: Partial<Screen>) => {
    screen.value = {...screen.value, ...to}
  }
  const socket = openClassSocket<UnlockProjector, ProjectorMessage>("api/projector", readProjectorMessage, {
    opened() {
      change({isLost: false})
      if (key !== null) socket.send({op: "unlock", key})
    },
    lost: () => change({isLost: true}),
    received(message) {
      if (message.op === "projected") {
        tryToStore(tab, teacherKey, key ?? "")
        if (message.number !== screen.value.projected?.number) room.value = emptyRoom
        change({projected: message, refused: null})
      } else if (message.op === "invitation") change({invitation: message})
      else if (message.op === "room") room.value = {...emptyRoom, world: message.world, idle: true}
      else if (message.op === "frame") room.value = withFrame(room.value, message.frame)
      else if (message.reason === "key" || message.reason === "attempts") {
        tab.removeItem(teacherKey)
        change({projected: null, refused: words.classroom.refused[message.reason]})
      }
    },
  })
  return typed => {
    key = typed.trim()
    socket.send({op: "unlock", key})
  }
}

/// A run that begins, and a robot that was put back, have no trail yet.
function withFrame(room: RoomState, frame: Frame): RoomState {
  const {frame: last, run} = room
  const isNew = frame.run !== run || (last !== null && frame.step < last.step)
  return addFrame(isNew ? clearRoom(room, frame.run) : room, frame)
}

interface Props {
  readonly screen: Signal<Screen>
  readonly room: Signal<RoomState>
  readonly unlock: (key: string) => void
}

function ProjectorPage({screen, room, unlock}: Props): VNode {
  const w = words.classroom.projector
  const {isLost, refused, projected, invitation} = screen.value
  if (projected === null) return <KeyForm title={w.title} isLost={isLost} refused={refused} unlock={unlock} />
  const {shows, nickname, online, running, haskell, standings} = projected
  const states = words.classroom.board
  if (standings !== null) return <StandingsTable standings={standings} isLost={isLost} />
  if (!shows)
    return (
      <main class="projector-empty" data-testid="projector">
        {invitation !== null && <Invitation {...invitation} />}
        <p role="status">{isLost ? states.lost : ""}</p>
      </main>
    )
  return (
    <main class={haskell === null ? "projector" : "projector with-program"} data-testid="projector">
      <header>
        <h1>
          <bdi>{nickname ?? w.pupil}</bdi>
        </h1>
        <p role="status">
          {isLost ? states.lost : online ? (running ? states.running : states.ready) : states.away}
        </p>
      </header>
      <Room room={room} label={words.classroom.board.room(nickname ?? w.pupil)} />
      {haskell !== null && (
        // A field that cannot be changed: the keyboard scrolls it.
        <textarea readOnly spellcheck={false} aria-label={w.program} value={haskell} />
      )}
    </main>
  )
}

/// Another number after each change of the colour scheme.
const colours = signal(0)

const sight = {trail: "plain", follows: false, hands: false, held: null, overlay: null} as const

function Room({room, label}: {room: Signal<RoomState>; label: string}): VNode {
  const canvas = useRef<HTMLCanvasElement>(null)
  useEffect(() => {
    if (canvas.current === null) return
    let asked: number | null = null
    const redraw = () => {
      asked ??= requestAnimationFrame(now => {
        asked = null
        if (view.draw(room.value, sight, now)) redraw()
      })
    }
    const nothing = () => {}
    const view = openRoom(canvas.current, {
      // Called while the view is made, too.
      changed: () => queueMicrotask(redraw),
      placed: nothing,
      pushed: nothing,
      holds: nothing,
      companionPlaced: nothing,
      follows: nothing,
      asked: nothing,
      read: nothing,
    })
    const stop = room.subscribe(redraw)
    const stopRecolouring = colours.subscribe(view.recolour)
    return () => {
      stop()
      stopRecolouring()
      if (asked !== null) cancelAnimationFrame(asked)
      view.dispose()
    }
  }, [])
  return <canvas ref={canvas} role="img" aria-label={label} />
}

const fetched = loadLanguage(languageFor(window.location.search, chosenLanguage(), navigator.languages))
if (fetched === undefined) open()
else void fetched.then(open)
