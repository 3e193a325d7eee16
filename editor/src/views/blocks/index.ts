/// The block view, for the page: `openBlocks(host, options)`.

export {openBlocks} from "./block_view.ts"
export type {BlocksChange, BlocksOptions, BlocksView, History} from "./block_view_types.ts"
export type {Language} from "./construction/language.ts"
export type {Tone} from "./construction/theme.ts"
export type {SharedClipboard} from "./interaction/clipboard.ts"
export {sameBlocks} from "./workspace/workspace_merge.ts"
