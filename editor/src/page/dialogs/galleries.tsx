/// Gallery of examples, and gallery of rooms.

import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import type {WorldEvent} from "../../state/page_events.ts"
import type {Example} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {Dialog, TextWithCode} from "../../ui/controls.tsx"
import {drawThumbnail} from "../../views/room/world_drawing.ts"
import {words} from "../../words/index.ts"
import {wordedText} from "../../words/worker_sentences.ts"
import {aboutRobot, simulatedRobots, usualRobot, type World} from "../../worlds/world.ts"

export function GalleryDialog(): VNode {
  return (
    <Dialog name="gallery" title={words.galleryTitle} lead={words.galleryLead}>
      {() => <Examples />}
    </Dialog>
  )
}

function Examples(): VNode {
  const gallery = usePageState(s => s.gallery)
  const controller = useController()
  const name = usePageState(s => s.name)
  if (gallery.kind === "failed")
    return (
      <p>
        {words.galleryFailed}{" "}
        <button type="button" class="link" onClick={() => controller.openGallery()}>
          {words.again}
        </button>
      </p>
    )
  if (gallery.kind !== "there") return <p class="quiet late">{words.galleryLoading}</p>
  const titles: Readonly<Record<string, string>> = words.exampleLevels
  const levels = [...new Set(gallery.examples.map(example => example.level))]
  return (
    <>
      {levels.map(level => (
        <section key={level}>
          {levels.length > 1 && <h3>{titles[level] ?? words.otherExamples}</h3>}
          <ul class="cards">
            {gallery.examples
              .filter(example => example.level === level)
              .map(example => (
                <ExampleCard key={example.name} example={example} current={example.name === name} />
              ))}
          </ul>
        </section>
      ))}
    </>
  )
}

/// The picture of its path and the first sentence of what it teaches; the rest on request.
function ExampleCard({example, current}: {example: Example; current: boolean}): VNode {
  const controller = useController()
  const [whole, setWhole] = useState(false)
  const teaches = wordedText(example.teaches)
  const [first = "", ...rest] = teaches.split(/(?<=[.!?])\s+/)
  const title = example.title === "" ? example.name : example.title
  return (
    <li class="card" aria-current={current}>
      <button
        type="button"
        class="opens"
        aria-current={current}
        title={whole ? undefined : teaches}
        onClick={() => controller.openExample(example.name)}
      >
        <PathPicture name={example.name} />
        <b>{title}</b>
        <span class={whole ? "" : "line"}>
          <TextWithCode text={whole ? teaches : first} strong={null} />
        </span>
      </button>
      {rest.length > 0 && (
        <button
          type="button"
          class="plain more"
          aria-expanded={whole}
          aria-label={words.moreAbout(title)}
          onClick={() => setWhole(!whole)}
        >
          {whole ? "−" : "+"}
        </button>
      )}
    </li>
  )
}

/// The room of an example and the path that the robot drives in it; empty until the service has computed it.
function PathPicture({name}: {name: string}): VNode {
  const controller = useController()
  const canvas = useRef<HTMLCanvasElement>(null)
  useLayoutEffect(() => {
    let isShown = true
    void controller.examplePath(name).then(found => {
      if (isShown && found !== null && canvas.current !== null)
        drawThumbnail(canvas.current, found.world, found.path)
    })
    return () => {
      isShown = false
    }
  }, [controller, name])
  return <canvas ref={canvas} />
}

export function RoomsDialog(): VNode {
  return (
    <Dialog name="rooms" title={words.world.rooms} lead={words.world.roomsLead}>
      {() => <Rooms />}
    </Dialog>
  )
}

function Rooms(): VNode {
  const {store} = useController()
  const rooms = usePageState(s => s.rooms)
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
      <RobotChoice />
      {rooms === null ? <p class="quiet late">{words.world.roomsLoading}</p> : <Cards rooms={rooms} />}
      <p class="pair">
        {ask(words.world.change, () => store.dispatch({kind: "world-editor-opened"}))}
        {ask(words.world.openFile, () => store.dispatch({kind: "world-file-wanted"}))}
        {ask(words.world.saveFile, () => store.dispatch({kind: "world-file-made"}))}
      </p>
    </>
  )
}

/// The robot in the room; a real robot takes its place.
function RobotChoice(): VNode | null {
  const {store} = useController()
  const world = usePageState(s => (s.robots.held === null ? s.room.world : null))
  if (world === null) return null
  return (
    <label class="simulated-robot">
      {words.world.robot}
      <select
        value={world.robot}
        onChange={event => {
          const robot = simulatedRobots.find(name => name === event.currentTarget.value) ?? usualRobot
          store.dispatch({kind: "world-taken", world: {...world, robot}})
        }}
      >
        {simulatedRobots.map(name => (
          <option key={name} value={name}>
            {aboutRobot(name).title}
          </option>
        ))}
      </select>
    </label>
  )
}

/// A robot that was chosen stays in the next room, if that has none of its own.
function withRobotOf(chosen: World | null, room: World): WorldEvent {
  const stays = chosen !== null && chosen.robot !== usualRobot && room.robot === usualRobot
  if (!stays) return {kind: "world-chosen", world: room.name}
  return {kind: "world-taken", world: {...room, robot: chosen.robot}}
}

function Cards({rooms}: {rooms: readonly World[]}): VNode {
  const {store} = useController()
  const chosen = usePageState(s => s.room.world)
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
            choose={() => {
              store.dispatch({kind: "dialog", dialog: null})
              store.dispatch(withRobotOf(chosen, room))
            }}
          />
        </li>
      ))}
    </ul>
  )
}

function Card({room, chosen, choose}: {room: World; chosen: boolean; choose: () => void}): VNode {
  const canvas = useRef<HTMLCanvasElement>(null)
  useLayoutEffect(() => {
    if (canvas.current !== null) drawThumbnail(canvas.current, room)
  }, [room])
  const [goal] = room.goals
  return (
    <button type="button" class="card" aria-current={chosen} onClick={choose}>
      <canvas ref={canvas} />
      <b>{nameOfRoom(room)}</b>
      {goal !== undefined && goal.title !== "" && <span>{wordedText(goal.title)}</span>}
      {room.robot !== usualRobot && <span>{aboutRobot(room.robot).title}</span>}
    </button>
  )
}

/// What a room is called.
export function nameOfRoom(room: Pick<World, "name" | "title">): string {
  return room.title !== "" ? wordedText(room.title) : room.name !== "" ? room.name : words.ownWorld
}
