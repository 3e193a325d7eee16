/// Made by `plugins/film_player.ts`.
declare module "virtual:film-player" {
  export const script: string
  /// SHA-256 of the script in base64.
  export const hash: string
}
