/// The gallery: examples to open, each with what it teaches, and the learner's own programs.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import type {Example} from "../state/page.ts"
import {measures, words} from "../words/index.ts"
import {Dialog} from "./dialog.tsx"
import {useDesk, usePage} from "./pick.ts"
import {Said} from "./said.tsx"

export function GalleryDialog(): VNode {
  return (
    <Dialog name="gallery" title={words.galleryTitle} lead={words.galleryLead}>
      {() => (
        <>
          <Examples />
          <KeptPrograms />
        </>
      )}
    </Dialog>
  )
}

function Examples(): VNode {
  const gallery = usePage(s => s.gallery)
  const desk = useDesk()
  const name = usePage(s => s.name)
  if (gallery.kind === "failed")
    return (
      <p>
        {words.galleryFailed}{" "}
        <button type="button" class="link" onClick={() => desk.openGallery()}>
          {words.again}
        </button>
      </p>
    )
  if (gallery.kind !== "there") return <p class="quiet late">{words.galleryLoading}</p>
  return (
    <ul class="cards">
      {gallery.examples.map(example => (
        <ExampleCard key={example.name} example={example} current={example.name === name} />
      ))}
    </ul>
  )
}

/// The first sentence of what it teaches; the rest when it is asked for.
function ExampleCard({example, current}: {example: Example; current: boolean}): VNode {
  const desk = useDesk()
  const [whole, setWhole] = useState(false)
  const [first = "", ...rest] = example.teaches.split(/(?<=[.!?])\s+/)
  const title = example.title === "" ? example.name : example.title
  return (
    <li class="card" aria-current={current}>
      <button
        type="button"
        class="opens"
        aria-current={current}
        title={whole ? undefined : example.teaches}
        onClick={() => desk.openExample(example.name)}
      >
        <b>{title}</b>
        <span class={whole ? "" : "line"}>
          <Said text={whole ? example.teaches : first} strong={null} />
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

function KeptPrograms(): VNode | null {
  const desk = useDesk()
  const kept = desk.kept()
  if (kept.length === 0) return null
  return (
    <>
      <h3>{words.yourPrograms}</h3>
      <ul class="kept">
        {kept.map(program => (
          <li key={program.id}>
            <button type="button" class="item" onClick={() => desk.openKept(program.id)}>
              <span>{program.name === "" ? words.unnamed : program.name}</span>
              <span class="quiet">{measures.moment(new Date(program.at))}</span>
            </button>
          </li>
        ))}
      </ul>
    </>
  )
}
