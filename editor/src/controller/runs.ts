/// Runs of programs: the effects of state changes, the connection to the service, the keep-alive for real robots, and the access code of the robots.

import {pageVisibility, seedInAddress, watchPageVisibility} from "../browser/browser_window.ts"
import {contentOf, download, fileName, noticeOf, pickFile} from "../browser/local_files.ts"
import {openAccessCode, ownName, setOwnName} from "../browser/preferences.ts"
import {socketAddress} from "../browser/service_address.ts"
import {openConnection} from "../browser/service_connection.ts"
import type {Store} from "../browser/store.ts"
import {judgedSeed} from "../state/lesson_state.ts"
import {lateAfter} from "../state/messages/preview.ts"
import type {PageEvent} from "../state/page_events.ts"
import {awaitsProgram} from "../state/page_state.ts"
import {isDriving} from "../state/robot_ownership.ts"
import type {Effect} from "../state/transition.ts"
import type {Speaker} from "../views/room/sound_synthesis.ts"
import type {Completions} from "./document/completion_requests.ts"
import type {DocumentEditor} from "./document/document_editor.ts"
import type {PageParts} from "./document/page_parts.ts"

/// Milliseconds between the last change and the check by the compiler.
const checkPause = 150

/// Milliseconds between two `alive` messages while the page drives a real robot (protocol §4).
const alivePause = 100

/// Performs the effects of state changes. Of the checks requested while the learner types only the last one is sent.
export function effectHandler(
  parts: PageParts,
  speaker: Speaker,
  dispatch: (event: PageEvent) => void,
): (effect: Effect) => void {
  let checkTimer: ReturnType<typeof setTimeout> | undefined
  return effect => {
    if (effect.kind === "play") speaker.play(effect.sound)
    else if (effect.kind === "pick-world")
      pickFile(".json", async file => {
        const {name} = file
        const content = await contentOf(file)
        if (content.kind === "text") dispatch({kind: "world-file-read", name, text: content.text})
        else dispatch({kind: "notice", notice: noticeOf(name, content)})
      })
    else if (effect.kind === "save-world")
      download(fileName(effect.name, "json"), effect.text, "application/json")
    else if (effect.message.op === "check") {
      clearTimeout(checkTimer)
      checkTimer = setTimeout(() => parts.service?.send(effect.message), checkPause)
    } else {
      const {message} = effect
      parts.service?.send(message)
      if (message.op === "preview")
        setTimeout(() => dispatch({kind: "preview-late", id: message.id}), lateAfter)
    }
  }
}

export function connectService(
  store: Store,
  parts: PageParts,
  completions: Completions,
  openClass: () => void,
): void {
  parts.service = openConnection(() => socketAddress("api/session", window.location), {
    received(message) {
      if (message.op === "hello") parts.seen = 0
      if (message.op === "hello" && message.class === true) openClass()
      if (message.op === "completed") completions.heard(message)
      if (message.op === "seen") {
        parts.seen = message.number
        // Ten times a second: the state of the page does not depend on it.
        return
      }
      store.dispatch({kind: "heard", message})
      // A service takes a new page for one that has the focus.
      const state = pageVisibility()
      if (message.op === "hello" && state !== "focused") parts.service?.send({op: "visibility", state})
    },
    lost: () => store.dispatch({kind: "link-lost"}),
    malformed: message => console.warn(`Rosy's service sent something this page does not know: ${message}`),
  })
  watchPageVisibility(state => parts.service?.send({op: "visibility", state}))
}

/// Real robots drive only while a visible page sends `alive`.
export function sendAlive(store: Store, parts: PageParts): void {
  setInterval(() => {
    if (isDriving(store.now) && document.visibilityState === "visible")
      parts.service?.send({op: "alive", seen: parts.seen})
  }, alivePause)
}

/// Restores the access code and the learner's name, and stores them when they change.
export function storeAccess(store: Store): void {
  const code = openAccessCode(window)
  const known = code.read()
  if (known !== null) store.dispatch({kind: "robots-unlocked", code: known})
  store.onFrame(({robots}) => {
    if (robots.offered?.locked === false || robots.refused !== null) code.keep(robots.code)
    if (robots.who !== ownName()) setOwnName(robots.who)
  })
}

export function runProgram(store: Store, editor: DocumentEditor): void {
  if (awaitsProgram(store.now)) return
  editor.flush()
  store.dispatch({kind: "run-pressed", seed: seedInAddress() ?? judgedSeed(store.now.lessons) ?? newSeed()})
}

/// Seed of a run: any integer that the service accepts (protocol §4).
const newSeed = () => Math.floor(Math.random() * 2 ** 31)
