/// The learner's programs in this browser: open, rename, duplicate, delete and restore. The program that is open on the page stays consistent with its entry in the store.

import {parseProject, saveProject} from "@rosy/codegen"
import {readBlockPicture} from "../../browser/block_picture.ts"
import type {Store} from "../../browser/store.ts"
import type {ProgramStore} from "../../storage/program_store.ts"
import type {AppController, MyPrograms} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {freshName, freshPlace} from "./autosave.ts"
import type {ProgramLoader} from "./program_loader.ts"
import {followStoredPrograms} from "./stored_companions.ts"

type MyProgramCommands = Pick<AppController, "openMyPrograms" | "myPrograms">

export function myProgramCommands(
  store: Store,
  loader: ProgramLoader,
  programStore: ProgramStore,
): MyProgramCommands {
  return {
    openMyPrograms() {
      loader.store()
      store.dispatch({kind: "dialog", dialog: "programs"})
    },
    myPrograms: openMyPrograms(store, loader, programStore),
  }
}

function openMyPrograms(store: Store, loader: ProgramLoader, programStore: ProgramStore): MyPrograms {
  const isOpen = (id: string) => loader.storedId() === id
  const haskell = (id: string) => {
    const parsed = parseProject(programStore.read(id) ?? "")
    return parsed.ok ? parsed.project.haskell : null
  }
  followStoredPrograms(store, haskell)
  const nameOf = (id: string) => programStore.programs().find(program => program.id === id)?.name ?? ""
  return {
    list: programStore.programs,
    deleted: programStore.deleted,
    picture: id => readBlockPicture(programStore.picture(id)),
    isOpen,
    haskell,
    open(id) {
      const text = programStore.read(id)
      if (text !== null) loader.openText(words.yourProgram, text, {id})
    },
    rename(id, name) {
      if (isOpen(id)) {
        store.dispatch({kind: "renamed", name})
        loader.store()
        return
      }
      const text = programStore.read(id)
      if (text !== null) programStore.rename(id, name, renamed(text, name))
    },
    duplicate(id) {
      if (isOpen(id)) loader.store()
      const text = programStore.read(id)
      if (text === null) return
      const name = freshName(nameOf(id), programStore.programs())
      const copy = freshPlace()
      programStore.insert(copy, name, renamed(text, name), Date.now())
      const picture = programStore.picture(id)
      if (picture !== null) programStore.setPicture(copy, picture)
      programStore.setReplacedRoom(copy, programStore.replacedRoom(id))
    },
    remove(id) {
      if (isOpen(id)) {
        // A new program takes the place of the open one, which is stored once more before it is closed.
        loader.newProgram()
        store.dispatch({kind: "dialog", dialog: "programs"})
      }
      programStore.remove(id, Date.now())
    },
    restore: programStore.restore,
  }
}

/// A project file with another name; a file that cannot be read stays as it is.
function renamed(text: string, name: string): string {
  const parsed = parseProject(text)
  return parsed.ok ? saveProject({...parsed.project, name}) : text
}
