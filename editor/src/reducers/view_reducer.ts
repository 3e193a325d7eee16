/// Reducer for the view: regions, dialogs, galleries, and the learner's settings. Its events send nothing. Pure.

import {withView} from "../state/arrangement.ts"
import {withOffered} from "../state/messages/fix_previews.ts"
import {latePreview} from "../state/messages/preview.ts"
import type {ViewEvent} from "../state/page_events.ts"
import type {PageState} from "../state/page_state.ts"
import {unreachable} from "../state/transition.ts"

/// Applies a change of what the page shows.
export function reduceViewEvent(state: PageState, event: ViewEvent): PageState {
  switch (event.kind) {
    case "held":
      return {...state, room: {...state.room, held: event.thing}}
    case "charted":
      return {...state, charts: event.quantities}
    case "chart-span":
      return {...state, chartSpan: event.span}
    case "selected":
      return {...state, selected: event.block, selectedIn: event.in, cursor: event.at ?? null}
    case "rooms-read":
      return {...state, rooms: event.rooms}
    case "worlds-listed":
      return {...state, worlds: event.worlds}
    case "gallery":
      return {...state, gallery: event.gallery}
    case "dialog":
      return {...state, dialog: event.dialog}
    case "shared":
      return {...state, shared: event.shared}
    case "notice":
      return {...state, notice: event.notice}
    case "view":
      return {...state, arrangement: withView(state.arrangement, event.view)}
    case "diagram": {
      const {chosen} = state.diagram
      const stays = event.nodes?.some(({kind, key}) => kind === chosen?.kind && key === chosen.key) ?? false
      return {
        ...state,
        diagram: {
          ...state.diagram,
          outcome: event.outcome,
          drawings: state.diagram.drawings + 1,
          chosen: stays ? chosen : null,
        },
      }
    }
    case "node-chosen":
      return {...state, diagram: {...state.diagram, chosen: event.node}}
    case "arranged":
      return {...state, arrangement: event.arrangement, arranging: null}
    case "arranging":
      return {...state, arranging: event.arranging}
    case "region":
      return {...state, region: event.region}
    case "size":
      return {...state, size: event.size}
    case "tab":
      return {...state, tab: event.tab}
    case "theme":
      return {...state, theme: event.theme}
    case "layout":
      return {...state, layout: event.layout}
    case "muted":
      return {...state, muted: event.muted}
    case "trail":
      return {...state, trail: event.trail}
    case "all-events":
      return {...state, allEvents: event.allEvents}
    case "welcoming":
      return {...state, welcoming: event.welcoming}
    case "demonstration":
      return {...state, demonstration: event.step}
    case "fixes-offered":
      return {...state, offeredFixes: withOffered(state.offeredFixes, event.offered)}
    case "preview-late":
      return {...state, room: {...state.room, preview: latePreview(state.room.preview, event.id)}}
    case "previewing":
      return {...state, previewing: event.previewing}
    case "follows":
      return {...state, follows: event.follows}
    case "block-comments":
      return {...state, blockComments: event.comments}
    case "film":
      return {...state, film: event.film}
    default:
      return unreachable(event)
  }
}
