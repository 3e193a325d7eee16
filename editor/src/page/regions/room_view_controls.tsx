/// Controls over the room's canvas: zoom, follow the robot, style of the trail, pictures and recordings.

import type {VNode} from "preact"
import {canRecord} from "../../browser/canvas_recording.ts"
import type {TrailStyle} from "../../state/runs/room_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton, SegmentedControl, usePopup} from "../../ui/controls.tsx"
import {CloserIcon, EyeIcon, FollowIcon, FurtherIcon, StopIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

const trails: readonly TrailStyle[] = ["plain", "speed", "time"]

export function RoomViewControls(): VNode {
  const controller = useController()
  const {store} = controller
  const follows = usePageState(s => s.follows)
  return (
    <>
      <Legend />
      <Filming />
      <fieldset class="sight" aria-label={words.sight}>
        <IconButton
          label={words.follow}
          hint={words.followHint}
          class="hand icon"
          aria-pressed={follows}
          onClick={() => store.dispatch({kind: "follows", follows: !follows})}
        >
          <FollowIcon />
        </IconButton>
        <IconButton label={words.further} class="hand icon" onClick={() => controller.zoomRoom(0.8)}>
          <FurtherIcon />
        </IconButton>
        <IconButton label={words.closer} class="hand icon" onClick={() => controller.zoomRoom(1.25)}>
          <CloserIcon />
        </IconButton>
        <RoomViewMenu />
      </fieldset>
    </>
  )
}

/// The film that is being made, with the button that ends it.
function Filming(): VNode | null {
  const controller = useController()
  const film = usePageState(s => s.film)
  if (film === null) return null
  const w = words.film
  return (
    <div class="filming">
      {film.kind === "run" && (
        <>
          <progress max={100} value={film.percent} aria-label={w.making(film.percent)} />
          <span>{w.making(film.percent)}</span>
          {film.pace > 1 && <span class="quiet">{w.faster(film.pace)}</span>}
        </>
      )}
      <button type="button" class="hand" onClick={controller.endFilm}>
        <StopIcon />
        {film.kind === "run" ? w.cancel : words.endFilm}
      </button>
    </div>
  )
}

function RoomViewMenu(): VNode {
  const controller = useController()
  const {store} = controller
  const {open, box, button, close, toggle} = usePopup("sight")
  const trail = usePageState(s => s.trail)
  const film = usePageState(s => s.film)
  const hasRun = usePageState(s => s.room.run !== null && s.room.recording.length > 0)
  const previewing = usePageState(s => s.previewing)
  const valuesShown = usePageState(s => s.valuesShown)
  const item = (text: string, act: () => void) => (
    <button
      type="button"
      class="item"
      onClick={() => {
        close()
        act()
      }}
    >
      {text}
    </button>
  )
  return (
    <div ref={box}>
      <button
        type="button"
        class="hand icon"
        ref={button}
        aria-label={words.sightMenu}
        title={words.sightMenu}
        aria-expanded={open}
        onClick={toggle}
      >
        <EyeIcon />
      </button>
      {open && (
        <div class="menu-items sight-items">
          <p class="label">{words.trail}</p>
          <SegmentedControl
            label={words.trail}
            options={trails.map(t => [t, words.trails[t]])}
            value={trail}
            choose={chosen => store.dispatch({kind: "trail", trail: chosen})}
          />
          <hr />
          <label class="item check">
            <input
              type="checkbox"
              checked={previewing}
              onChange={() => store.dispatch({kind: "previewing", previewing: !previewing})}
            />
            {words.preview.show}
          </label>
          <label class="item check" title={words.why.valuesHint}>
            <input
              type="checkbox"
              checked={valuesShown}
              onChange={() => store.dispatch({kind: "values-shown", shown: !valuesShown})}
            />
            {words.why.values}
          </label>
          {item(words.wholeRoom, controller.fitRoom)}
          {item(words.savePicture, controller.savePicture)}
          {film === null && hasRun && (
            <>
              {canRecord() && item(words.film.webm, () => void controller.filmRun("webm"))}
              {item(words.film.gif, () => void controller.filmRun("gif"))}
            </>
          )}
          {film === null && !hasRun && canRecord() && item(words.startFilm, controller.startFilm)}
        </div>
      )}
    </div>
  )
}

/// What the trail's colours and widths mean.
function Legend(): VNode | null {
  const trail = usePageState(s => s.trail)
  const there = usePageState(s => s.room.trail.length > 0)
  if (trail === "plain" || !there) return null
  const [from, to] = words.trailEnds[trail]
  return (
    <p class="legend">
      {from}
      {[1, 2, 3, 4, 5].map(level => (
        <span
          key={level}
          aria-hidden="true"
          style={{"--level": level, background: `var(--trail-${level})`}}
        />
      ))}
      {to}
    </p>
  )
}
