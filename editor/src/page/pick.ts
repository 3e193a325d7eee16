/// How panels read the page: a panel is drawn again only when what it picked has changed.

import {useComputed} from "@preact/signals"
import {createContext} from "preact"
import {useContext} from "preact/hooks"
import type {PageState} from "../state/page.ts"
import type {Desk} from "./desk.ts"

export const DeskContext = createContext<Desk | null>(null)

export function useDesk(): Desk {
  const desk = useContext(DeskContext)
  if (desk === null) throw new Error("expected a panel inside the page, found none")
  return desk
}

export function usePage<T>(choose: (state: PageState) => T): T {
  const {store} = useDesk()
  return useComputed(() => choose(store.drawn.value)).value
}
