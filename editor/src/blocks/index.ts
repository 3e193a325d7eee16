/// The block view, for the page: `openBlocks(host, options)`.

export type {Tone} from "./appearance/theme.ts"
export {openBlocks} from "./block_view.ts"
export type {BlocksChange, BlocksOptions, BlocksView, History} from "./block_view_types.ts"
export type {SharedClipboard} from "./interaction/clipboard.ts"
export type {Language} from "./language.ts"
export {sameBlocks} from "./workspace/workspace_merge.ts"
