/// Tables of every language besides English, for what holds in each of them.

import type {Table} from "../src/words/language_table.ts"

export const translations: readonly Table[] = Object.values(
  import.meta.glob<Table>(["../../languages/*/page/index.ts", "!../../languages/en/**"], {
    import: "table",
    eager: true,
  }),
)
