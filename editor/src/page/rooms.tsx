/// The gallery of rooms: a picture and a name of each, and the learner's own.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {drawPicture} from "../room/picture.ts"
import {words} from "../words/index.ts"
import type {World} from "../worlds/world.ts"
import {Dialog} from "./dialog.tsx"
import {useDesk, usePage} from "./pick.ts"

export function RoomsDialog(): VNode {
  return (
    <Dialog name="rooms" title={words.world.rooms} lead={words.world.roomsLead}>
      {() => <Rooms />}
    </Dialog>
  )
}

function Rooms(): VNode {
  const {store} = useDesk()
  const rooms = usePage(s => s.rooms)
  const ask = (text: string, act: () => void) => (
    <button
      type="button"
      class="plain"
      onClick={() => {
        store.dispatch({kind: "dialog", dialog: null})
        act()
      }}
    >
      {text}
    </button>
  )
  return (
    <>
      {rooms === null ? <p class="quiet late">{words.world.roomsLoading}</p> : <Cards rooms={rooms} />}
      <p class="pair">
        {ask(words.world.change, () => store.dispatch({kind: "world-editor-opened"}))}
        {ask(words.world.openFile, () => store.dispatch({kind: "world-file-wanted"}))}
        {ask(words.world.saveFile, () => store.dispatch({kind: "world-file-made"}))}
      </p>
    </>
  )
}

function Cards({rooms}: {rooms: readonly World[]}): VNode {
  const {store} = useDesk()
  const chosen = usePage(s => s.room.world)
  const own = chosen !== null && !rooms.some(room => room.name === chosen.name)
  return (
    <ul class="cards">
      {own && (
        <li>
          <Card room={chosen} chosen={true} choose={() => store.dispatch({kind: "dialog", dialog: null})} />
        </li>
      )}
      {rooms.map(room => (
        <li key={room.name}>
          <Card
            room={room}
            chosen={room.name === chosen?.name}
            choose={() => store.dispatch({kind: "world-chosen", world: room.name})}
          />
        </li>
      ))}
    </ul>
  )
}

function Card({room, chosen, choose}: {room: World; chosen: boolean; choose: () => void}): VNode {
  const canvas = useRef<HTMLCanvasElement>(null)
  useLayoutEffect(() => {
    if (canvas.current !== null) drawPicture(canvas.current, room)
  }, [room])
  const [goal] = room.goals
  return (
    <button type="button" class="card" aria-current={chosen} onClick={choose}>
      <canvas ref={canvas} />
      <b>{nameOfRoom(room)}</b>
      {goal !== undefined && goal.title !== "" && <span>{goal.title}</span>}
    </button>
  )
}

/// What a room is called.
export function nameOfRoom(room: Pick<World, "name" | "title">): string {
  return room.title !== "" ? room.title : room.name !== "" ? room.name : words.ownWorld
}
