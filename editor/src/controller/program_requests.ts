/// Requests for programs that arrive later: examples, links, and the first program of the page. When the learner has opened another program in the meantime, the answer
/// is dropped.

import {
  addressContains,
  addressFragment,
  exampleInAddress,
  isReload,
  setExampleInAddress,
} from "../browser/browser_window.ts"
import {fetchExample} from "../browser/remote_resources.ts"
import type {LinkedProgram} from "../browser/share_link.ts"
import type {Store} from "../browser/store.ts"
import {awaitsProgram} from "../state/page_state.ts"
import type {ProgramStore} from "../storage/program_store.ts"
import {words} from "../words/index.ts"
import type {PageParts} from "./document/page_parts.ts"
import {openLessonText} from "./lessons/lessons.ts"
import {type Origin, type ProgramLoader, programInAddress} from "./programs/program_loader.ts"
import {linkedProject} from "./programs/sharing.ts"

/// The program of a new learner.
const firstExample = "accelerate"

interface ExampleOptions extends Origin {
  /// Whether the address names the example while it is unchanged.
  readonly inAddress?: boolean
}

/// Origin of the first program: the learner chose it before programs could be read, a link contains it, or another one.
export type FirstProgram = "chosen" | "linked" | "other"

export interface ProgramRequests {
  /// False if the service has no such example.
  openExample(name: string, options?: ExampleOptions): Promise<boolean>
  /// Opens the program or the lesson that a link contains. A damaged link leaves the open program as it is.
  openLink(fragment: string, origin?: Origin): Promise<LinkedProgram["kind"]>
  /// Opens the program of the address, or else the one that was open last, unless the learner has chosen one.
  openFirst(): Promise<FirstProgram>
}

export function programRequests(
  store: Store,
  parts: Pick<PageParts, "reader">,
  loader: ProgramLoader,
  stored: ProgramStore,
): ProgramRequests {
  const {requests} = loader
  const isWantedFor = ({isFirst}: Origin) => (isFirst === true ? requests.isFirstWanted : requests.choose())
  const openExample = async (name: string, {inAddress = true, ...origin}: ExampleOptions = {}) => {
    const isCurrent = isWantedFor(origin)
    const answer = await fetchExample(name)
    if (!isCurrent()) return true
    if (answer.kind === "there") {
      loader.openText(name, answer.value, origin)
      if (inAddress) setExampleInAddress(name)
      return true
    }
    const notice = {kind: "example-missing", name} as const
    // The page's first program was left out for this one.
    if (origin.isFirst !== true && parts.reader !== null && awaitsProgram(store.now)) {
      loader.requests.withdraw()
      await openFirst()
    }
    store.dispatch({kind: "notice", notice})
    return false
  }
  const openLink = async (fragment: string, origin: Origin = {}) => {
    const isCurrent = isWantedFor(origin)
    const linked = await linkedProject(fragment)
    if (!isCurrent()) return linked.kind
    if (linked.kind === "damaged") store.dispatch({kind: "notice", notice: {kind: "damaged-link"}})
    if (linked.kind === "program") {
      loader.openText(words.yourProgram, linked.text, origin)
      addressContains(fragment)
    }
    if (linked.kind === "lesson") {
      const isOpen = openLessonText(store, loader, words.lessons.linked, linked.text, origin)
      if (!isOpen) return "damaged"
    }
    return linked.kind
  }
  const openLast = async () => {
    const last = stored.current()
    if (last !== null)
      loader.openText(words.yourProgram, last.text, {id: last.id, reloaded: true, isFirst: true})
    else {
      const origin = {welcome: true, isFirstVisit: stored.isFirstVisit(), reloaded: true, isFirst: true}
      await openExample(firstExample, {...origin, inAddress: false})
    }
  }
  const openFirst = async (): Promise<FirstProgram> => {
    if (!requests.isFirstWanted()) return "chosen"
    const isChanged = isReload() && stored.left() === programInAddress()
    if (!isChanged) stored.setLeft(null)
    if (isChanged) {
      await openLast()
      return "other"
    }
    const linked = await openLink(addressFragment(), {isFirst: true})
    if (!requests.isFirstWanted()) return "chosen"
    if (linked === "program" || linked === "lesson") return linked === "program" ? "linked" : "other"
    const example = exampleInAddress()
    if (linked === "none" && example === null) {
      await openLast()
      return "other"
    }
    if (example !== null) {
      if (await openExample(example, {reloaded: true, isFirst: true})) return "other"
      if (!requests.isFirstWanted()) return "chosen"
    }
    // The link or the example is missing: the last program is opened, and the notice about the missing one is kept.
    const {notice} = store.now
    await openLast()
    store.dispatch({kind: "notice", notice})
    return "other"
  }
  return {openExample, openLink, openFirst}
}
