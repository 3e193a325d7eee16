/// The block view, for the page: `openBlocks(host, options)`.

export type {SharedClipboard} from "./copied.ts"
export type {Tone} from "./families.ts"
export type {Language} from "./language.ts"
export {sameBlocks} from "./order.ts"
export type {BlocksChange, BlocksOptions, BlocksView, History} from "./view.ts"
export {openBlocks} from "./view.ts"
