/// Connection of the toolbox with the program: names in scope, what fits the chosen place, and what the search finds.

import type {Level, Place, SavedBlock, ToolboxItem} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import type {Language} from "../construction/language.ts"
import {saveBlocks} from "../workspace/serialization.ts"
import {
  chosenNode,
  nameItem,
  scopeItems,
  selectedPlace,
  selectedPlaces,
  suggest,
  takes,
} from "./insertion_points.ts"
import {scopeKey, setToolboxContext} from "./toolbox.ts"

export interface ToolboxActions {
  level(): Level
  setLevel(level: Level): void
  /// Puts a block into the chosen place, or beside the others. `thenNext`: then chooses the next empty place; answers whether there is one.
  put(block: SavedBlock, thenNext: boolean): boolean
}

/// Gives the toolbox of a workspace what it asks for. `language` may have another toolbox each time it is asked.
export function connectToolbox(
  workspace: Blockly.WorkspaceSvg,
  language: Language,
  session: ReturnType<Language["session"]>,
  actions: ToolboxActions,
): void {
  const views = new Map(language.blockTypes.map(view => [view.type, view]))
  const sortOf = ({block}: ToolboxItem) =>
    views.get(block.type)?.shape(block.extraState ?? {}).connects.as ?? ""
  const namesAt = (place: Place | undefined) =>
    place === undefined ? undefined : session.namesInScope(saveBlocks(workspace), place)

  workspace.registerToolboxCategoryCallback(scopeKey, () => scopeItems(namesAt(selectedPlace(workspace))))
  setToolboxContext(workspace, {
    ...actions,
    names: () => (namesAt(selectedPlace(workspace)) ?? []).map(nameItem),
    typed: query => language.typedItems(query),
    fitting() {
      const places = selectedPlaces(workspace)
      if (places.length === 0) return undefined
      const check = session.checker(saveBlocks(workspace))
      // What stands alone has its place on the workspace.
      const alone = new Set(["top", "definition"])
      const [first, ...others] = places
      const fits = (place: Place | undefined, item: ToolboxItem) =>
        place !== undefined && takes(check, place, item.block)
      return item =>
        fits(first, item)
          ? "here"
          : others.some(place => fits(place, item))
            ? "near"
            : alone.has(sortOf(item))
              ? "alone"
              : "nowhere"
    },
    placeName() {
      const node = chosenNode(workspace)
      const place = node instanceof Blockly.RenderedConnection ? node.getFocusableElement() : undefined
      const name = place?.getAttribute("aria-label")
      return name ? `${name}.` : ""
    },
    suggestions() {
      const place = selectedPlace(workspace)
      return place && suggest(session, saveBlocks(workspace), place, language.toolbox(actions.level()))
    },
  })
}
