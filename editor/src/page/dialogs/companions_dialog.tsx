/// Dialog of the other robots in the room: one more, the program and the place of each, and taking one away.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {type Companion, freePlace, isFreePlace} from "../../state/runs/companions.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {BinIcon, CloserIcon} from "../../ui/icons.tsx"
import {maxRunCompanions} from "../../wire/page/runs.generated.ts"
import {words} from "../../words/index.ts"
import type {World} from "../../worlds/world.ts"
import {Angle, PlaceFields} from "./property_fields.tsx"

export function CompanionsDialog(): VNode {
  return (
    <Dialog name="companions" title={words.companions.more} lead={words.companions.lead}>
      {() => <Companions />}
    </Dialog>
  )
}

function Companions(): VNode | null {
  const {store} = useController()
  const world = usePageState(s => s.room.world)
  const companions = usePageState(s => s.companions)
  const [refusal, setRefusal] = useState("")
  if (world === null) return null
  const w = words.companions
  const choose = (changed: readonly Companion[]) => {
    setRefusal("")
    store.dispatch({kind: "companions-chosen", companions: changed})
  }
  const change = (index: number, to: Partial<Companion>) =>
    choose(companions.map((one, i) => (i === index ? {...one, ...to} : one)))
  const place = (index: number, to: Partial<World["start"]>) => {
    const others = companions.filter((_, i) => i !== index)
    const at = {...world.start, ...companions[index], ...to}
    if (isFreePlace(world, at, others)) change(index, to)
    else setRefusal(w.taken)
  }
  const add = () => {
    const at = freePlace(world, companions)
    if (companions.length >= maxRunCompanions) setRefusal(w.full(maxRunCompanions))
    else if (at === null) setRefusal(w.noPlace)
    else choose([...companions, {...at, program: null}])
  }
  return (
    <>
      <p role="status">{refusal}</p>
      {companions.length === 0 && <p class="quiet">{w.none}</p>}
      <ul class="companion-list">
        {companions.map((companion, i) => (
          <CompanionFields
            key={i}
            number={i + 2}
            world={world}
            companion={companion}
            setProgram={program => change(i, {program})}
            setPlace={to => place(i, to)}
            remove={() => choose(companions.filter((_, other) => other !== i))}
          />
        ))}
      </ul>
      <p class="pair">
        <button type="button" class="plain" onClick={add}>
          <CloserIcon /> {w.one}
        </button>
      </p>
      <p class="quiet">{w.about}</p>
    </>
  )
}

/// `number` counts the robots of the room; that of the run is the first.
function CompanionFields(props: {
  readonly number: number
  readonly world: World
  readonly companion: Companion
  readonly setProgram: (program: Companion["program"]) => void
  readonly setPlace: (to: Partial<World["start"]>) => void
  readonly remove: () => void
}): VNode {
  const {number, world, companion, setProgram, setPlace, remove} = props
  const {myPrograms} = useController()
  const w = words.companions
  const {program} = companion
  const programs = myPrograms.list().filter(({id}) => !myPrograms.isOpen(id))
  const chosen = program === null || programs.some(({id}) => id === program.id) ? [] : [program]
  const choose = (id: string) => {
    const text = id === "" ? null : myPrograms.haskell(id)
    const name = programs.find(one => one.id === id)?.name ?? ""
    setProgram(text === null ? null : {id, name, text})
  }
  return (
    <li>
      <b class="companion-name" style={{"--companion": `var(--robot-${number})`}}>
        {w.robot(number)}
      </b>
      <select
        aria-label={w.program(number)}
        value={program?.id ?? ""}
        onChange={event => choose(event.currentTarget.value)}
      >
        <option value="">{w.openProgram}</option>
        {[...chosen, ...programs].map(({id, name}) => (
          <option key={id} value={id}>
            {name === "" ? words.unnamed : name}
          </option>
        ))}
      </select>
      <fieldset class="companion-place" aria-label={w.place(number)}>
        <PlaceFields world={world} x={companion.x} y={companion.y} set={setPlace} />
        <Angle value={companion.theta} set={theta => setPlace({theta})} />
      </fieldset>
      <button
        type="button"
        class="plain icon"
        aria-label={w.takeAway(number)}
        title={w.takeAway(number)}
        onClick={remove}
      >
        <BinIcon />
      </button>
    </li>
  )
}
