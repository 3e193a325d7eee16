/// Dialog of the learner's programs: a card for each with a picture of its blocks, its name and date; open, rename, duplicate, delete and restore.

import type {VNode} from "preact"
import {useEffect, useLayoutEffect, useRef, useState} from "preact/hooks"
import type {Outline} from "../../browser/block_picture.ts"
import type {StoredProgram} from "../../storage/stored_values.ts"
import {useController} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {BinIcon, CloserIcon, DuplicateIcon, EditIcon} from "../../ui/icons.tsx"
import {measures, words} from "../../words/index.ts"

export function MyProgramsDialog(): VNode {
  return (
    <Dialog name="programs" title={words.myPrograms.title} lead={words.myPrograms.lead}>
      {() => <Programs />}
    </Dialog>
  )
}

const shownName = ({name}: Pick<StoredProgram, "name">) => (name === "" ? words.unnamed : name)

function Programs(): VNode {
  const {myPrograms, newProgram, openFile, store} = useController()
  /// The program store is read again after each command.
  const [, setVersion] = useState(0)
  const [removed, setRemoved] = useState<StoredProgram | null>(null)
  const [renaming, setRenaming] = useState<string | null>(null)
  const update = (act: () => void) => {
    act()
    setVersion(version => version + 1)
  }
  const restore = (id: string) =>
    update(() => {
      myPrograms.restore(id)
      setRemoved(null)
    })
  const open = (id: string) =>
    myPrograms.isOpen(id) ? store.dispatch({kind: "dialog", dialog: null}) : myPrograms.open(id)
  const rename = (id: string, name: string | null) =>
    update(() => {
      setRenaming(null)
      if (name !== null) myPrograms.rename(id, name)
    })
  const list = myPrograms.list()
  const deleted = myPrograms.deleted()
  return (
    <>
      <p class="removed" role="status">
        {removed !== null && (
          <>
            {words.myPrograms.removed(shownName(removed))}{" "}
            <button type="button" class="link" onClick={() => restore(removed.id)}>
              {words.myPrograms.undo}
            </button>
          </>
        )}
      </p>
      <ul class="program-cards">
        <li>
          <button type="button" class="new-program" onClick={newProgram}>
            <CloserIcon />
            {words.newProgram}
          </button>
        </li>
        {list.map(program => (
          <li key={program.id} class="program-card" aria-current={myPrograms.isOpen(program.id)}>
            <button type="button" class="opens" onClick={() => open(program.id)}>
              <BlockPicture outlines={myPrograms.picture(program.id)} />
              {renaming !== program.id && <b>{shownName(program)}</b>}
              <span class="quiet">
                {myPrograms.isOpen(program.id)
                  ? words.myPrograms.open
                  : measures.moment(new Date(program.at))}
              </span>
            </button>
            {renaming === program.id && (
              <NameField program={program} done={name => rename(program.id, name)} />
            )}
            <p class="card-commands">
              <Command label={words.myPrograms.rename} program={program} act={() => setRenaming(program.id)}>
                <EditIcon />
              </Command>
              <Command
                label={words.myPrograms.duplicate}
                program={program}
                act={() => update(() => myPrograms.duplicate(program.id))}
              >
                <DuplicateIcon />
              </Command>
              <Command
                label={words.myPrograms.remove}
                program={program}
                act={() =>
                  update(() => {
                    myPrograms.remove(program.id)
                    setRemoved(program)
                  })
                }
              >
                <BinIcon />
              </Command>
            </p>
          </li>
        ))}
      </ul>
      {list.length === 0 && <p class="quiet">{words.myPrograms.none}</p>}
      <p class="pair">
        <button type="button" class="plain" onClick={openFile}>
          {words.openFile}
        </button>
      </p>
      {deleted.length > 0 && (
        <details class="deleted">
          <summary>{words.myPrograms.deleted}</summary>
          <ul>
            {deleted.map(program => (
              <li key={program.id}>
                <span>{shownName(program)}</span>
                <span class="quiet">{measures.moment(new Date(program.at))}</span>
                <button
                  type="button"
                  class="plain"
                  aria-label={words.myPrograms.restore(shownName(program))}
                  onClick={() => restore(program.id)}
                >
                  {words.myPrograms.restoreShort}
                </button>
              </li>
            ))}
          </ul>
        </details>
      )}
    </>
  )
}

interface CommandProps {
  readonly label: (name: string) => string
  readonly program: StoredProgram
  readonly act: () => void
  readonly children: VNode
}

function Command({label, program, act, children}: CommandProps): VNode {
  const text = label(shownName(program))
  return (
    <button type="button" class="plain icon" aria-label={text} title={text} onClick={act}>
      {children}
    </button>
  )
}

/// Enter and leaving the field rename, Escape does not (`null`).
function NameField({program, done}: {program: StoredProgram; done: (name: string | null) => void}): VNode {
  const field = useRef<HTMLInputElement>(null)
  const over = useRef(false)
  useLayoutEffect(() => {
    field.current?.focus()
    field.current?.select()
  }, [])
  const end = (name: string | null) => {
    // Leaving is reported once more when the field is removed.
    if (over.current) return
    over.current = true
    done(name)
  }
  return (
    <input
      type="text"
      class="new-name"
      ref={field}
      aria-label={words.myPrograms.newName(shownName(program))}
      defaultValue={program.name}
      maxLength={60}
      spellcheck={false}
      onBlur={event => end(event.currentTarget.value)}
      onKeyDown={event => {
        if (event.key === "Enter") end(event.currentTarget.value)
        if (event.key !== "Escape") return
        // Otherwise the dialog closes.
        event.preventDefault()
        end(null)
      }}
    />
  )
}

/// Workspace units around the blocks.
const margin = 12
/// Width and height of what a picture shows, in workspace units: blocks of a short program are not drawn larger, those of a long one are cut off.
const leastView = {width: 480, height: 300}
const mostView = {width: 1440, height: 900}

function BlockPicture({outlines}: {outlines: readonly Outline[]}): VNode {
  const svg = useRef<SVGSVGElement>(null)
  const shapes = useRef<SVGGElement>(null)
  // A layout effect would measure before the dialog is shown.
  useEffect(() => {
    const box = shapes.current?.getBBox()
    if (box === undefined) return
    const within = (size: number, least: number, most: number) =>
      Math.min(Math.max(size + 2 * margin, least), most)
    const width = within(box.width, leastView.width, mostView.width)
    const height = within(box.height, leastView.height, mostView.height)
    svg.current?.setAttribute("viewBox", `${box.x - margin} ${box.y - margin} ${width} ${height}`)
  }, [outlines])
  return (
    <svg ref={svg} class="block-picture" aria-hidden="true" preserveAspectRatio="xMidYMin meet">
      <g ref={shapes}>
        {outlines.map(({x, y, path, colour}, place) => (
          <path key={place} d={path} fill={colour} transform={`translate(${x} ${y})`} />
        ))}
      </g>
    </svg>
  )
}
