/// Files that the learner opens: recordings of runs go to the service, which reads them; of a folder or an archive one program is opened, and anything
/// else is a program or a room.

import {contentOf, pickFile} from "../../browser/local_files.ts"
import {type Collection, collectArchive, collectEntries} from "../../browser/program_collection.ts"
import {type Ask, serviceAddress} from "../../browser/service_address.ts"
import type {Store} from "../../browser/store.ts"
import type {Notice} from "../../state/page_state.ts"
import type {AppController} from "../../ui/app_context.ts"
import {decode, object, optional, parseJson, string} from "../../wire/decode.ts"
import {sentence} from "../../wire/problem.generated.ts"
import {words} from "../../words/index.ts"
import {worded} from "../../words/worker_sentences.ts"
import type {ProgramLoader} from "./program_loader.ts"

/// Bytes of a recording that the service takes (protocol §4): two hours of driving.
export const mostRecordingBytes = 50_000_000

type RecordingCommands = Pick<AppController, "openFile" | "openRecording">

export interface FileOpening extends RecordingCommands {
  /// A file from the learner's disk, however it came.
  opened(file: File): void
  /// A folder, or several files and folders, that were dropped together.
  openedFolder(entries: readonly FileSystemEntry[]): void
}

export function fileOpening(store: Store, loader: Pick<ProgramLoader, "openFile">): FileOpening {
  const opened = async (file: File) => {
    if (/\.mcap$/i.test(file.name)) await sendRecording(store, file)
    else if (/\.zip$/i.test(file.name)) openCollection(file.name, await collectArchive(file))
    else loader.openFile(file.name, await contentOf(file))
  }
  const notify = (notice: Notice) => store.dispatch({kind: "notice", notice})
  const openCollection = (name: string, collection: Collection) => {
    if (collection.kind === "too-much") return notify({kind: "too-many-files", name})
    if (collection.kind === "damaged") return notify({kind: "damaged-archive", name})
    const {files: programs, unread} = collection
    const [first, ...others] = programs
    if (first === undefined) notify({kind: "no-programs", name})
    else if (others.length === 0 && unread === 0) loader.openFile(first.name, first.content)
    else notify({kind: "several-programs", name, programs, unread})
  }
  return {
    opened,
    async openedFolder(entries) {
      openCollection(
        entries.map(entry => entry.name.normalize("NFC")).join(", "),
        await collectEntries(entries),
      )
    },
    openFile: () => pickFile(".rosy,.json,.hs,.lhs,.zip,.mcap", opened),
    openRecording: () => pickFile(".mcap", file => void sendRecording(store, file)),
  }
}

const failure = object(get => ({
  message: get("message", string),
  sentence: get("sentence", optional(sentence, null)),
}))

/// What a service answers to a file.
type Post = (address: string, content: Blob) => Promise<{readonly ok: boolean; text(): Promise<string>}>

const post: Post = (address, content) =>
  fetch(address, {method: "POST", body: content, headers: {"Content-Type": "application/octet-stream"}})

/// Sends a recording to the service, and then asks to see it.
export async function sendRecording(
  store: Pick<Store, "now" | "dispatch">,
  file: Pick<File, "name" | "size"> & Blob,
  send: Post = post,
  ask?: Ask,
): Promise<void> {
  const refuse = (message: string) =>
    store.dispatch({kind: "notice", notice: {kind: "refusal", message, hint: ""}})
  if (file.size > mostRecordingBytes) return refuse(words.recordings.tooLarge(file.name))
  const {session} = store.now
  const path = `api/recordings/${session}?name=${encodeURIComponent(file.name)}`
  const address = session === null ? null : await serviceAddress(path, window.location, ask)
  if (address === null) return refuse(words.recordings.notConnected)
  const why = await answerTo(send(address, file))
  if (why === null) store.dispatch({kind: "recording-wanted", of: null})
  else refuse(why === "" ? words.recordings.notSent(file.name) : why)
}

/// Why the service did not take it; empty when it did not say, `null` when it took it.
async function answerTo(answering: ReturnType<Post>): Promise<string | null> {
  try {
    const answer = await answering
    if (answer.ok) return null
    const said = decode(failure, parseJson(await answer.text()))
    return said.kind === "ok" ? worded(said.value.sentence, said.value.message) : ""
  } catch (fault) {
    // `fetch` rejects with a TypeError when the service cannot be reached, and for nothing else.
    if (fault instanceof TypeError) return ""
    throw fault
  }
}
