/// The gallery: examples to open, each with what it teaches, and the learner's own programs.

import type {VNode} from "preact"
import {useEffect, useRef} from "preact/hooks"
import {CloseIcon} from "./icons.tsx"
import {useDesk, usePage} from "./pick.ts"
import {Said} from "./said.tsx"
import {words} from "./words.ts"

export function GalleryDialog(): VNode | null {
  const desk = useDesk()
  const open = usePage(s => s.dialog === "gallery")
  const dialog = useRef<HTMLDialogElement>(null)
  useEffect(() => {
    if (open) dialog.current?.showModal()
    else dialog.current?.close()
  }, [open])
  const close = () => desk.store.dispatch({kind: "dialog", dialog: null})
  return (
    // A click on the backdrop is a click on the dialog itself; Escape closes it through `onClose`.
    <dialog
      class="gallery"
      ref={dialog}
      aria-labelledby="gallery-title"
      onClose={close}
      onClick={event => event.target === event.currentTarget && close()}
      onKeyDown={event => event.stopPropagation()}
    >
      {open && (
        <div class="gallery-body">
          <header>
            <div>
              <h2 id="gallery-title">{words.galleryTitle}</h2>
              <p class="quiet">{words.galleryLead}</p>
            </div>
            <button type="button" class="plain icon" aria-label={words.close} onClick={close}>
              <CloseIcon />
            </button>
          </header>
          <Examples />
          <KeptPrograms />
        </div>
      )}
    </dialog>
  )
}

function Examples(): VNode {
  const desk = useDesk()
  const gallery = usePage(s => s.gallery)
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
        <li key={example.name}>
          <button
            type="button"
            class="card"
            aria-current={example.name === name}
            onClick={() => desk.openExample(example.name)}
          >
            <b>{example.title === "" ? example.name : example.title}</b>
            {example.title !== "" && example.title !== example.name && <code>{example.name}</code>}
            <span>
              <Said text={example.teaches} strong={null} />
            </span>
          </button>
        </li>
      ))}
    </ul>
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
              <span class="quiet">
                {new Date(program.at).toLocaleString(undefined, {dateStyle: "medium", timeStyle: "short"})}
              </span>
            </button>
          </li>
        ))}
      </ul>
    </>
  )
}
