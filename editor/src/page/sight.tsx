/// How the room is seen: closer, from further away, with the robot; what the trail tells; pictures and films.

import type {VNode} from "preact"
import {canFilm} from "../run/film.ts"
import type {TrailStyle} from "../state/room.ts"
import {words} from "../words/index.ts"
import {CloserIcon, EyeIcon, FollowIcon, FurtherIcon, StopIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {usePopup} from "./popup.ts"
import {Segments} from "./segments.tsx"

const trails: readonly TrailStyle[] = ["plain", "speed", "time"]

export function Sight(): VNode {
  const desk = useDesk()
  const {store} = desk
  const follows = usePage(s => s.follows)
  const films = usePage(s => s.films)
  return (
    <>
      <Legend />
      {films && (
        <button type="button" class="hand filming" onClick={() => desk.film(false)}>
          <StopIcon />
          {words.endFilm}
        </button>
      )}
      <fieldset class="sight" aria-label={words.sight}>
        <button
          type="button"
          class="hand icon"
          aria-label={words.follow}
          title={words.followHint}
          aria-pressed={follows}
          onClick={() => store.dispatch({kind: "follows", follows: !follows})}
        >
          <FollowIcon />
        </button>
        <button
          type="button"
          class="hand icon"
          aria-label={words.further}
          title={words.further}
          onClick={() => desk.zoomRoom(0.8)}
        >
          <FurtherIcon />
        </button>
        <button
          type="button"
          class="hand icon"
          aria-label={words.closer}
          title={words.closer}
          onClick={() => desk.zoomRoom(1.25)}
        >
          <CloserIcon />
        </button>
        <SightMenu />
      </fieldset>
    </>
  )
}

function SightMenu(): VNode {
  const desk = useDesk()
  const {store} = desk
  const {open, box, button, toggle} = usePopup("sight")
  const trail = usePage(s => s.trail)
  const films = usePage(s => s.films)
  const item = (text: string, act: () => void) => (
    <button
      type="button"
      class="item"
      onClick={() => {
        toggle(false)
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
        onClick={() => toggle(!open)}
      >
        <EyeIcon />
      </button>
      {open && (
        <div class="menu-items sight-items">
          <p class="label">{words.trail}</p>
          <Segments
            label={words.trail}
            options={trails.map(t => [t, words.trails[t]])}
            value={trail}
            choose={chosen => store.dispatch({kind: "trail", trail: chosen})}
          />
          <hr />
          {item(words.wholeRoom, desk.wholeRoom)}
          {item(words.savePicture, desk.savePicture)}
          {canFilm() && item(films ? words.endFilm : words.startFilm, () => desk.film(!films))}
        </div>
      )}
    </div>
  )
}

/// What the trail's colours and widths mean.
function Legend(): VNode | null {
  const trail = usePage(s => s.trail)
  const there = usePage(s => s.room.trail.length > 0)
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
