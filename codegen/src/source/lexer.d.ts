export interface Range {
    readonly start: number;
    readonly end: number;
}
export type TokenKind = "keyword" | "type" | "name" | "number" | "string" | "comment" | "operator" | "hole" | "pragma";
export interface Token extends Range {
    readonly kind: TokenKind;
}
export declare function isSymbol(text: string): boolean;
export declare function tokens(text: string): readonly Token[];
export declare function tokensAfter(old: readonly Token[], text: string, { from, to, shift }: {
    readonly from: number;
    readonly to: number;
    readonly shift: number;
}): readonly Token[];
export declare function firstWith<A>(all: readonly A[], is: (item: A) => boolean): number;
export declare function tokenAt(text: string, from: number): Token | null;
export declare function isClosed(text: string, { start, end }: Range): boolean;
